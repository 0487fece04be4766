// SPDX-License-Identifier: MIT
//
// Fonts whose units per em are no power of two: no cell of the grid is a float there. Within two em of the origin no
// triangle may turn over or go flat in the floats that are written.

#include "opened_font.hpp"
#include "support/font_file.hpp"

using namespace typemesh;

namespace {

std::uint64_t flipped(const harfbuzz_font& font, auto& mesher, glyph_id id, point em, double tolerance)
{
    glyph_run run;
    run.units_per_em = font.units_per_em();
    placed_glyph g;
    g.id = id;
    g.origin = font.units_per_em() * em;
    REQUIRE(run.glyphs.push_back(g));
    const auto plan = mesher.plan(run, {.tolerance = tolerance});
    REQUIRE(plan);
    return flipped_triangles(*plan);
}

}  // namespace

TEST_CASE("no triangle within two em of the origin is turned over by rounding to floats", "[workload]")
{
    const auto check = [](const std::string& path, float weight) {
        const variation w[] = {{"wght", weight}};
        const std::span<const variation> place{w, weight != 0.0f ? std::size_t{1} : std::size_t{0}};
        auto font = test::opened(path, {.variations = place});
        text_mesher by_sweep{font};
        auto delaunay = text_mesher{font}.with(constrained_delaunay{});
        for (glyph_id id = 6; id < font.glyph_count(); id += 7)
            for (const point em : {point{0, 0}, point{1.11, 0.03}, point{0.37, 1.21}, point{2, 2}}) {
                INFO(path << ", weight " << weight << ", glyph " << id << " at " << em.x << ", " << em.y);
                CHECK(flipped(font, by_sweep, id, em, quality::low) == 0);
                if (em == point{}) CHECK(flipped(font, delaunay, id, em, quality::low) == 0);
            }
    };
    const std::string inter = font_file("truetype/inter-vf/Inter-italic.var.ttf");
    for (const float weight : {100.0f, 300.0f, 637.5f, 900.0f}) check(inter, weight);
    check(font_file("opentype/comic-neue/ComicNeue-Regular.otf"), 0.0f);
}
