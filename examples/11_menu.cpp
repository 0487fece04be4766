// SPDX-License-Identifier: MIT
//
// A menu chooses font, triangulator and solid while the program runs. The mesher has one type, and a class could hold it.
//
//     11_menu TEXT FONT...

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 3) return std::puts("usage: 11_menu TEXT FONT..."), 2;
    std::vector<harfbuzz_font> fonts;
    for (int i = 2; i < argc; ++i) {
        auto font = harfbuzz_font::open(argv[i]);
        if (!font) return std::printf("%s: %s\n", argv[i], font.error().message()), 1;
        fonts.push_back(std::move(*font));
    }

    text_mesher<one_of<flat, extruded<>, bevelled>> mesher{fonts.front()};
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    std::puts("f flat  e extruded  b bevelled  m monotone  d Delaunay  1 to 9 font  q quit");
    for (int choice = std::getchar(); choice != EOF && choice != 'q'; choice = std::getchar()) {
        switch (choice) {
        case 'f': mesher.use(flat{}); break;
        case 'e': mesher.use(extruded<>{.depth = 0.3f}); break;
        case 'b': mesher.use(bevelled{.width = 0.03f}); break;
        case 'm': mesher.use(monotone{}); break;
        case 'd': mesher.use(constrained_delaunay{}); break;
        default:
            if (choice <= '0' || choice > '0' + argc - 2) continue;
            mesher.use(fonts[static_cast<std::size_t>(choice - '1')]);
        }
        auto made = mesher.build(
            argv[1],
            into(positions, indices, [](const surface_point<attribute::position>& s) noexcept { return s.position; }));
        if (!made) return std::puts(made.error().message()), 1;
        std::printf("%c: %zu vertices, %zu triangles\n", choice, positions.size(), indices.size() / 3);
    }
}
