// SPDX-License-Identifier: MIT

// Bevelled letters go wherever all others do: into caches, merged letters, chunks, instances, teams and partial writes.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/failing_memory.hpp"
#include "support/text_laws.hpp"

using namespace typemesh;

namespace {

const bevelled rounding{.width = 0.02f, .bevel_depth = 0.03f, .profile = round_profile(4)};

template <class Plan>
test::lit_mesh checked_mesh(const Plan& plan, const frame& f = right_handed_y_up)
{
    return test::lawful_parts(plan, 5, f);
}

}  // namespace

TEST_CASE("bevelled letters come out of caches, teams and constrained Delaunay as they are built alone", "[text]")
{
    bevelled wider = rounding;
    wider.width = 0.03f;
    test::check_everywhere([](auto& font, const bevelled& how) { return text_mesher{font}.with(how); }, rounding,
                           wider);
}

TEST_CASE("bevelled letters are merged, cut into chunks, instanced and written in part", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
    const auto joined = test::required(mesher.plan(run, {.merge = true}));
    CHECK(joined->glyphs().size() == 2);
    (void)checked_mesh(*joined);
    const auto plan = test::required(mesher.plan(test::crossed_word));
    (void)checked_mesh(*plan);
    test::check_pieces(*plan, {65'535, 600, 60});  // all glyphs, one, pieces
}

TEST_CASE("a bevel keeps its slope where depths are in output units", "[text]")
{
    test::toy_font font;
    const bevelled how{.depth = 20.0f, .width = 0.02f, .bevel_depth = 2.0f};
    auto mesher = text_mesher{font}.with(how);
    const text_options options{.unit = output_unit::pixels, .pixels_per_em = 100.0, .depth_in = depth_unit::output};
    const auto plan = test::required(mesher.plan("i", options));
    const test::lit_mesh m = checked_mesh(*plan);
    const mesh_range r = plan->range(part::front_bevel);
    for (std::uint32_t i = 0; i < r.vertex_count; ++i)
        CHECK(m.vertices[r.first_vertex + i].normal.z == Catch::Approx(0.70710678).margin(1e-5));
    CHECK(plan->bounds().low.z == Catch::Approx(-20.0));
}

TEST_CASE("bevelled letters obey their laws in every frame, in mirrored glyph styles as well", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    frame godot = right_handed_y_up;
    godot.winding = -1;
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up, godot}) {
        (void)checked_mesh(*test::required(mesher.plan(test::crossed_word, {.frame = f})), f);
    }
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.glyph_styles.push_back({}));
    REQUIRE(run.glyph_styles.push_back({.map = {.xx = -1.0}}));
    for (const glyph_id g : {1u, 2u, 3u})
        for (const std::uint32_t glyph_style : {0u, 1u})
            REQUIRE(run.glyphs.push_back(
                {.id = g, .origin = {2000.0 * g, 2000.0 * glyph_style}, .glyph_style = glyph_style}));
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->report().refused == 0);
    (void)checked_mesh(*plan);
}

TEST_CASE("a bevelled text reports memory that fails at any request, and can be built afterwards", "[text][memory]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    const auto make = [&](memory source) {
        return [poor = text_mesher{font, source}.with(rounding)](test::lit_mesh& m) mutable {
            return poor.build(test::crossed_word, into(m.vertices, m.indices));
        };
    };
    const test::lit_mesh expected = test::written(*test::required(mesher.plan(test::crossed_word)));
    CHECK(test::failures_of(make, expected, GENERATE(true, false)) > 20);
}

TEST_CASE("bevels that fit a text are as narrow as its narrowest letter's, with caches, teams and merging", "[text]")
{
    test::toy_font font;
    const bevelled clip{.width = 0.2f, .bevel_depth = 0.03f, .profile = round_profile(4)};
    bevelled fit = clip, fit_text = clip;
    fit.mode = bevel_mode::fit;
    fit_text.mode = bevel_mode::fit_text;
    const auto widths_of = [](const auto& plan, const auto& how) {
        std::vector<float> widths;
        for (const drawn_glyph& g : plan.glyphs())
            widths.push_back(how.width_of(g.built->template planned<bevelled>().form));
        return widths;
    };

    auto each = text_mesher{font}.with(fit);
    const auto apart = test::required(each.plan("oE"));
    const auto own = widths_of(*apart, fit);
    CHECK(own[1] == Catch::Approx(0.045));  // "E" is 100 units thick, and so is "o", but for its chords
    CHECK(own[0] > own[1]);
    CHECK(apart->report().narrowed == 2);  // to less than half

    auto mesher = text_mesher{font}.with(fit_text);
    const auto plan = test::required(mesher.plan("oE"));
    CHECK(plan->report().narrowed == 2);
    const auto same_width = widths_of(*plan, fit_text);
    CHECK(same(same_width[0], own[1]));
    CHECK(same(same_width[1], own[1]));
    const test::lit_mesh expected = checked_mesh(*plan);
    CHECK(same(mesher.solid().width, 0.2f));  // the next text begins anew
    CHECK(is_zero(mesher.solid().wanted));
    bevelled nearly = fit_text;
    nearly.width = 0.08f;
    auto enough = text_mesher{font}.with(nearly);
    CHECK(test::required(enough.plan("oE"))->report().narrowed == 0);
    CHECK(same(widths_of(*test::required(mesher.plan("o")), fit_text)[0], own[0]));

    bevelled at_once = clip;
    at_once.width = own[1];
    auto clipped = text_mesher{font}.with(at_once);
    CHECK(checked_mesh(*test::required(clipped.plan("oE"))) == expected);

    glyph_cache<> cache;
    auto cached = text_mesher{font}.with(fit_text).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        const auto again = test::required(cached.plan("oE"));
        CHECK(checked_mesh(*again) == expected);
        CHECK(cache.statistics().entries == 4);
        CHECK(cache.statistics().pinned == 2);
    }
    CHECK(cache.statistics().hits == 4);

    test::scrambled_workers pool;
    auto team = test::toy_team(pool);
    const text_options options, merging{.merge = true};
    for (int i = 0; i < 2; ++i) {
        CHECK(checked_mesh(*test::required(mesher.plan("oE", options, *team))) == expected);
    }

    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
    const auto joined = test::required(mesher.plan(run, merging));
    const auto of_groups = widths_of(*joined, fit_text);
    REQUIRE(of_groups.size() == 2);
    CHECK(same(of_groups[0], of_groups[1]));
    (void)checked_mesh(*joined);

    for (const bevel_mode mode : {bevel_mode::clip, bevel_mode::fit_text}) {
        bevelled bad = clip;
        bad.mode = mode;
        bad.width = -1.0f;
        auto refused = text_mesher{font}.with(bad);
        CHECK(refused.plan("oE").error() == error::bad_option);
    }
}

TEST_CASE("bevels that fit a text are its own, though another in the cache was as narrow and wanted more", "[text]")
{
    recorded_outlines font{1000.0};
    const auto polygon = [&](std::initializer_list<point> corners) {
        return font.add([&](auto& pen) {
            pen.move(*corners.begin());
            for (const point* p = corners.begin() + 1; p != corners.end(); ++p) pen.line(*p);
            pen.close();
        });
    };
    REQUIRE(polygon({{0, 0}, {30, 0}, {30, 700}, {0, 700}}));  // is as narrow, whatever is wanted
    REQUIRE(polygon({{0, 0}, {400, 0}, {400, 200}, {200, 200}, {200, 700}, {0, 700}}));  // has a corner that gets joins
    glyph_run run;
    run.units_per_em = 1000.0;
    for (const glyph_id g : {0u, 1u}) REQUIRE(run.glyphs.push_back({g, 0, {500.0 * g, 0.0}}));
    glyph_cache<> cache;
    const bevelled how{.bevel_depth = 0.03f, .mode = bevel_mode::fit_text, .mitre_limit = 1.0f};
    auto alone = text_mesher{font}.with(how);
    auto cached = text_mesher{font}.with(how).with(cached_in{cache, 1});
    for (const float width : {0.2f, 0.02f, 0.05f, 0.1f}) {
        alone.solid().width = cached.solid().width = width;
        const auto plan = test::required(alone.plan(run));
        CHECK(checked_mesh(*test::required(cached.plan(run))) == checked_mesh(*plan));
    }
}

TEST_CASE("the bounds of a bevelled text are those of its vertices, in height as well", "[text]")
{
    test::toy_font font;
    for (const float width : {0.02f, 0.3f}) {
        auto mesher = text_mesher{font}.with(bevelled{.width = width, .bevel_depth = 0.09f});
        for (const char* text : {"o", "i", "oExi"}) {
            const auto plan = test::required(mesher.plan(text));
            (void)test::lawful(*plan);
            CHECK((plan->bounds().high.z < 0.0f) == (width > 0.1f));
        }
    }
}

TEST_CASE("triangles of bevels that floats turn over are counted, far from the origin", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(bevelled{.width = 0.02f, .profile = round_profile(16)});
    auto plain = text_mesher{font};
    const auto flipped_at = [](auto& made, double x) {
        const glyph_run run = test::row_of(1, {x});
        return flipped_triangles(*test::required(made.plan(run)));
    };
    CHECK(flipped_at(mesher, 0.0) == 0);
    const double far = 4e6;  // floats are 244 micro-em apart there, and a strip is about a milli-em wide
    CHECK(flipped_at(mesher, far) > flipped_at(plain, far));
}

TEST_CASE("of merged letters with bevels every triangle is shared", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    const glyph_run run = test::row_of(1, {0.0, 300.0});
    const auto plan = test::required(mesher.plan(run, {.merge = true}));
    for (const part p : plan->parts()) {
        const std::uint32_t triangles = plan->range(0, p).index_count / 3;
        for (const std::uint32_t t : {0u, triangles - 1}) CHECK(plan->owner(0, p, t) == shared_glyph);
    }
}

TEST_CASE("letters that meet when outward bevels have grown are merged: one surface, which turns over nowhere",
          "[text]")
{
    test::toy_font font;
    const glyph_run run = test::row_of(5, {0.0, 140.0, 800.0});  // bars, 100 wide
    const double depth = 0.2, height = 0.5;
    for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front, bevel_sides::back}) {
        for (const float width : {0.01f, 0.03f}) {
            const bevelled how{.width = width, .bevel_depth = 0.05f, .sides = sides, .outward = true};
            const bool meet = width > 0.02f;
            auto mesher = text_mesher{font}.with(how);
            const auto plan = test::required(mesher.plan(run, {.merge = true}));
            REQUIRE(plan->glyphs().size() == (meet ? 2u : 3u));
            const bevelled inward{.width = width, .bevel_depth = 0.05f, .sides = sides};
            auto carved = text_mesher{font}.with(inward);
            const auto apart = test::required(carved.plan(run, {.merge = true}));
            CHECK(apart->glyphs().size() == 3);

            const test::lit_mesh m = test::written(*plan);
            CHECK(inspect::check_closedness(m.view()).is_closed());
            std::int64_t twice = 0;
            plan->each_seen_from_front(0, [&](grid_point a, grid_point b, grid_point c) noexcept {
                CHECK(orientation(a, b, c) > 0);
                twice += orientation(a, b, c);
            });
            // Seen from the front: the outline of both bars, grown, and with bevels on one side the grown cap as well.
            const double w = static_cast<double>(width), cells = 512000.0;
            const double bars = meet ? 0.24 : 0.1, rounding_off = 1e-4;
            const double grown = (bars + 2.0 * w) * (height + 2.0 * w);
            const double own = 3.0 * 0.1 * height;
            const double seen = sides == bevel_sides::both ? grown : 2.0 * grown;
            CHECK(0.5 * static_cast<double>(twice) / cells / cells == Catch::Approx(seen).margin(rounding_off));
            CHECK(inspect::measure(m.view()).volume < depth * grown * 3.0);
            CHECK(inspect::measure(m.view()).volume > depth * own);
        }
    }
}

TEST_CASE("bolder letters are merged where they have grown together, thinner ones where they are drawn together",
          "[text]")
{
    test::toy_font font;
    const auto glyphs_at = [&](const auto& how, double second, embolden step = {.by = 0.0f}) {
        const glyph_run run = test::row_of(5, {0.0, second});  // bars, 100 wide
        text_mesher mesher{font, step, how};
        const auto plan = test::required(mesher.plan(run, {.merge = true}));
        const test::lit_mesh m = test::written(*plan);
        CHECK(inspect::check_closedness(m.view()).is_closed());
        std::int64_t twice = 0;
        for (std::size_t i = 0; i < plan->glyphs().size(); ++i)
            plan->each_seen_from_front(
                i, [&](grid_point a, grid_point b, grid_point c) noexcept { twice += orientation(a, b, c); });
        return std::pair{plan->glyphs().size(), 0.5 * static_cast<double>(twice) / 512000.0 / 512000.0};
    };
    const embolden little{.by = 0.01f};
    const auto grown = glyphs_at(bevelled{.width = 0.01f}, 140.0, {.by = 0.03f});
    CHECK(grown.first == 1);
    CHECK(grown.second == Catch::Approx((0.24 + 0.06) * (0.5 + 0.06)));
    CHECK(glyphs_at(bevelled{.width = 0.01f}, 140.0, little).first == 2);
    CHECK(glyphs_at(bevelled{.width = 0.02f, .outward = true}, 140.0, little).first == 1);
    const auto thinned = glyphs_at(extruded<>{}, 100.0, {.by = -0.01f});  // drawn side by side
    CHECK(thinned.first == 1);
    CHECK(thinned.second == Catch::Approx((0.2 - 0.02) * (0.5 - 0.02)));
    const auto hollow = glyphs_at(outlined<>{.width = 0.01f}, 140.0);
    CHECK(hollow.first == 2);
    CHECK(hollow.second == Catch::Approx(2.0 * (0.1 * 0.5 - 0.08 * 0.48)));

    const bevelled fitting{.width = 0.2f, .mode = bevel_mode::fit_text};
    text_mesher mesher{font, little, fitting};
    const auto plan = test::required(mesher.plan("Ei"));
    REQUIRE(plan->glyphs().size() == 2);
    for (const drawn_glyph& g : plan->glyphs())
        CHECK(fitting.width_of(g.built->planned<bevelled>().form) == Catch::Approx(0.9 * 0.06f).margin(1e-4));
}
