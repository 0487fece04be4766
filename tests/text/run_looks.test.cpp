// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/text/impl/run_looks.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace typemesh;

namespace {

/// A run of many glyphs and looks, of few styles and maps.
glyph_run random_run(std::uint32_t seed, std::size_t looks, std::size_t glyphs)
{
    std::mt19937 random{seed};
    glyph_run run;
    for (std::size_t i = 0; i < looks; ++i) {
        look l;
        l.style = style_id{static_cast<std::uint32_t>(random() % 5) * 0x3000'0000u};
        l.map.xy = static_cast<double>(random() % 3);
        REQUIRE(run.looks.push_back(l));
    }
    for (std::size_t i = 0; i < glyphs; ++i)
        REQUIRE(run.glyphs.push_back({1, 0, {}, false, static_cast<std::uint32_t>(random() % looks)}));
    return run;
}

}  // namespace

TEST_CASE("looks that draw the same outlines are known by the lowest of them", "[text][looks]")
{
    test::toy_font font;
    run_looks looks{heap()};
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const glyph_run run = random_run(seed, 1 + seed * 3, 0);
        looks.clear();
        REQUIRE_FALSE(looks.read(run, font));
        for (std::uint32_t i = 0; i < run.looks.size(); ++i) {
            std::uint32_t lowest = 0;
            while (!(run.looks[lowest].map == run.looks[i].map)) ++lowest;
            CHECK(looks.outlines_of(i) == lowest);
            CHECK(looks.style_of(i) == run.looks[i].style);
        }
    }
}

TEST_CASE("glyphs are sorted by style, those of a style stay in order", "[text][looks]")
{
    test::toy_font font;
    run_looks looks{heap()};
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const glyph_run run = random_run(seed, 2 + seed, 200);
        looks.clear();
        REQUIRE_FALSE(looks.read(run, font));
        REQUIRE_FALSE(looks.sort(run));
        std::vector<std::uint32_t> expected(run.glyphs.size());
        for (std::uint32_t i = 0; i < expected.size(); ++i) expected[i] = i;
        const auto style = [&](std::uint32_t i) { return run.looks[run.glyphs[i].look].style; };
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return style(a) < style(b); });
        std::vector<std::uint32_t> found(looks.order().begin(), looks.order().end());
        if (found.empty() && std::is_sorted(expected.begin(), expected.end())) found = expected;
        CHECK(found == expected);
    }
}

TEST_CASE("a run without looks takes no memory for them, and neither does one style for an order", "[text][looks]")
{
    test::toy_font font;
    test::counting_memory counted;
    run_looks looks{counted.source()};
    glyph_run run;
    REQUIRE(run.glyphs.push_back({1, 0, {}}));
    REQUIRE_FALSE(looks.read(run, font));
    REQUIRE_FALSE(looks.sort(run));
    CHECK(looks.order().empty());
    CHECK(looks.outlines_of(0) == 0);
    CHECK(looks.style_of(0) == style_id{});
    CHECK(counted.requests == 0);
    for (int i = 0; i < 3; ++i) REQUIRE(run.looks.push_back({.style = style_id{9}}));
    REQUIRE_FALSE(looks.read(run, font));
    const std::size_t before = counted.requests;
    REQUIRE_FALSE(looks.sort(run));
    CHECK(looks.order().empty());
    CHECK(counted.requests == before);
}

TEST_CASE("looks whose memory fails say so", "[text][looks]")
{
    test::toy_font font;
    const glyph_run run = random_run(1, 10, 50);
    std::size_t fails = 0;
    for (std::size_t n = 1; n < 10; ++n) {
        test::counting_memory failing{.fail_at = n};
        run_looks looks{failing.source()};
        error e = looks.read(run, font);
        if (!e) e = looks.sort(run);
        if (!e) e = looks.find_contexts({}, font);
        if (!e) break;
        CHECK(e == error::out_of_memory);
        ++fails;
    }
    CHECK(fails == 5);  // looks, keys, starts, order, contexts
}

TEST_CASE("a look has other glyphs where its units are others", "[text][looks]")
{
    recorded_outlines small{1000.0}, large{2000.0};
    glyph_run run;
    REQUIRE(run.looks.push_back({.map = {.xy = 0.25}}));
    run_looks of_small{heap()}, of_large{heap()};
    REQUIRE_FALSE(of_small.read(run, small));
    REQUIRE_FALSE(of_large.read(run, large));
    REQUIRE_FALSE(of_small.find_contexts({}, small));
    REQUIRE_FALSE(of_large.find_contexts({}, large));
    CHECK_FALSE(of_small.contexts()[0].context == of_large.contexts()[0].context);
}
