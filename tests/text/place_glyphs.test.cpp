// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/required.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/extrude/flat.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

using namespace typemesh;

namespace {

/// Says of letters with many points that they are narrowed and have lost two caps: of 'o', 'E' and 'x', but not of 'i'.
struct narrowing : flat {
    [[nodiscard]] result<solid_plan> plan(const region& r) const noexcept
    {
        const auto sizes = flat::plan(r);
        if (!sizes) return sizes.error();
        const bool is_large = r.points().size() > 4;
        return solid_plan{.sizes = *sizes,
                          .narrowed = is_large,
                          .lost_caps = is_large ? 2u : 0u,
                          .kept_triangles = is_large ? 5u : 0u};
    }
};
static_assert(extruder<narrowing>);

}  // namespace

TEST_CASE("a glyph keeps its line and its place whatever its style, beside lines without glyphs", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        std::mt19937 random{seed};
        const std::uint32_t styles = seed % 3 == 0 ? 1 : 4;
        glyph_run run;
        for (std::uint32_t s = 0; s < styles; ++s) REQUIRE(run.glyph_styles.push_back({.style = style_id{s}}));
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
        const auto plan = test::required(mesher.plan(run));
        REQUIRE(plan->glyphs().size() == run.glyphs.size());
        for (const drawn_glyph& g : plan->glyphs()) {
            CHECK(g.line == run.glyphs[g.glyph].cluster);
            CHECK(g.origin == run.glyphs[g.glyph].origin);
        }
    }
}

TEST_CASE("glyphs that stand too far away are refused, and the others are drawn", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run = test::row_of(1, {0.0, 0x1p81, -0x1p81, 600.0});
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->glyphs().size() == 2);
    CHECK(plan->report().refused == 2);
    CHECK(plan->report().first_refusal == error::outline_beyond_grid);
}

TEST_CASE("what an extruder narrows is counted glyph by glyph, whichever way the glyph comes", "[text]")
{
    constexpr const char* narrow = "i Eio~E";
    const auto check = [](const auto& plan) {
        REQUIRE(plan);
        CHECK(plan->report().narrowed == 3);
        CHECK(plan->report().first_narrowed == 2);
        CHECK(plan->report().lost_caps == 6);
        CHECK(plan->report().first_lost_cap == 2);
        CHECK(plan->report().kept_triangles == 15);
        CHECK(plan->report().first_kept_triangle == 2);
        std::uint32_t found = 0;
        for (const drawn_glyph& g : plan->glyphs()) found += g.built->is_narrowed() ? 1u : 0u;
        CHECK(found == 3);
    };
    test::toy_font font;
    auto mesher = text_mesher{font}.with(narrowing{});
    check(mesher.plan(narrow));
    check(mesher.plan(narrow, {.reuse = false}));
    check(mesher.plan(narrow, {.merge = true}));  // none meet

    glyph_cache<> cache;
    auto cached = text_mesher{font}.with(narrowing{}).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) check(cached.plan(narrow));
    CHECK(cache.statistics().hits == 5);

    test::scrambled_workers pool;
    auto team = test::toy_team(pool);
    const text_options options;
    check(mesher.plan(narrow, options, *team));

    auto plain = text_mesher{font}.with(flat{});
    const auto whole = test::required(plain.plan(narrow));
    CHECK(whole->report().narrowed == 0);
    CHECK(whole->report().first_narrowed == no_cluster);
    CHECK(whole->report().first_kept_triangle == no_cluster);
}

TEST_CASE("of merged glyphs that are narrowed one is counted, and the first is the first of the run in any style",
          "[text][styles]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(narrowing{});
    glyph_run run;
    run.units_per_em = 1000.0;
    for (const std::uint32_t style : {2u, 1u}) REQUIRE(run.glyph_styles.push_back({.style = style_id{style}}));
    for (const double x : {0.0, 300.0}) REQUIRE(run.glyphs.push_back({1, 5, {x, 0.0}, false, 0}));  // rings that meet
    REQUIRE(run.glyphs.push_back({1, 9, {2000.0, 0.0}, false, 1}));  // first in the mesh, for its style is lower
    const auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->glyphs().size() == 2);
    CHECK(plan->glyphs()[0].cluster == 9);
    CHECK(plan->report().narrowed == 2);
    CHECK(plan->report().first_narrowed == 5);
    CHECK(plan->report().lost_caps == 4);
    CHECK(plan->report().first_lost_cap == 5);
}
