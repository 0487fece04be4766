// SPDX-License-Identifier: MIT
//
// A flat word: text in, triangles out, in plain vectors.
//
//     01_flat_word FONT [TEXT]        writes flat_word.obj, which any 3D program opens

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <vector>

struct vertex {
    float x, y;
};

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position.x, s.position.y}; }
};

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 01_flat_word FONT [TEXT]"), 2;

    auto font = typemesh::harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    auto mesher = typemesh::text_mesher{*font}.with(typemesh::flat{});
    std::vector<vertex> vertices;
    std::vector<std::uint16_t> indices;
    auto made = mesher.build(argc > 2 ? argv[2] : "Hello world!", typemesh::into(vertices, indices));
    if (!made) return std::puts(made.error().message()), 1;

    std::FILE* file = std::fopen("flat_word.obj", "w");
    if (file == nullptr) return std::puts("flat_word.obj cannot be written: check the current folder"), 1;
    for (const vertex& v : vertices) std::fprintf(file, "v %g %g 0\n", double(v.x), double(v.y));
    for (std::size_t i = 0; i < indices.size(); i += 3)
        std::fprintf(file, "f %d %d %d\n", indices[i] + 1, indices[i + 1] + 1, indices[i + 2] + 1);
    const bool kept = std::ferror(file) == 0;
    if (std::fclose(file) != 0 || !kept)
        return std::puts("flat_word.obj could not be written to its end: check the free space on the disk"), 1;
    std::printf("%u glyphs, %zu vertices, %zu triangles\n", made->glyphs, vertices.size(), indices.size() / 3);
}
