// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/layout/glyph_run.hpp>

#include <cstddef>
#include <limits>

using namespace typemesh;

static_assert(sizeof(placed_glyph) == 40);  // a word more for the middle of its cluster

TEST_CASE("missing glyphs and invalid places are counted, and the first place of each is the lowest", "[layout]")
{
    glyph_run run;
    CHECK(run.first_missing == no_cluster);
    for (const cluster_id c : {7u, 3u, 9u}) run.note_missing(c);  // right to left, say
    CHECK(run.missing == 3);
    CHECK(run.first_missing == 3);
    run.note_invalid_units(8, 2);
    run.note_invalid_units(5);
    CHECK(run.invalid_units == 3);
    CHECK(run.first_invalid_unit == 5);
    run.unbroken = 1;
    run.first_unbroken = 4;
    run.clear();
    CHECK(run.unbroken == 0);
    CHECK(run.first_unbroken == no_cluster);
    CHECK(run.missing == 0);
    CHECK(run.first_missing == no_cluster);
    CHECK(run.invalid_units == 0);
    CHECK(run.first_invalid_unit == no_cluster);
}

TEST_CASE("equal glyph styles have one number, and 0 is the plain one", "[layout]")
{
    glyph_run run;
    CHECK(*run.number_of({}) == 0);
    CHECK(run.glyph_styles.empty());  // a run of the plain glyph style alone has no table
    const glyph_style styles[] = {{}, {.style = style_id{1}}, {.map = {.xx = 0.5, .yy = 0.5}}, {.face = 1}};
    for (const std::uint32_t k : {1u, 2u, 3u, 2u, 1u, 0u}) CHECK(*run.number_of(styles[k]) == k);
    REQUIRE(run.glyph_styles.size() == 4);
    CHECK(run.glyph_styles[0] == styles[0]);
    CHECK(run.glyph_styles[3] == styles[3]);
    run.clear();
    CHECK(run.glyph_styles.empty());
}

TEST_CASE("a glyph style whose memory fails leaves the table as it was", "[layout]")
{
    test::counting_memory failing{.fail_at = 1};
    glyph_run run{failing.source()};
    CHECK(run.number_of({.face = 1}).error() == error::out_of_memory);
    CHECK(run.glyph_styles.empty());
    CHECK(*run.number_of({}) == 0);
}

TEST_CASE("equal ones of many glyph styles have one number, too, whatever else was done to the table", "[layout]")
{
    glyph_run run;
    const auto many = [](std::uint32_t i) { return glyph_style{.map = {.xx = 1.0 + i}, .style = style_id{i % 7}}; };
    for (int round = 0; round < 2; ++round) {
        for (std::uint32_t i = 1; i <= 1'000; ++i) CHECK(*run.number_of(many(i)) == i);
        for (std::uint32_t i = 1; i <= 1'000; ++i) CHECK(*run.number_of(many(i)) == i);
        CHECK(*run.number_of({}) == 0);
        run.glyph_styles.truncate(500);
        CHECK(*run.number_of(many(700)) == 500);
        REQUIRE(run.glyph_styles.push_back(many(800)));  // by hand
        CHECK(*run.number_of(many(800)) == 501);
        CHECK(*run.number_of({.map = {.xx = 1.0 + 20, .xy = -0.0}, .style = style_id{20 % 7}}) == 20);
        run.clear();
    }
}

TEST_CASE("a run takes over shapes, each with its face and map", "[layout]")
{
    glyph_run run;
    REQUIRE(run.add({.id = 3}));
    CHECK(run.glyph_styles.empty());
    REQUIRE(run.add({.id = 3, .face = 1}));
    REQUIRE(run.add({.id = 4, .map = {.xy = 0.2}}));
    REQUIRE(run.add({.id = 5, .face = 1}));
    REQUIRE(run.glyphs.size() == 4);
    const glyph_id ids[] = {3, 3, 4, 5};
    const glyph_style drawn[] = {{}, {.face = 1}, {.map = {.xy = 0.2}}, {.face = 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(run.glyphs[i].id == ids[i]);
        CHECK(run.glyphs[i].origin == point{});
        CHECK(run.glyph_styles[run.glyphs[i].glyph_style] == drawn[i]);
    }
    CHECK(run.glyph_styles.size() == 3);
}

TEST_CASE("a shape without a glyph is refused, and memory that fails is reported", "[layout]")
{
    glyph_run run;
    CHECK(run.add({}).error() == error::unknown_glyph);
    CHECK(run.glyphs.empty());
    for (const std::size_t k : {1u, 2u}) {
        test::counting_memory failing{.fail_at = k};
        glyph_run short_of_memory{failing.source()};
        CHECK(short_of_memory.add({.id = 1, .face = 1}).error() == error::out_of_memory);
        CHECK(short_of_memory.glyphs.empty());
    }
}
