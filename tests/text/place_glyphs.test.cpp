// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <random>
#include <vector>

using namespace typemesh;

TEST_CASE("a glyph keeps its line and its place whatever its style, beside lines without glyphs", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        std::mt19937 random{seed};
        const std::uint32_t styles = seed % 3 == 0 ? 1 : 4;
        glyph_run run;
        for (std::uint32_t s = 0; s < styles; ++s) REQUIRE(run.looks.push_back({.style = style_id{s}}));
        std::vector<std::uint32_t> line_of;
        const auto lines = static_cast<std::uint32_t>(random() % 12);
        for (std::uint32_t line = 0; line < lines; ++line) {
            const auto count = static_cast<std::uint32_t>(random() % 4);
            REQUIRE(run.lines.push_back({static_cast<std::uint32_t>(run.glyphs.size()), count, {}, 0.0}));
            for (std::uint32_t i = 0; i < count; ++i) {
                const double x = 600.0 * static_cast<double>(run.glyphs.size());
                REQUIRE(
                    run.glyphs.push_back({1, line, {x, 0.0}, false, static_cast<std::uint32_t>(random() % styles)}));
            }
        }
        const auto plan = mesher.plan(run);
        REQUIRE(plan);
        REQUIRE(plan->glyphs().size() == run.glyphs.size());
        for (const drawn_glyph& g : plan->glyphs()) {
            CHECK(g.line == run.glyphs[g.glyph].cluster);
            CHECK(g.origin == run.glyphs[g.glyph].origin);
        }
    }
}

TEST_CASE("what stands too far away is refused, each glyph for itself", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    for (const double x : {0.0, 0x1p81, -0x1p81, 600.0}) REQUIRE(run.glyphs.push_back({1, 0, {x, 0.0}}));
    const auto plan = mesher.plan(run);
    REQUIRE(plan);
    CHECK(plan->glyphs().size() == 2);
    CHECK(plan->report().refused == 2);
    CHECK(plan->report().first_refusal == error::outline_beyond_grid);
}
