// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts, filled and given back as curves.

#include "support/catch.hpp"
#include "support/redrawn_glyph.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/outline/outline_recorder.hpp>

#include <cstddef>
#include <cstdint>

using namespace typemesh;

TEST_CASE("every smoke font's filled boundary is curves again, and they fill what the font's own fill", "[workload]")
{
    test::redrawn_glyph again;
    outline curves;
    std::size_t glyphs = 0, meetings = 0, straight = 0, before = 0, after = 0;
    test::each_smoke_glyph(499, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        INFO(name);
        if (!record(font, glyph, curves) || curves.curves.empty()) return;
        for (const double tolerance : {1.0 / 100, 1.0 / 800}) {
            INFO("tolerance " << tolerance);
            REQUIRE(again.make(curves, font.units_per_em(), tolerance) == error::none);
            CHECK(again.broken_again(4.0) == "");  // in 63,916 glyphs, 64 are beyond 2 tolerances, none beyond 3.9
            meetings += again.found().meetings();
            straight += again.found().straight_edges();
        }
        CHECK(again.wrong_places(curves, 60, again.filled.tolerance() + 4.0, glyphs) == 0);
        ++glyphs;
        before += curves.curves.size();
        after += again.drawn.curves.size();
    });
    CAPTURE(glyphs, meetings, straight, before, after);
    CHECK(glyphs > 100);
    CHECK(meetings > 100);
    CHECK(100 * straight < glyphs);  // in 63,916 glyphs, 406 edges
    CHECK(after < before + before / 4);
}
