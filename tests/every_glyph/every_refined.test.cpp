// SPDX-License-Identifier: MIT
//
// Refined solids of a few glyphs of the smoke fonts; the program every_refined takes all of them.

#include "refined_laws.hpp"
#include "support/catch.hpp"
#include "support/smoke_glyphs.hpp"

#include <cstddef>
#include <string>

using namespace typemesh;

TEST_CASE("every 40000th glyph of the smoke fonts makes valid refined solids, alone and merged",
          "[every_glyph][refined]")
{
    test::refined_laws laws;
    test::refined_findings all;
    test::each_smoke_glyph(40'000, [&](auto& font, glyph_id g, const std::string& name) {
        for (const bool merged : {false, true}) {
            if (!laws.take(font, g, quality::normal, merged)) continue;
            INFO(name << (merged ? ", merged" : ""));
            for (const float size : {laws.sizes[0], laws.sizes[1]})
                for (const auto& f :
                     {laws.examine_delaunay(size), laws.examine_quadtree(size), laws.examine_non_obtuse(size)}) {
                    CHECK(f.wrong == "");
                    all.add(f);
                }
        }
    });
    CAPTURE(all.caps, all.triangles, all.small, all.crowded, all.small_in_bevels);
    CHECK(all.caps > 50);
    CHECK(all.solids > 300);
    CHECK(all.small == 0);
    CHECK(1000 * (all.crowded + all.small_in_bevels) <= all.triangles);
    CHECK(all.wide == 0);
    CHECK(all.wide_in_bevels == 0);
    CHECK(1000 * (all.wide_crowded + all.wide_at_slopes) <= all.triangles);
    CHECK(all.long_edges == 0);
    CHECK(all.area_off <= 1.0);
}
