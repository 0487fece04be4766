// SPDX-License-Identifier: MIT
//
// Your vertex, your encoding: a writer with state packs a normal into 32 bits and adds a colour. Only what it `wants`
// is computed.
//
//     03_own_vertex FONT

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <vector>

namespace engine {

struct vertex {  // 20 bytes
    float position[3];
    std::uint32_t normal;  // 10 bits per component, signed
    std::uint32_t colour;  // RGBA
};

struct writer {
    static constexpr auto wants = typemesh::attribute::position | typemesh::attribute::normal;
    std::uint32_t colour = 0xFFFFFFFF;

    vertex operator()(const typemesh::surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, pack(s.normal), colour};
    }

private:
    static std::uint32_t pack(typemesh::vec3 n) noexcept
    {
        const auto bits = [](float v) {
            return static_cast<std::uint32_t>(static_cast<int>(v * 511.0f + (v < 0 ? -0.5f : 0.5f))) & 0x3FFu;
        };
        return bits(n.x) | bits(n.y) << 10 | bits(n.z) << 20;
    }
};
static_assert(typemesh::vertex_writer<writer>);

}  // namespace engine

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 03_own_vertex FONT"), 2;
    auto font = typemesh::harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    typemesh::text_mesher mesher{*font};
    std::vector<engine::vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto made = mesher.build("red", typemesh::into(vertices, indices, engine::writer{0xFF0000FF}));
    if (!made) return std::puts(made.error().message()), 1;
    if (vertices.empty()) return std::puts("The font has none of these letters: give another font."), 1;

    std::printf("%zu vertices of %zu bytes, the first normal is 0x%08x\n", vertices.size(), sizeof(engine::vertex),
                vertices[0].normal);
}
