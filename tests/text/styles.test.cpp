// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/required.hpp"
#include "support/style_laws.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/typemesh.hpp>

#include <vector>

using namespace typemesh;

namespace {

/// Lines of toy letters, so close that many overlap; a space, a refused glyph and a missing one among them.
glyph_run crowded_run()
{
    glyph_run run;
    const char* lines[] = {"oEi xoo", "EEo?~oi", "xxioEo"};
    cluster_id cluster = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(
            run.lines.push_back({static_cast<std::uint32_t>(run.glyphs.size()), 0, {0.0, -900.0 * double(k)}, 0.0}));
        for (const char* c = lines[k]; *c != '\0'; ++c) {
            placed_glyph g{test::toy_font::glyph_of(static_cast<unsigned char>(*c)),
                           cluster++,
                           {380.0 * double(c - lines[k]), -900.0 * double(k)}};
            g.missing = g.id == 0;
            REQUIRE(run.glyphs.push_back(g));
        }
        run.lines[k].glyph_count = static_cast<std::uint32_t>(run.glyphs.size()) - run.lines[k].first_glyph;
    }
    return run;
}

}  // namespace

TEMPLATE_TEST_CASE(
    "styles only sort: each glyph's mesh, each range and each way of writing is as in a text of one style",
    "[text][styles]", flat, extruded<curve_normals>, extruded<shared_normals>)
{
    test::toy_font font;
    TestType how;
    how.texture = texture_mapping::box;
    auto mesher = text_mesher{font}.with(how), other = text_mesher{font}.with(how);
    test::scrambled_workers several{3};
    auto pool = test::toy_team(several);
    const auto texture_over = GENERATE(texture_box::text, texture_box::line);
    const glyph_run run = crowded_run();
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
        test::check_styles(mesher, other, *pool, run, {.tolerance = quality::low, .texture_over = texture_over}, seed);
}

TEST_CASE("a table of glyph styles that are all plain changes nothing, to the bit", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font}, other{font};
    glyph_run plain = crowded_run(), tabled = crowded_run();
    for (int i = 0; i < 3; ++i) REQUIRE(tabled.glyph_styles.push_back({}));
    for (std::size_t i = 0; i < tabled.glyphs.size(); ++i)
        tabled.glyphs[i].glyph_style = static_cast<std::uint32_t>(i % 3);
    for (const bool merge : {false, true}) {
        const auto a = test::required(mesher.plan(plain, {.merge = merge}));
        const auto b = test::required(other.plan(tabled, {.merge = merge}));
        CHECK(test::same_bits(test::written<test::styled_mesh>(*a), test::written<test::styled_mesh>(*b)));
        CHECK(a->meshes().size() == b->meshes().size());
        CHECK(b->styles().size() == 1);
    }
}

TEST_CASE("a text without glyph styles is of style 0, an empty one of none", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    {
        const auto plan = mesher.plan("oE");
        REQUIRE(plan->styles().size() == 1);
        CHECK(plan->styles()[0] == style_id{});
        for (const part p : all_parts) {
            CHECK(plan->range(style_id{}, p) == plan->range(p));
            CHECK(plan->range(style_id{1}, p).index_count == 0);
        }
    }
    const auto empty = mesher.plan(" ");
    CHECK(empty->styles().empty());
    CHECK(empty->glyphs_of(style_id{}).last == 0);
}

TEST_CASE("the glyphs of a cluster are neighbours in each of its styles", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    for (const std::uint32_t s : {0u, 1u}) REQUIRE(run.glyph_styles.push_back({.style = style_id{s}}));
    const std::uint32_t glyph_styles[] = {1, 0, 1, 1, 0};
    for (std::uint32_t i = 0; i < 5; ++i)
        REQUIRE(run.glyphs.push_back({1, i == 0 ? 0u : 4u, {600.0 * i, 0.0}, false, glyph_styles[i]}));
    const auto plan = mesher.plan(run);
    REQUIRE(plan->glyphs().size() == 5);  // in the run: 1 4 | 0 2 3
    const glyph_span plain = plan->glyphs_of(4, style_id{0}), coloured = plan->glyphs_of(4, style_id{1});
    CHECK(plain.first == 0);
    CHECK(plain.last == 2);
    CHECK(coloured.first == 3);
    CHECK(coloured.last == 5);
    CHECK(plan->glyphs_of(4).first == 0);  // those of its lowest style
    CHECK(plan->glyphs_of(4).last == 2);
    CHECK(plan->glyphs_of(0).first == 2);
    CHECK(plan->glyphs_of(0, style_id{0}).last == plan->glyphs_of(0, style_id{0}).first);
}

TEST_CASE("the first glyph that is refused is the first of the run, whatever its style", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    for (const std::uint32_t s : {5u, 2u}) REQUIRE(run.glyph_styles.push_back({.style = style_id{s}}));
    REQUIRE(run.glyphs.push_back({6, 10, {0, 0}, false, 0}));
    REQUIRE(run.glyphs.push_back({6, 11, {600, 0}, false, 1}));
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->report().refused == 2);
    CHECK(plan->report().first_refusal.cluster == 10);
}

TEST_CASE("an instanced mesh is of no style, its instances are", "[text][styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    for (const std::uint32_t s : {4u, 2u}) REQUIRE(run.glyph_styles.push_back({.style = style_id{s}}));
    for (std::uint32_t i = 0; i < 4; ++i) REQUIRE(run.glyphs.push_back({1, i, {600.0 * i, 0.0}, false, i % 2}));
    const auto plan = mesher.plan(run);
    REQUIRE(plan->meshes().size() == 1);  // built once
    test::styled_mesh m;
    REQUIRE(plan->write_meshes(into(m.vertices, m.indices)));
    for (const test::styled_vertex& v : m.vertices) REQUIRE(v.style == static_cast<std::uint32_t>(no_style));
    CHECK(plan->instances(0, style_id{2}).count == 2);
    CHECK(plan->instances(0, style_id{4}).first == 2);
    CHECK(plan->instances(0, style_id{3}).count == 0);
}

TEST_CASE("a text of many glyph styles planned again needs no memory, and memory that fails is reported",
          "[text][styles]")
{
    test::toy_font font;
    const glyph_run run = test::styled_at_random(crowded_run(), 3);
    test::counting_memory counted;
    text_mesher mesher{font, counted.source()};
    glyph_cache cache;
    text_mesher cached = text_mesher{font, counted.source()}.with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        CHECK(mesher.plan(run, {.merge = true}));
        CHECK(cached.plan(run));
    }
    const std::size_t before = counted.requests;
    CHECK(mesher.plan(run, {.merge = true}));
    CHECK(cached.plan(run));
    CHECK(counted.requests == before);
    bool done = false;
    for (std::size_t n = 1; !done; ++n) {
        test::counting_memory failing{.fail_at = n, .fail_once = true};
        text_mesher poor{font, failing.source()};
        const auto plan = poor.plan(run);
        done = failing.requests < n;
        if (plan)
            CHECK(plan->styles().size() == 4);
        else
            CHECK(plan.error() == error::out_of_memory);
    }
}
