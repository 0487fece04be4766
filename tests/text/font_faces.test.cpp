// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/toy_runs.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/text/font_faces.hpp>
#include <typemesh/typemesh.hpp>

#include <array>
#include <cmath>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// Icons of 250 units to the em: 0 a box over the whole em, 1 a ring that fills under even_odd alone.
recorded_outlines icons(double units = 250.0)
{
    recorded_outlines drawn{units, fill_rule::even_odd};
    const auto box = [](auto& pen, double l, double h) {
        pen.move({l, l}), pen.line({h, l}), pen.line({h, h}), pen.line({l, h}), pen.close();
    };
    REQUIRE(drawn.add([&](auto& pen) { box(pen, 0, units); }));
    REQUIRE(drawn.add([&](auto& pen) { box(pen, 0, units), box(pen, units / 5, units / 2); }));
    return drawn;
}

}  // namespace

static_assert(face_source<font_faces<test::toy_font, recorded_outlines>>);
static_assert(shaper<font_faces<test::toy_font, recorded_outlines>>);
static_assert(!shaper<font_faces<recorded_outlines, test::toy_font>>);

TEST_CASE("the first of several faces shapes and draws as it does alone, to the bit", "[text][glyph_styles]")
{
    test::toy_font font;
    const auto drawings = icons();
    font_faces faces{font, drawings};
    text_mesher alone{font};
    text_mesher mesher{faces};
    const auto expected = test::required(alone.plan("oEx\ni o")), found = test::required(mesher.plan("oEx\ni o"));
    CHECK(test::same_bits(test::written<full_mesh>(*found), test::written<full_mesh>(*expected)));
}

TEST_CASE("a face is drawn as large as the first one's em, by its own fill rule, beside the others",
          "[text][glyph_styles]")
{
    test::toy_font font;
    const auto drawings = icons();
    font_faces faces{font, drawings};
    auto mesher = text_mesher{faces}.with(flat{});
    const glyph_run run = test::styled_run({{}, {.face = 1}}, {{2, 0, {0, 0}, false, 0},       // E of the toy font
                                                               {0, 1, {600, 0}, false, 1},     // the box
                                                               {1, 2, {2000, 0}, false, 1},    // the ring
                                                               {1, 3, {3500, 0}, false, 0}});  // o of the toy font
    const auto plan = test::required(mesher.plan(run));
    REQUIRE(plan->glyphs().size() == 4);
    CHECK(plan->report().complete());
    const full_mesh m = test::written<full_mesh>(*plan);
    const auto area_of = [&](std::size_t glyph) {
        const mesh_range r = plan->range(glyph, part::front);
        return inspect::measure(
                   inspect::mesh_view{m.vertices, std::span{m.indices}.subspan(r.first_index, r.index_count)})
            .area;
    };
    CHECK(area_of(1) == Catch::Approx(1.0));
    CHECK(area_of(2) == Catch::Approx(1.0 - 0.3 * 0.3));
    CHECK(plan->bounds().low.x == 0.05f);
    CHECK(plan->meshes().size() == 4);  // glyph 1 of one face is not glyph 1 of the other
}

TEST_CASE("a face of the same units draws what it draws alone, to the bit", "[text][glyph_styles]")
{
    test::toy_font font;
    const auto drawings = icons(1000.0);
    font_faces faces{font, drawings};
    text_mesher mesher{faces};
    text_mesher alone{drawings};
    const glyph_run run = test::styled_run({{.face = 1}}, {{0, 0, {0, 0}}, {1, 1, {1100, 0}}, {0, 2, {2300, 5}}});
    const glyph_run plain = test::styled_run({}, {{0, 0, {0, 0}}, {1, 1, {1100, 0}}, {0, 2, {2300, 5}}});
    const auto found = test::required(mesher.plan(run)), expected = test::required(alone.plan(plain));
    CHECK(test::same_bits(test::written<full_mesh>(*found), test::written<full_mesh>(*expected)));
}

TEST_CASE("a glyph style's map does what transformed_outlines does, to the bit, also when glyphs are merged",
          "[text][glyph_styles]")
{
    test::toy_font font;
    const affine map =
        GENERATE(affine{.xx = 0.6, .yy = 0.6}, affine{.xy = 0.2}, affine{.dx = 30, .dy = -40},
                 affine{.xx = 0, .xy = 1, .yx = -1, .yy = 0}, affine{.xx = -1}, affine{.xx = 3, .yy = 2});
    const bool merge = GENERATE(false, true);
    transformed_outlines transformed{font, map};
    text_mesher mesher{font};
    text_mesher alone{transformed};
    const std::initializer_list<placed_glyph> glyphs = {
        {1, 0, {0, 0}}, {2, 1, {300, 0}}, {3, 2, {700, 10}}, {1, 3, {3000, 0}}};
    const glyph_run run = test::styled_run({{.map = map}}, glyphs), plain = test::styled_run({}, glyphs);
    const auto found = test::required(mesher.plan(run, {.merge = merge}));
    const auto expected = test::required(alone.plan(plain, {.merge = merge}));
    const full_mesh m = test::written<full_mesh>(*found);
    CHECK(test::same_bits(m, test::written<full_mesh>(*expected)));
    CHECK(m.vertices.size() != 0);
}

TEST_CASE("tolerance and depth stay those of the base em when a glyph style scales", "[text][glyph_styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const float depth = mesher.plan("o")->bounds().low.z;
    const auto size_at = [&](double scale) {
        const glyph_run run = test::styled_run({{.map = {.xx = scale, .yy = scale}}}, {{1, 0, {0, 0}}});
        const auto plan = test::required(mesher.plan(run));
        CHECK(plan->bounds().low.z == depth);
        return plan->size().vertices;
    };
    CHECK(size_at(8.0) > size_at(1.0));
    CHECK(size_at(1.0) > size_at(0.125));
}

TEST_CASE("a letter in several styles is built once, in several shapes once a shape", "[text][glyph_styles]")
{
    test::toy_font font;
    glyph_cache cache;
    auto mesher = text_mesher{font}.with(cached_in{cache, 1});
    const affine slanted{.xy = 0.2};
    const glyph_run run = test::styled_run(
        {{}, {.style = style_id{1}}, {.map = slanted}, {.map = slanted, .style = style_id{1}}, {.map = {.xy = 0.3}}},
        {{1, 0, {0, 0}, false, 0},
         {1, 1, {600, 0}, false, 1},
         {1, 2, {1200, 0}, false, 2},
         {1, 3, {1800, 0}, false, 3},
         {1, 4, {2400, 0}, false, 4}});
    {
        const auto plan = test::required(mesher.plan(run));
        CHECK(plan->meshes().size() == 3);
        CHECK(cache.statistics().misses == 3);
        CHECK(cache.statistics().hits == 0);
    }
    CHECK(mesher.plan("o"));  // the plain glyph style's letter is the plain text's
    CHECK(cache.statistics().misses == 3);
    CHECK(cache.statistics().hits == 1);
    full_mesh expected, found;
    {
        text_mesher uncached{font};
        expected = test::written<full_mesh>(*uncached.plan(run));
    }
    CHECK(mesher.plan(run));
    found = test::written<full_mesh>(*mesher.plan(run));
    CHECK(cache.statistics().misses == 3);
    CHECK(test::same_bits(found, expected));
}

TEST_CASE("a cache distinguishes faces, maps and the units of the first face", "[text][glyph_styles]")
{
    test::toy_font font;
    const auto drawings = icons(1000.0), coarse = icons(250.0);
    font_faces both{font, drawings};
    font_faces other{coarse, drawings};
    glyph_cache cache;
    auto mesher = text_mesher{both}.with(cached_in{cache, 1});
    auto second = text_mesher{other}.with(cached_in{cache, 1});  // the same number, for another set: only units differ
    const glyph_run run = test::styled_run({{}, {.face = 1}}, {{1, 0, {0, 0}, false, 0}, {1, 1, {600, 0}, false, 1}});
    const glyph_run icon = test::styled_run({{.face = 1}}, {{1, 0, {0, 0}}});
    CHECK(mesher.plan(run)->meshes().size() == 2);
    CHECK(cache.statistics().entries == 2);
    const auto plan = test::required(second.plan(icon));
    CHECK(cache.statistics().entries == 3);
    text_mesher uncached{other};
    CHECK(test::same_bits(test::written<full_mesh>(*plan), test::written<full_mesh>(*uncached.plan(icon))));
}

TEST_CASE("workers with faces of their own make the same mesh", "[text][glyph_styles]")
{
    test::toy_font font;
    const auto drawings = icons();
    font_faces faces{font, drawings};
    using faces_type = font_faces<test::toy_font, const recorded_outlines>;
    std::array<test::toy_font, 3> fonts;
    test::scrambled_workers several{3};
    auto pool = workers_of(several, [&](std::size_t worker) noexcept -> result<faces_type> {
        return faces_type{fonts[worker], drawings};
    });
    REQUIRE(pool);
    text_mesher mesher{faces};
    glyph_run run = test::styled_run({{}, {.face = 1, .style = style_id{1}}, {.map = {.xy = 0.2}}}, {});
    for (std::uint32_t i = 0; i < 40; ++i) REQUIRE(run.glyphs.push_back({i % 2, i, {600.0 * i, 0}, false, i % 3}));
    const full_mesh expected = test::written<full_mesh>(*mesher.plan(run));
    CHECK(test::same_bits(test::written<full_mesh>(*test::required(mesher.plan(run, {}, *pool))), expected));
}

TEST_CASE("glyph styles, faces and units that do not exist are refused, each by name", "[text][glyph_styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto refusal = [&](const glyph_run& run) { return mesher.plan(run).error(); };
    CHECK(refusal(test::styled_run({}, {{1, 3, {0, 0}, false, 1}})) == error::no_such_glyph_style);
    const error far_look = refusal(test::styled_run({{}, {}}, {{1, 0, {0, 0}, false, 1}, {2, 7, {0, 0}, false, 2}}));
    CHECK(far_look == error::no_such_glyph_style);
    CHECK(far_look.count == 2);
    CHECK(far_look.glyph == 2);
    CHECK(far_look.cluster == 7);
    const error face = refusal(test::styled_run({{}, {.face = 1}}, {{1, 0, {0, 0}}}));
    CHECK(face == error::no_such_face);
    CHECK(face.count == 1);

    glyph_run run = test::styled_run({}, {{1, 0, {0, 0}}});
    CHECK(mesher.plan(run));  // units are the font's where the run says none
    run.units_per_em = 1000.0;
    CHECK(mesher.plan(run));
    run.units_per_em = 2048.0;
    CHECK(refusal(run) == error::other_units);
    for (const double wrong : {-1000.0, std::nan(""), HUGE_VAL}) {
        run.units_per_em = wrong;
        CHECK(refusal(run) == error::bad_option);
    }
    CHECK(mesher.plan("o"));  // and nothing is left behind
}

TEST_CASE("a map that is no number leaves its glyphs out, and says so", "[text][glyph_styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run =
        test::styled_run({{}, {.map = {.xx = std::nan("")}}},
                         {{1, 0, {0, 0}, false, 0}, {1, 1, {600, 0}, false, 1}, {2, 2, {1200, 0}, false, 1}});
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->glyphs().size() == 1);
    CHECK(plan->report().refused == 2);
    CHECK(plan->report().first_refusal == error::outline_not_finite);
    CHECK(plan->report().first_refusal.cluster == 1);
}

TEST_CASE("a map that flattens a glyph leaves nothing of it", "[text][glyph_styles]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run = test::styled_run({{.map = {.xx = 0.0}}}, {{1, 0, {0, 0}}, {3, 1, {600, 0}}});
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->glyphs().empty());
    CHECK(plan->report().blank == 2);
}
