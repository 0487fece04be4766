// SPDX-License-Identifier: MIT

// Shapes with which meshes have once been wrong: each law is checked on the shape that broke it and on its neighbours.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/text/cells_told_apart.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_runs.hpp"

using namespace typemesh;

namespace {

constexpr double attacked_units = 1000.0;

void draw_polygon(auto& pen, const std::vector<point>& corners)
{
    pen.move(corners.front());
    for (std::size_t i = 1; i < corners.size(); ++i) pen.line(corners[i]);
    pen.close();
}
void draw_rectangle(auto& pen, point low, point high)
{
    draw_polygon(pen, {low, {high.x, low.y}, high, {low.x, high.y}});
}

template <class Plan>
inspect::manifoldness checked_faces(const Plan& plan)
{
    REQUIRE(plan);
    return inspect::check_manifoldness(test::written(*plan).view());
}

}  // namespace

TEST_CASE("thinner letters are merged where their outward bevels meet", "[text]")
{
    recorded_outlines stems{attacked_units};
    REQUIRE(stems.add([](auto& pen) { draw_rectangle(pen, {0, 0}, {400, 800}); }));
    const glyph_run run = test::row_of(0, {0.0, 420.0});
    const auto glyphs_of = [&](float by, float width) {
        text_mesher mesher{stems, embolden{.by = by}, bevelled{.width = width, .outward = true}};
        const auto plan = test::required(mesher.plan(run, {.merge = true}));
        CHECK(inspect::check_closedness(test::written(*plan).view()).is_closed());
        return plan->glyphs().size();
    };
    for (const float by : {0.001f, 0.0f, -0.001f, -0.01f, -0.03f}) CHECK(glyphs_of(by, 0.05f) == 1);
    CHECK(glyphs_of(-0.03f, 0.02f) == 2);
    CHECK(glyphs_of(0.0f, 0.005f) == 2);
}

TEST_CASE("a ring without room for its letter is as high as the ring alone", "[text]")
{
    recorded_outlines stem{attacked_units};
    REQUIRE(stem.add([](auto& pen) { draw_rectangle(pen, {0, 0}, {80, 800}); }));
    text_mesher mesher{
        stem, outlined<extruded<>, extruded<>>{.width = 0.05f, .ring = {.depth = 0.1f}, .letter = {.depth = 0.5f}}};
    const glyph_run run = test::row_of(0, {0.0});
    CHECK(test::required(mesher.plan(run))->bounds().low.z == -0.1f);
}

TEST_CASE("a letter that would grow into its ring is refused like a ring that would grow into its letter", "[text]")
{
    test::toy_font font;
    const auto option_of = [&](const auto& solid) {
        auto mesher = text_mesher{font, solid};
        const auto made = mesher.plan("o");
        return made ? std::string{} : std::string{made.error().option};
    };
    CHECK(option_of(outlined<extruded<>, bevelled>{.letter = {.width = 0.01f, .outward = true}}) == "letter");
    CHECK(option_of(outlined<bevelled, extruded<>>{.ring = {.width = 0.005f, .outward = true}}) == "ring");
    CHECK(option_of(outlined<extruded<>, bevelled>{.letter = {.width = 0.005f}}) == "");
}

TEST_CASE("the bridge that joins a ring's corners leaves room for the letter", "[text]")
{
    for (const double slope : {1.0, 0.5, 0.25}) {
        recorded_outlines waist{attacked_units};
        const double h = 0.02 * attacked_units * std::sqrt(1.0 + slope * slope), rise = 300.0 * slope;
        REQUIRE(waist.add([&](auto& pen) {
            draw_polygon(pen,
                         {{-300, -h - rise}, {0, -h}, {300, -h - rise}, {300, h + rise}, {0, h}, {-300, h + rise}});
        }));
        const glyph_run run = test::row_of(0, {0.0});
        std::uint64_t moved = 0;
        for (int k = -8; k <= 8; ++k) {
            const auto width = static_cast<float>(0.02 + k * 0.5 / (512.0 * attacked_units));
            text_mesher mesher{
                waist, outlined<extruded<>, extruded<>>{
                           .width = width, .mitre_limit = 0.0f, .ring = {.depth = 0.2f}, .letter = {.depth = 0.1f}}};
            for (const touching way : {touching::part, touching::join}) {
                const auto plan = test::required(mesher.plan(run, {.unit = output_unit::font_units, .corners = way}));
                moved += plan->report().corners_moved;
                const auto found = checked_faces(plan);
                CHECK(found.crowded_edges == 0);
                CHECK(found.pinched_points == 0);
            }
        }
        CHECK(moved > 0);
    }
}

TEST_CASE("outward bevels that nearly close a hole leave no walls back to back", "[text]")
{
    for (const double radius : {37.0, 108.0, 114.0}) {
        recorded_outlines ring{attacked_units};
        const auto circle = [](auto& pen, double r, int turn) {
            std::vector<point> corners;
            for (int i = 0; i < 29; ++i) {
                const double a = turn * 6.283185307179586 * i / 29;
                corners.push_back(
                    {200.0 + std::round(512 * r * std::cos(a)) / 512, 200.0 + std::round(512 * r * std::sin(a)) / 512});
            }
            draw_polygon(pen, corners);
        };
        REQUIRE(ring.add([&](auto& pen) { circle(pen, 1.3 * radius, 1), circle(pen, radius, -1); }));
        const glyph_run run = test::row_of(0, {0.0});
        for (int k = 1; k <= 12; ++k) {
            const double apothem = radius * std::cos(3.141592653589793 / 29);
            const bevelled solid{.width = static_cast<float>((apothem - k / 512.0) / attacked_units), .outward = true};
            text_mesher mesher{ring, solid};
            const auto found =
                checked_faces(mesher.plan(run, {.unit = output_unit::font_units, .corners = touching::part}));
            CHECK(found.crowded_edges == 0);
            CHECK(found.pinched_points == 0);
        }
    }
}

TEST_CASE("outward bevels on both sides that nearly close a hole have walls all round what remains", "[text]")
{
    struct near_closed {
        double cells;  // of the width
        double half;   // of the square around the hole
        bevel_profile profile;
        std::vector<point> hole;
    };
    // What remains is turned over by rounding, or meets in a point what was swept before; a cell more or less is right.
    const near_closed found[] = {
        {10691.8057,
         115.30430,
         round_profile(16),
         {{-9972, -4977},
          {-11140, 1212},
          {-8668, 7002},
          {-3533, 10657},
          {2770, 10796},
          {8166, 7585},
          {10971, 1965},
          {10292, -4278},
          {6345, -9163},
          {384, -11139},
          {-5699, -9578}}},
        {47729.828524,
         372.94511,
         {{0, 0}, {0.98f, 0.5f}, {0.98f, 0.8f}, {1, 1}},
         {{50705, 21605}, {44063, -33110}, {-6642, -54714}, {-50705, -21605}, {-44063, 33110}, {6675, 54982}}},
    };
    const glyph_run run = test::row_of(0, {0.0});
    for (const near_closed& f : found)
        for (int k = -4; k <= 4; ++k)
            for (const touching way : {touching::part, touching::join}) {
                recorded_outlines ring{attacked_units};
                REQUIRE(ring.add([&](auto& pen) {
                    draw_rectangle(pen, {200 - f.half, 200 - f.half}, {200 + f.half, 200 + f.half});
                    std::vector<point> hole;
                    for (const point p : f.hole) hole.push_back({200 + p.x / 512, 200 + p.y / 512});
                    draw_polygon(pen, hole);
                }));
                const auto width = static_cast<float>((f.cells + k) / (512 * attacked_units));
                text_mesher mesher{
                    ring, bevelled{.width = width, .bevel_depth = 0.02f, .outward = true, .profile = f.profile}};
                const auto mesh = checked_faces(mesher.plan(run, {.unit = output_unit::font_units, .corners = way}));
                CHECK(mesh.is_manifold());
            }
}

TEST_CASE("a solid chosen at run time names the owners of merged letters and the option to blame", "[text]")
{
    test::toy_font font;
    const glyph_run run = test::row_of(1, {0.0, 300.0});  // two rings that meet
    text_mesher alone{font, extruded<>{}};
    text_mesher<one_of<flat, extruded<>, bevelled>> chosen{font, extruded<>{}};
    const auto a = test::required(alone.plan(run, {.merge = true}));
    const auto b = test::required(chosen.plan(run, {.merge = true}));
    std::size_t owned = 0;
    for (const part p : a->parts())
        for (std::uint32_t t = 0; t < a->range(0, p).index_count / 3; ++t) {
            CHECK(a->owner(0, p, t) == b->owner(0, p, t));
            owned += b->owner(0, p, t) != shared_glyph;
        }
    CHECK(owned > 20);

    text_mesher<one_of<flat, extruded<>>> deep{font, extruded<>{.depth = 3e38f}};
    CHECK(std::string{deep.plan("o", {.size = 1e6}).error().option} == "depth");
}

TEST_CASE("glyphs that fit onto a coarser grid alone do not make it too fine for where they stand", "[text]")
{
    recorded_outlines font{1024.0};
    REQUIRE(font.add([](auto& pen) { draw_rectangle(pen, {20000, 0}, {20800, 800}); }));
    REQUIRE(font.add([](auto& pen) {
        for (int k = 0; k < 6; ++k) draw_polygon(pen, {{0, 7.0 * k}, {1000, 7.0 * k + 0.03}, {0, 7.0 * k + 0.06}});
    }));
    glyph_run run;
    run.units_per_em = 1024.0;
    REQUIRE((run.glyphs.push_back({0, 0, {}}) && run.glyphs.push_back({1, 1, {}})));
    text_mesher mesher{font, embolden{.by = 8.0f / 1024.0f, .mitre_limit = 0.0f}};
    const auto plan = test::required(mesher.plan(run, {.unit = output_unit::font_units, .corners = touching::part}));
    CHECK(plan->glyphs().size() == 2);
    for (const drawn_glyph& g : plan->glyphs())
        CHECK(g.built->cells() * 1024.0 <= cells_told_apart(g.built->ink().high.x / 1024.0, true));
}

TEST_CASE("a profile whose points the tolerance numbers is refused like one with as many steps", "[text]")
{
    test::toy_font font;
    const auto refused = [&](const bevel_profile& profile) {
        text_mesher mesher{font, bevelled{.width = 0.05f, .bevel_depth = 0.05f, .profile = profile}};
        return mesher.plan("o").error() == error::bad_option;
    };
    for (const float high : {1.14f, 1.2f, 1.5f, -0.1f})
        for (const std::uint32_t steps : {0u, 16u, 63u})
            CHECK(refused(bezier_profile({{0.3f, 0.0f}, {0.6f, high}, high < 0.0f ? 0.5f : 1.0f}, steps)));
    CHECK(refused(bezier_profile({{1.5f, 0.0f}, {-0.5f, 1.0f}, 1.0f})));
    CHECK_FALSE(refused(bezier_profile({{0.0f, 0.5f}, {0.5f, 1.0f}, 1.0f})));
    CHECK_FALSE(refused(bezier_profile({{1.0f, 0.0f}, {0.0f, 1.0f}, 1.0f})));
    CHECK(refused(sampled_profile([](float t) noexcept { return t; }, 0xFFFF'FFFFu)));
    CHECK(refused(sampled_profile([](float t) noexcept { return t; }, 64)));
    CHECK_FALSE(refused(sampled_profile([](float t) noexcept { return t; }, 63)));
}

TEST_CASE("bevels that take all the depth and hardly rise are refused for their depth", "[text]")
{
    test::toy_font font;
    const auto option_of = [&](float h) {
        text_mesher mesher{font, bevelled{.depth = 0.2f,
                                          .width = 0.01f,
                                          .bevel_depth = 0.1f,
                                          .profile = {{0.0f, 0.0f}, {0.5f, h}, {1.0f, 1.0f}}}};
        const auto plan = mesher.plan("o");
        return plan ? std::string{} : std::string{plan.error().option};
    };
    CHECK(option_of(3e-8f) == "bevel_depth");
    CHECK(option_of(0.0f) == "bevel_depth");
    CHECK(option_of(0.01f) == "");
}

TEST_CASE("level steps are lit from outside, however smooth they are to be", "[text]")
{
    test::toy_font font;
    for (const bevel_profile& profile : {stepped_profile(), engraved_profile(), concave_profile(3)})
        for (const float crease : {15.0f, 90.0f, 179.0f, 180.0f})
            for (const auto shading : {bevel_shading::by_slope, bevel_shading::rounded}) {
                text_mesher mesher{
                    font,
                    bevelled{.width = 0.02f, .shading = shading, .profile_crease_degrees = crease, .profile = profile}};
                const auto plan = mesher.plan("oE");
                const bool falls = profile.at(bevel_profile::finest).view().back().h < 1.0f;
                CHECK(plan.has_value() != (falls && shading == bevel_shading::rounded));  // which refuses those
                if (!plan) continue;
                const test::lit_mesh m = test::written(*plan);
                CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal).is_right());
            }
}

TEST_CASE("bevels that fit leave a letter its cap, however few joins its corners have", "[text]")
{
    for (const double stem : {30.0, 40.0, 44.0, 60.0})
        for (const float mitre_limit : {1.0f, 1.05f, 1.3f, 1.5f, 2.0f}) {
            recorded_outlines letter{attacked_units};
            REQUIRE(letter.add([&](auto& pen) {
                draw_polygon(pen, {{0, 0}, {400, 0}, {400, stem}, {stem, stem}, {stem, 700}, {0, 700}});
            }));
            const glyph_run run = test::row_of(0, {0.0});
            for (const double tolerance : {quality::low, quality::normal, quality::high}) {
                if (2.0 * tolerance * attacked_units >= stem) continue;  // no circle of the tolerance has room
                text_mesher mesher{letter,
                                   bevelled{.width = 0.1f, .mode = bevel_mode::fit, .mitre_limit = mitre_limit}};
                const auto plan = test::required(mesher.plan(run, {.tolerance = tolerance}));
                CHECK(plan->report().lost_caps == 0);
                CHECK(plan->range(part::front).index_count != 0);
            }
        }
}
