// SPDX-License-Identifier: MIT
//
// Cuts the layers of every colour glyph of a font: usage: every_colour_glyph FONT [FIRST STEP COUNT]
// Without numbers it checks that the areas of the visible layers add up to the silhouette, as integers, and prints what it
// has seen. With them it prints the area of each visible layer, as colour_areas.mjs prints them.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/harfbuzz_colours.hpp>
#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/colour/read_colour_glyph.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace typemesh;

struct totals {
    unsigned glyphs = 0, layers = 0, empty = 0, refused = 0, wrong = 0, blended = 0, translucent = 0, unbounded = 0;
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 5) return std::puts("usage: every_colour_glyph FONT [FIRST STEP COUNT]"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    const auto tables = harfbuzz_colours::of(*font);
    if (!tables) return std::puts(tables.error().message()), 1;
    const bool prints = argc == 5;
    const auto number = [&](int i) { return static_cast<std::uint32_t>(std::strtoul(argv[i], nullptr, 10)); };
    const std::uint32_t first = prints ? number(2) : 0, step = prints ? number(3) : 1,
                        most = prints ? number(4) : 65536;
    totals seen;
    colour_glyph glyph;
    layer_regions regions;
    contours loops;
    for (glyph_id id = first; id < font->glyph_count() && seen.glyphs < most; id += step) {
        const auto found = read_colour_glyph(tables->tables(), id, {}, glyph);
        if (found && !*found) continue;
        ++seen.glyphs;
        const auto built =
            !found ? result<void>{found.error()}
                   : regions.build(*font, 0, glyph, prints ? quality::best / 16 : quality::normal, layer_cut::visible);
        if (!built) {
            ++seen.refused;
            std::fprintf(stderr, "glyph %u: %s\n", id, built.error().message());
            continue;
        }
        std::int64_t sum = 0;
        std::vector<double> areas(glyph.layers.size(), 0.0);
        for (std::size_t i = 0; i < regions.layer_count(); ++i) {
            const auto layer = regions.layer(i, loops);
            const std::int64_t area = layer ? inspect::doubled_area(*layer) : 0;
            const double cells = loops.grid.cells;
            sum += area;
            if (area != 0) areas[regions.number_in_glyph(i)] += static_cast<double>(area) / 2.0 / cells / cells;
        }
        if (prints) std::printf("%u", id);
        for (const double area : areas) {
            seen.empty += area > 0.0 ? 0u : 1u;
            if (prints) std::printf(" %.1f", area);
        }
        if (prints) std::puts("");
        const auto whole = regions.silhouette(loops);
        if (!whole || sum != inspect::doubled_area(*whole)) {
            ++seen.wrong;
            std::fprintf(stderr, "glyph %u: its layers are not its silhouette\n", id);
        }
        seen.layers += static_cast<unsigned>(regions.layer_count());
        seen.blended += glyph.blended != 0 ? 1u : 0u;
        seen.translucent += glyph.translucent != 0 ? 1u : 0u;
        seen.unbounded += glyph.unbounded != 0 ? 1u : 0u;
    }
    std::fprintf(stderr, "%u coloured glyphs, %u layers (%u of them hidden), %u refused, %u wrong; ", seen.glyphs,
                 seen.layers, seen.empty, seen.refused, seen.wrong);
    std::fprintf(stderr, "%u mix colours, %u are cut by translucent paints, %u lack layers\n", seen.blended,
                 seen.translucent, seen.unbounded);
    return seen.refused + seen.wrong == 0 ? 0 : 1;
}
