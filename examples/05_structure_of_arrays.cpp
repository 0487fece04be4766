// SPDX-License-Identifier: MIT
//
// One array for each attribute, as many engines keep them, and 16-bit indices. The arrays may lie anywhere and at any
// stride.
//
//     05_structure_of_arrays FONT

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <vector>

struct float3 {
    float x, y, z;
};
struct float2 {
    float u, v;
};

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 2) return std::puts("usage: 05_structure_of_arrays FONT"), 2;

    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    text_mesher mesher{*font};
    auto plan = mesher.plan("arrays", {.tolerance = quality::normal});
    if (!plan) return std::puts(plan.error().message()), 1;

    const auto size = plan->size();
    std::vector<float3> positions(size.vertices), normals(size.vertices);
    std::vector<float2> uvs(size.vertices);
    std::vector<std::uint16_t> indices(size.indices());

    stream_sink sink{std::span{indices}, stream<attribute::position, float3>{positions},
                     stream<attribute::normal, float3>{normals}, stream<attribute::uv, float2>{uvs}};
    if (const auto written = plan->write(sink); !written)
        return std::puts(written.error().message()), 1;  // error::index_overflow past 65,535 vertices

    std::printf("%zu vertices in three arrays, %zu indices of 16 bits\n", positions.size(), indices.size());
}
