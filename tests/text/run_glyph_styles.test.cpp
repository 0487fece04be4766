// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/text/impl/run_glyph_styles.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace typemesh;

namespace {

/// A run of many glyphs and glyph styles, of few styles and maps.
glyph_run random_run(std::uint32_t seed, std::size_t glyph_styles, std::size_t glyphs)
{
    std::mt19937 random{seed};
    glyph_run run;
    for (std::size_t i = 0; i < glyph_styles; ++i) {
        glyph_style l;
        l.style = style_id{static_cast<std::uint32_t>(random() % 5) * 0x3000'0000u};
        l.map.xy = static_cast<double>(random() % 3);
        REQUIRE(run.glyph_styles.push_back(l));
    }
    for (std::size_t i = 0; i < glyphs; ++i)
        REQUIRE(run.glyphs.push_back({1, 0, {}, false, static_cast<std::uint32_t>(random() % glyph_styles)}));
    return run;
}

}  // namespace

TEST_CASE("glyph styles that draw the same outlines are known by the lowest of them", "[text][glyph_styles]")
{
    test::toy_font font;
    run_glyph_styles glyph_styles{heap()};
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const glyph_run run = random_run(seed, 1 + seed * 3, 0);
        glyph_styles.clear();
        REQUIRE_FALSE(glyph_styles.read(run, font));
        for (std::uint32_t i = 0; i < run.glyph_styles.size(); ++i) {
            std::uint32_t lowest = 0;
            while (!(run.glyph_styles[lowest].map == run.glyph_styles[i].map)) ++lowest;
            CHECK(glyph_styles.outlines_of(i) == lowest);
            CHECK(glyph_styles.style_of(i) == run.glyph_styles[i].style);
        }
    }
}

TEST_CASE("glyphs are sorted by style, those of a style stay in order", "[text][glyph_styles]")
{
    test::toy_font font;
    run_glyph_styles glyph_styles{heap()};
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const glyph_run run = random_run(seed, 2 + seed, 200);
        glyph_styles.clear();
        REQUIRE_FALSE(glyph_styles.read(run, font));
        REQUIRE_FALSE(glyph_styles.sort(run));
        std::vector<std::uint32_t> expected(run.glyphs.size());
        for (std::uint32_t i = 0; i < expected.size(); ++i) expected[i] = i;
        const auto style = [&](std::uint32_t i) { return run.glyph_styles[run.glyphs[i].glyph_style].style; };
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return style(a) < style(b); });
        std::vector<std::uint32_t> found(glyph_styles.order().begin(), glyph_styles.order().end());
        if (found.empty() && std::is_sorted(expected.begin(), expected.end())) found = expected;
        CHECK(found == expected);
    }
}

TEST_CASE("a run without glyph styles takes no memory for them, and neither does one style for an order",
          "[text][glyph_styles]")
{
    test::toy_font font;
    test::counting_memory counted;
    run_glyph_styles glyph_styles{counted.source()};
    glyph_run run;
    REQUIRE(run.glyphs.push_back({1, 0, {}}));
    REQUIRE_FALSE(glyph_styles.read(run, font));
    REQUIRE_FALSE(glyph_styles.sort(run));
    CHECK(glyph_styles.order().empty());
    CHECK(glyph_styles.outlines_of(0) == 0);
    CHECK(glyph_styles.style_of(0) == style_id{});
    CHECK(counted.requests == 0);
    for (int i = 0; i < 3; ++i) REQUIRE(run.glyph_styles.push_back({.style = style_id{9}}));
    REQUIRE_FALSE(glyph_styles.read(run, font));
    const std::size_t before = counted.requests;
    REQUIRE_FALSE(glyph_styles.sort(run));
    CHECK(glyph_styles.order().empty());
    CHECK(counted.requests == before);
}

TEST_CASE("glyph styles whose memory fails say so", "[text][glyph_styles]")
{
    test::toy_font font;
    const glyph_run run = random_run(1, 10, 50);
    std::size_t fails = 0;
    for (std::size_t n = 1; n < 10; ++n) {
        test::counting_memory failing{.fail_at = n};
        run_glyph_styles glyph_styles{failing.source()};
        error e = glyph_styles.read(run, font);
        if (!e) e = glyph_styles.sort(run);
        if (!e) e = glyph_styles.find_contexts({}, font);
        if (!e) break;
        CHECK(e == error::out_of_memory);
        ++fails;
    }
    CHECK(fails == 5);  // glyph styles, keys, starts, order, contexts
}

TEST_CASE("a glyph style has other glyphs where its units are others", "[text][glyph_styles]")
{
    recorded_outlines small{1000.0}, large{2000.0};
    glyph_run run;
    REQUIRE(run.glyph_styles.push_back({.map = {.xy = 0.25}}));
    run_glyph_styles of_small{heap()}, of_large{heap()};
    REQUIRE_FALSE(of_small.read(run, small));
    REQUIRE_FALSE(of_large.read(run, large));
    REQUIRE_FALSE(of_small.find_contexts({}, small));
    REQUIRE_FALSE(of_large.find_contexts({}, large));
    CHECK_FALSE(of_small.contexts()[0].context == of_large.contexts()[0].context);
}
