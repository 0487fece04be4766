// SPDX-License-Identifier: MIT
//
// An extruded word with everything a renderer needs: normals, texture coordinates, exact sizes before anything is
// written, one range of indices for each material.
//
//     02_extruded_word FONT [TEXT]

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <vector>

struct vertex {
    typemesh::vec3 position, normal;
    typemesh::vec2 uv;
};

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 2) return std::puts("usage: 02_extruded_word FONT [TEXT]"), 2;

    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    auto mesher = text_mesher{*font}.with(extruded<>{.depth = 0.3f});
    auto plan =
        mesher.plan(argc > 2 ? argv[2] : "Hello world!", {.tolerance = quality::high, .frame = left_handed_y_up});
    if (!plan) return std::puts(plan.error().message()), 1;

    // The sizes are exact: this could be a mapped GPU buffer just as well. It is written once, ascending, and never
    // read.
    std::vector<vertex> vertices(plan->size().vertices);
    std::vector<std::uint32_t> indices(plan->size().indices());
    if (const auto written = plan->write(into(std::span{vertices}, std::span{indices})); !written)
        return std::puts(written.error().message()), 1;

    const char* names[] = {"front", "back", "side"};
    for (const part p : plan->parts()) {
        const mesh_range r = plan->range(p);
        std::printf("%-5s  indices %6u + %6u    vertices %6u + %6u\n", names[int(p)], r.first_index, r.index_count,
                    r.first_vertex, r.vertex_count);
    }
    const bounds3 b = plan->bounds();
    std::printf("from (%g, %g, %g) to (%g, %g, %g) em\n", double(b.low.x), double(b.low.y), double(b.low.z),
                double(b.high.x), double(b.high.y), double(b.high.z));
    if (!plan->report().complete())
        std::printf("%u glyphs refused, %u missing\n", plan->report().refused, plan->report().missing);
}
