// SPDX-License-Identifier: MIT
//
// text_options::corners: every edge of the mesh as it is written has two faces, and round every point its faces make one
// fan, whatever touches in the letters, wherever they stand.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/tapered.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/outline/transformed_outlines.hpp>
#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <type_traits>
#include <vector>

using namespace typemesh;

namespace {

void polygon(auto& pen, const std::vector<point>& corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i) i == 0 ? pen.move(corners[0]) : pen.line(corners[i]);
    pen.close();
}

void square(auto& pen, double x, double y, double size)
{
    polygon(pen, {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
}

void circle(auto& pen, point at, double r, double turn)
{
    const double k = 0.5522847498307936 * r * turn;
    pen.move({at.x + r, at.y});
    pen.cubic({at.x + r, at.y + k}, {at.x + k * turn, at.y + r * turn}, {at.x, at.y + r * turn});
    pen.cubic({at.x - k * turn, at.y + r * turn}, {at.x - r, at.y + k}, {at.x - r, at.y});
    pen.cubic({at.x - r, at.y - k}, {at.x - k * turn, at.y - r * turn}, {at.x, at.y - r * turn});
    pen.cubic({at.x + k * turn, at.y - r * turn}, {at.x + r, at.y - k}, {at.x + r, at.y});
    pen.close();
}

constexpr glyph_id two_squares = 0, checkerboard = 4;
constexpr glyph_id random_glyphs = 24;

/// A font of drawings that touch themselves. Everything in it is 1 em wide.
recorded_outlines touching_font(std::uint32_t seed = 1)
{
    recorded_outlines font{1000.0};
    REQUIRE(font.add([](auto& pen) { square(pen, 0, 0, 300), square(pen, 300, 300, 300); }));
    REQUIRE(font.add(
        [](auto& pen) { square(pen, 0, 0, 800), polygon(pen, {{100, 100}, {100, 700}, {700, 700}, {700, 100}}); }));
    REQUIRE(font.add([](auto& pen) {
        polygon(pen, {{0, 0}, {900, 0}, {900, 900}, {0, 900}, {0, 300}});
        polygon(pen, {{0, 300}, {300, 600}, {300, 300}});
    }));
    REQUIRE(font.add([](auto& pen) {
        circle(pen, {200, 500}, 200, 1), circle(pen, {600, 500}, 200, 1);
        circle(pen, {300, 500}, 100, -1), circle(pen, {700, 500}, 100, -1);
    }));
    REQUIRE(font.add([](auto& pen) {
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                if ((x + y) % 2 == 0) square(pen, 125 * x, 125 * y, 125);
    }));
    std::mt19937 random{seed};
    for (glyph_id g = 0; g < random_glyphs; ++g)
        REQUIRE(font.add([&](auto& pen) {
            const auto number = [&](unsigned n) { return static_cast<int>(random() % n); };
            const double unit = g % 3 == 0 ? 125 : g % 3 == 1 ? 62.5 : 0.25;  // of the last a checkerboard is a speck
            const double slant = 0.25 * number(4);
            const auto at = [&](int x, int y) { return point{unit * x + slant * unit * y, unit * y}; };
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 6; ++x) {
                    const int kind = number(5);
                    if (kind == 0) polygon(pen, {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
                    if (kind == 1) polygon(pen, {at(x, y), at(x + 1, y), at(x + 1, y + 1)});
                    if (kind == 2) polygon(pen, {at(x, y), at(x + 1, y + 1), at(x, y + 1)});
                }
            square(pen, 900, 900, 50);
        }));
    return font;
}

/// All glyphs of the font, 1.5 em apart, or touching each other; from (x, y) em on.
glyph_run all_of(const recorded_outlines& font, double apart = 1.5, point from = {})
{
    glyph_run run;
    run.units_per_em = 1000.0;
    for (glyph_id g = 0; g < font.size(); ++g)
        REQUIRE(run.glyphs.push_back({g, g, {1000.0 * (from.x + apart * g), 1000.0 * from.y}}));
    return run;
}

template <class Plan>
inspect::manifoldness faces_of(const Plan& plan)
{
    return inspect::check_manifoldness(test::written(plan).view());
}

template <class Plan>
void check_manifold(const Plan& plan)
{
    REQUIRE(plan);
    const inspect::manifoldness found = faces_of(*plan);
    CHECK(found.open_edges == 0);
    CHECK(found.crowded_edges == 0);
    CHECK(found.pinched_points == 0);
    CHECK(found.bad_triangles == 0);
    CHECK(plan->report().touching == 0);
    if (plan->report().refused != 0) CHECK(plan->report().first_refusal == error::nothing_left);
}

template <class Extruder>
void check_extruder(const Extruder& how)
{
    const recorded_outlines font = touching_font();
    const glyph_run run = all_of(font);
    auto monotone_mesher = text_mesher{font}.with(how);
    auto delaunay_mesher = text_mesher{font}.with(how).with(constrained_delaunay{});
    for (const touching way : {touching::part, touching::join}) {
        const text_options options{.corners = way};
        check_manifold(monotone_mesher.plan(run, options));
        check_manifold(delaunay_mesher.plan(run, options));
    }
}

/// Contours that cross and touch. Rounding leaves edges of slopes between two points of their outline.
constexpr const char* crossing_drawings[] = {
    "M300 400L600 400L600 100L300 100ZM500 400C500 510.45695 455.228475 600 400 600C344.771525 600 300 510.45695 "
    "300 400C300 289.54305 344.771525 200 400 200C455.228475 200 500 289.54305 500 400Z",
    "M0 420L120 0L360 300L300 240L60 180L120 420ZM360 240L420 240L420 420L360 420Z",
    "M600 375C600 499.264 566.421 600 525 600C483.579 600 450 499.264 450 375C450 250.736 483.579 150 525 150C"
    "566.421 150 600 250.736 600 375ZM450 150L525 300L600 150L525 0ZM450 450L600 450L600 150L450 150Z"};

constexpr float half_root = 0.70710678f;
constexpr frame slanted_frame{
    .right = {half_root, half_root, 0}, .up = {-0.5f, 0.5f, half_root}, .toward = {0.5f, -0.5f, half_root}};

constexpr bevelled meeting_bevels{.width = 0.05f, .bevel_depth = 0.1f};

template <class Font, class Extruder>
double volume_with(Font& font, const Extruder& how, const text_options& options)
{
    const glyph_run run = test::row_of(0, {0.0});
    auto mesher = text_mesher{font}.with(how);
    const auto plan = test::required(mesher.plan(run, options));
    return inspect::measure(test::written(*plan).view()).volume;
}

/// Checks a solid that has no walls while corners are kept. Returns the number of triangles of its low walls.
template <class Font, class Extruder>
std::size_t low_walls_of(Font& font, const Extruder& how, text_options options = {.merge = true})
{
    glyph_run run = test::row_of(0, {0.0});
    run.units_per_em = font.units_per_em();
    auto mesher = text_mesher{font}.with(how);
    const auto kept = test::required(mesher.plan(run, options));
    CHECK(kept->range(part::side).index_count == 0);
    std::size_t walls = 0;
    for (const touching way : {touching::part, touching::join}) {
        options.corners = way;
        const auto plan = mesher.plan(run, options);
        check_manifold(plan);
        walls += plan->range(part::side).index_count / 3;
    }
    return walls;
}

/// Low walls add to a solid what is lower than their end, and nothing else. `bend` makes the solid of its bevels.
template <class Font, class Bend>
void check_added_volume(Font& font, bevelled slopes, const Bend& bend, double stretch)
{
    const double ends = slopes.sides == bevel_sides::both ? 2.0 : 1.0, cells = 4.0 / 512000.0;
    const double low = slopes.segments * (std::max)(cells, 0x1p-20 * as_double(slopes.bevel_depth));
    for (const touching way : {touching::part, touching::join}) {
        const text_options options{.merge = true, .corners = way};
        const double area = volume_with(font, extruded<>{.depth = 1.0f}, options);
        slopes.side = true;
        const double volume = volume_with(font, bend(slopes), options);
        slopes.side = false;  // without walls it is closed as well, but not raised
        const double added = volume - volume_with(font, bend(slopes), options);
        CHECK(added > 0.0);
        CHECK(added < stretch * ends * low * area);
    }
}

}  // namespace

TEST_CASE("without the option letters that touch themselves have edges with four faces", "[text]")
{
    const recorded_outlines font = touching_font();
    auto mesher = text_mesher{font};
    const glyph_run run = all_of(font);
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->report().corners_moved == 0);
    CHECK(faces_of(*plan).crowded_edges > 100);
    CHECK(faces_of(*plan).pinched_points > 200);
}

TEST_CASE("corners are parted and joined in plain letters, and counted", "[text]")
{
    check_extruder(extruded<>{});
    const recorded_outlines font = touching_font();
    auto mesher = text_mesher{font};
    const glyph_run run =
        test::run_of({{two_squares, 0, {}}, {checkerboard, 1, {2000, 0}}, {two_squares, 2, {4000, 0}}});
    for (const touching way : {touching::part, touching::join}) {
        const auto plan = mesher.plan(run, {.corners = way});
        check_manifold(plan);
        CHECK(plan->report().corners_moved == 1 + 49 + 1);
        const test::lit_mesh mesh = test::written(*plan);
        CHECK(inspect::check_normals(mesh.view(), &test::lit_vertex::normal).is_right());
    }
}

TEST_CASE("corners are parted and joined in bevelled letters", "[text]")
{
    check_extruder(bevelled{});
    check_extruder(bevelled{.width = 0.03f, .profile = round_profile(3)});
}

TEST_CASE("steps of a bevel lean, so that those of a ring have two faces an edge", "[text]")
{
    check_extruder(bevelled{.width = 0.05f, .profile = stepped_profile()});
    check_extruder(bevelled{.width = 0.05f, .profile = engraved_profile()});
    // Within a ring of uneven width both sides of a step touch where it is as wide as twice the step's distance.
    recorded_outlines uneven{1000.0};
    REQUIRE(uneven.add([](auto& pen) { circle(pen, {400, 400}, 400, 1), circle(pen, {430, 400}, 300, -1); }));
    const glyph_run run = test::row_of(0, {0.0});
    std::size_t crowded = 0;
    for (int i = 0; i < 20; ++i) {
        const float t = 0.4325f + 0.0005f * static_cast<float>(i);
        auto mesher =
            text_mesher{uneven}.with(bevelled{.width = 0.08f, .profile = {{0, 0}, {t, 0.3f}, {t, 0.7f}, {1, 1}}});
        const auto plan = test::required(mesher.plan(run));
        crowded += faces_of(*plan).crowded_edges;
        for (const touching way : {touching::part, touching::join}) check_manifold(mesher.plan(run, {.corners = way}));
    }
    CHECK(crowded > 0);
}

TEST_CASE("front and back of solids without walls do not meet inside the outline", "[text]")
{
    const auto check = [&](const auto& how) {
        for (const char* drawing : crossing_drawings) {
            svg_path outline{drawing, 1000.0};
            CHECK(low_walls_of(outline, how) > 0);
            if constexpr (std::is_same_v<decltype(how), const bevelled&>)
                check_added_volume(outline, how, [](const bevelled& slopes) { return slopes; }, 1.0);
        }
    };
    for (const std::uint32_t segments : {1u, 16u})
        check(bevelled{.width = 0.05f, .bevel_depth = 0.1f, .segments = segments});
    check(bevelled{.width = 0.05f, .bevel_depth = 0.2f, .sides = bevel_sides::back});
    check(bevelled{.depth = 4096.0f, .width = 0.05f, .bevel_depth = 2048.0f});  // where floats lose four cells
    check(tapered{});
    check(tapered{.degrees = 80.0f, .centred = true});
    check(carved{});
    check(carved{.max_depth = 0.01f, .as = carving::cutter});
}

TEST_CASE("low walls stand in drawings that are turned and mirrored, and in every frame", "[text]")
{
    std::size_t walls = 0;
    for (const affine& turned :
         {affine{.xx = 0, .xy = -1, .yx = 1, .yy = 0}, affine{.xx = -1, .yy = -1}, affine{.xx = -1},
          affine{.xx = 0, .xy = 1, .yx = 1, .yy = 0}, affine{.xx = 0.8, .xy = -0.6, .yx = 0.6, .yy = 0.8}})
        for (const char* drawing : crossing_drawings) {
            svg_path outline{drawing, 1000.0};
            transformed_outlines<svg_path> font{outline, turned};
            for (const frame& f : {right_handed_y_up, left_handed_y_up, slanted_frame})
                walls += low_walls_of(font, meeting_bevels, {.frame = f, .merge = true});
            walls += low_walls_of(font, tapered{});
        }
    CHECK(walls > 0);
}

TEST_CASE("low walls are the same whichever unit depths are in", "[text]")
{
    const auto written_with = [](svg_path& outline, const bevelled& how, const text_options& options) {
        auto mesher = text_mesher{outline}.with(how);
        const glyph_run run = test::row_of(0, {0.0, 100000.0});
        const auto plan = mesher.plan(run, options);
        check_manifold(plan);
        return test::written(*plan);
    };
    const auto check = [&](svg_path& outline, float size, const frame& f, touching way) {
        bevelled how = meeting_bevels;
        text_options options{.size = as_double(size), .frame = f, .merge = true, .corners = way};
        const auto in_em = written_with(outline, how, options);
        how.depth *= size;
        how.bevel_depth *= size;
        options.depth_in = depth_unit::output;
        CHECK(written_with(outline, how, options) == in_em);
    };
    for (const char* drawing : crossing_drawings) {
        svg_path outline{drawing, 1000.0};
        for (const float size : {0x1p-6f, 0x1p10f})  // powers of two: all products are exact
            for (const frame& f : {right_handed_y_up, slanted_frame})
                for (const touching way : {touching::part, touching::join}) check(outline, size, f, way);
    }
}

TEST_CASE("walls that are lower than low walls are raised to them", "[text]")
{
    const auto check = [](const bevelled& how, const text_options& options, double x) {
        svg_path outline{crossing_drawings[0], 1000.0};
        auto mesher = text_mesher{outline}.with(how);
        const glyph_run run = test::row_of(0, {x});
        check_manifold(mesher.plan(run, options));
    };
    bevelled thin{.depth = 1.0f, .width = 0.02f, .bevel_depth = std::nextafter(1.0f, 0.0f), .segments = 3};
    for (const bevel_sides sides : {bevel_sides::front, bevel_sides::back}) {
        thin.sides = sides;
        check(thin, {.size = 0.01, .merge = true, .corners = touching::part}, 0.0);
    }
    thin.sides = bevel_sides::both;
    thin.depth = std::nextafter(2.0f, 3.0f);
    for (const float width : {0.02f, 1e-6f}) {  // the second is narrower than four cells
        thin.width = width;
        check(thin, {.merge = true, .corners = touching::part}, 0.0);
    }
    const bevelled both{.width = 0.05f, .bevel_depth = 0.0999999f};
    for (const double x : {0.0, 5000.0, 20000.0})
        check(both, {.frame = slanted_frame, .merge = true, .corners = touching::part}, x);
    // A riser within the height of the walls keeps a height of its own.
    bevelled steep{.depth = 0.2001f, .width = 0.05f, .bevel_depth = 0.1f, .segments = 16};
    for (const auto& profile : {bevel_profile{{0, 0}, {0, 0.001f}, {1, 1}},
                                bevel_profile{{0, 0}, {0.5f, 0.0001f}, {0.5f, 0.0002f}, {1, 1}}}) {
        steep.profile = profile;
        check(steep, {.merge = true, .corners = touching::part}, 0.0);
    }
}

TEST_CASE("low walls grow to four cells for each segment, and no higher", "[text]")
{
    svg_path outline{crossing_drawings[0], 1000.0};
    const auto walls_at = [&](double x, std::uint32_t segments) {
        auto mesher = text_mesher{outline}.with(
            bevelled{.depth = 0.25f, .width = 0.05f, .bevel_depth = 0.125f - 0x1p-14f, .segments = segments});
        const glyph_run run = test::row_of(0, {x});
        const test::lit_mesh mesh =
            test::written(*test::required(mesher.plan(run, {.merge = true, .corners = touching::part})));
        float low = 0.0f, high = -1.0f;
        for (const test::lit_vertex& v : mesh.vertices)
            if (v.of == part::side) low = (std::min)(low, v.place.z), high = (std::max)(high, v.place.z);
        return as_double(high) - as_double(low);
    };
    CHECK(walls_at(0.0, 1) == 0x1p-13);  // higher than four cells
    for (const std::uint32_t segments : {1u, 16u})
        CHECK(walls_at(1000000.0, segments) == Catch::Approx(4.0 * segments / 8000.0).epsilon(1e-4));
}

TEST_CASE("a profile that comes back to the other side's height has low walls, with a riser at the outline, too",
          "[text]")
{
    for (const auto& profile :
         {bevel_profile{{0, 0}, {0, 0.5f}, {0.5f, 1e-6f}, {1, 1}}, bevel_profile{{0, 0}, {0, 0.5f}, {1, 1e-6f}}}) {
        bevelled how = meeting_bevels;
        how.profile = profile;
        for (const char* drawing : crossing_drawings) {
            svg_path outline{drawing, 1000.0};
            CHECK(low_walls_of(outline, how, {.frame = slanted_frame, .merge = true}) > 0);
        }
    }
    // Narrower than four cells, and lower: no riser is left, and the walls grow to four cells.
    bevelled step{.width = 1e-6f, .bevel_depth = 0.1f, .profile = {{0, 0}, {1, 1e-6f}}};
    svg_path outline{crossing_drawings[0], 1000.0};
    auto mesher = text_mesher{outline}.with(step);
    const glyph_run run = test::row_of(0, {0.0});
    for (const touching way : {touching::part, touching::join})
        check_manifold(mesher.plan(run, {.frame = slanted_frame, .merge = true, .corners = way}));
}

TEST_CASE("risers that end little above low walls have a height", "[text]")
{
    bevelled thin{.depth = std::nextafter(0.125f, 1.0f), .width = 0.05f, .bevel_depth = 0.0625f, .segments = 7};
    for (const double cells : {0.0, 0.001, 0.02, 4.0}) {
        thin.profile = {{0, 0}, {0, static_cast<float>((7 * 4.0 + cells) / (0.0625 * 512000.0))}, {1, 1}};
        for (const char* drawing : crossing_drawings) {
            svg_path outline{drawing, 1000.0};
            auto mesher = text_mesher{outline}.with(thin);
            const glyph_run run = test::row_of(0, {0.0});
            for (const touching way : {touching::part, touching::join})
                check_manifold(mesher.plan(run, {.merge = true, .corners = way}));
        }
    }
}

TEST_CASE("front and back of a balloon share no edge wherever it stands, in a slanted frame, too", "[text]")
{
    svg_path outline{crossing_drawings[2], 1000.0};
    for (const float height : {1.0f, 0.1f}) {
        auto mesher = text_mesher{outline}.with(inflated{.height = height, .edge = 0.1f});
        for (const double x : {0.0, 20000.0, 100000.0}) {
            const glyph_run run = test::row_of(0, {x});
            for (const touching way : {touching::part, touching::join})
                check_manifold(mesher.plan(run, {.frame = slanted_frame, .merge = true, .corners = way}));
        }
    }
}

TEST_CASE("a balloon is the same whether its height is in em or in output units", "[text]")
{
    svg_path outline{crossing_drawings[2], 1000.0};
    const glyph_run run = test::row_of(0, {100000.0});
    const auto points = [&](double size, depth_unit unit) {
        const auto height = static_cast<float>(unit == depth_unit::em ? 1.0 : size);
        auto mesher = text_mesher{outline}.with(inflated{.height = height, .edge = 0.1f});
        const text_options options{
            .size = size, .depth_in = unit, .frame = slanted_frame, .merge = true, .corners = touching::part};
        std::vector<vec3> vertices;
        std::vector<std::uint32_t> indices;
        CHECK(test::required(mesher.plan(run, options))->write(into(vertices, indices)));
        return vertices;
    };
    for (const double size : {0.01, 1000.0}) {
        const auto in_em = points(size, depth_unit::em), in_output = points(size, depth_unit::output);
        REQUIRE(in_em.size() == in_output.size());
        double farthest = 0.0;
        for (std::size_t i = 0; i < in_em.size(); ++i)
            for (float vec3::* const axis : {&vec3::x, &vec3::y, &vec3::z})
                farthest = (std::max)(farthest, std::abs(static_cast<double>(in_em[i].*axis - in_output[i].*axis)));
        CHECK(farthest < 1e-4 * size);
    }
}

TEST_CASE("a bevel without a depth is no slope that could touch the other side", "[text]")
{
    svg_path outline{crossing_drawings[0], 1000.0};
    for (const float depth : {0.2f, 1e-9f}) {
        auto mesher = text_mesher{outline}.with(bevelled{.depth = depth, .width = 0.05f, .bevel_depth = 0.0f});
        const glyph_run run = test::row_of(0, {0.0});
        CHECK(test::required(mesher.plan(run, {.corners = touching::part}))->report().touching == 0);
    }
}

TEST_CASE("low walls are bent with their solids", "[text][bent]")
{
    const auto check = [](const bevelled& slopes, const auto& bend) {
        for (const char* drawing : crossing_drawings) {
            svg_path outline{drawing, 1000.0};
            CHECK(low_walls_of(outline, bend(slopes)) > 0);
            check_added_volume(outline, slopes, bend, 2.0);
        }
    };
    check(meeting_bevels, [](const bevelled& b) { return bent<on_cylinder, bevelled>{b, {.radius = 0.7}}; });
    check(meeting_bevels, [](const bevelled& b) { return bent<twist, bevelled>{b, {.degrees_per_em = 40.0}}; });
    check(tapered{}.walls(), [](const bevelled& b) { return bent<on_cylinder, bevelled>{b, {.radius = -0.7}}; });
}

TEST_CASE("bent letters are planned at the rounded pens where they are written", "[text][bent]")
{
    recorded_outlines font{1000.0};
    REQUIRE(font.add([](auto& pen) { circle(pen, {400, 400}, 400, 1), circle(pen, {430, 400}, 300, -1); }));
    auto mesher = text_mesher{font}.with(bent<on_cylinder, extruded<>>{{}, {.radius = 12.0f}});
    for (const frame& f : {right_handed_y_up, slanted_frame})
        for (double x = 100.0; x < 140.0; x += 1.43456789) {
            glyph_run run;
            run.units_per_em = 1000.0;
            REQUIRE(run.glyphs.push_back({0, 0, {1000.0 * x, 303.71}}));
            const auto plan = test::required(mesher.plan(run, {.frame = f, .merge = true, .corners = touching::part}));
            const bounds3 planned = plan->bounds();
            bounds3 all = planned;
            for (const test::lit_vertex& v : test::written(*plan).vertices) all.add(v.place);
            CHECK(all.low == planned.low);
            CHECK(all.high == planned.high);
        }
}

TEST_CASE("slopes that end outside the letter have low walls where they are low inside", "[text]")
{
    // Slopes meet in the gaps between its parts.
    svg_path drawing{
        "M702 563Q479 563 393 512Q307 461 307 338Q307 240 371.5 182.5Q436 125 547 125Q700 125 792.5 233.5Q885 342 885 "
        "522L885 563ZM1069 639L1069 0L885 0L885 170Q822 68 728 19.5Q634 -29 498 -29Q326 -29 224.5 67.5Q123 164 123 326"
        "Q123 515 249.5 611Q376 707 627 707L885 707L885 725Q885 852 801.5 921.5Q718 991 567 991Q471 991 380 968"
        "Q289 945 205 899L205 1069Q306 1108 401 1127.5Q496 1147 586 1147Q829 1147 949 1021Q1069 895 1069 639Z"
        "M489 1516L693 1516L693 1311L489 1311ZM293 1780L891 1780L891 1632L293 1632Z",
        2048.0};
    transformed_outlines<svg_path> letter{drawing, affine{.yy = -1}};
    CHECK(low_walls_of(letter, bevelled{.width = 0.04f, .bevel_depth = 0.1f, .outward = true}, {}) > 0);
    CHECK(low_walls_of(letter, bevelled{.width = 0.03f, .bevel_depth = 0.1f, .outward = true}, {}) == 0);
}

TEST_CASE("solids without walls that are not given any report that front and back meet", "[text]")
{
    svg_path outline{"M0 420L120 0L360 300L300 240L60 180L120 420ZM360 240L420 240L420 420L360 420Z", 1000.0};
    const glyph_run run = test::row_of(0, {0.0});
    const text_options options{.merge = true, .corners = touching::part};
    const bevelled open{.width = 0.05f, .bevel_depth = 0.1f, .side = false};
    auto mesher = text_mesher{outline}.with(open);
    const auto plan = test::required(mesher.plan(run, options));
    CHECK(plan->report().touching == 1);
    CHECK(faces_of(*plan).crowded_edges > 0);
    // A groove has no lid that could meet its slopes, and an ordinary letter needs no wall.
    auto groove = text_mesher{outline}.with(carved{.as = carving::groove});
    const auto carved_in = test::required(groove.plan(run, options));
    CHECK(carved_in->report().touching == 0);
    CHECK(carved_in->range(part::side).index_count == 0);
    recorded_outlines plain{1000.0};
    REQUIRE(plain.add([](auto& pen) { circle(pen, {400, 400}, 400, 1), circle(pen, {430, 400}, 300, -1); }));
    auto leaning = text_mesher{plain}.with(tapered{});
    const auto without = leaning.plan(run, options);
    check_manifold(without);
    CHECK(without->range(part::side).index_count == 0);
}

TEST_CASE("corners are parted and joined in letters with outward bevels", "[text]")
{
    check_extruder(bevelled{.width = 0.01f, .outward = true});
    // Squares half of whose distance is the width would touch all along their sides.
    recorded_outlines pair{1000.0};
    REQUIRE(pair.add([](auto& pen) { square(pen, 0, 0, 300), square(pen, 340, 0, 300); }));
    const glyph_run run = test::row_of(0, {0.0});
    for (const float width : {0.02f, 0.01999f, 0.02001f}) {
        auto mesher = text_mesher{pair}.with(bevelled{.width = width, .outward = true, .mitre_limit = 0.0f});
        for (const touching way : {touching::part, touching::join}) check_manifold(mesher.plan(run, {.corners = way}));
    }
}

TEST_CASE("corners are parted and joined in bold, thin and hollow letters", "[text]")
{
    check_extruder(embolden{.by = 0.01f});
    check_extruder(embolden{.by = -0.0625f});  // squares of 1/8 em vanish, those that touch keep a bridge or none
    check_extruder(outlined<>{.width = 0.01f});
    check_extruder(outlined<extruded<>, extruded<>>{.width = 0.02f, .place = outline_place::centre});
    check_extruder(outlined<extruded<>, extruded<>>{.width = 0.02f, .place = outline_place::outer});
    check_extruder(outlined<bevelled, extruded<>>{.width = 0.02f, .ring = {.width = 0.004f}});
}

TEST_CASE("letters that touch each other are merged first", "[text]")
{
    const recorded_outlines font = touching_font();
    for (const double apart : {0.625, 0.75, 0.9375, 1.0, 1.0 / 3.0}) {
        const glyph_run run = all_of(font, apart, {1.0 / 3.0, 0.1});
        auto mesher = text_mesher{font};
        auto bevels = text_mesher{font}.with(bevelled{.width = 0.01f});
        for (const touching way : {touching::part, touching::join}) {
            const text_options options{.merge = true, .corners = way};
            check_manifold(mesher.plan(run, options));
            check_manifold(bevels.plan(run, options));
        }
    }
}

TEST_CASE("edges have two faces wherever a letter stands, in every unit and frame", "[text]")
{
    const recorded_outlines font = touching_font(2);
    auto mesher = text_mesher{font};
    for (const point from :
         {point{}, point{-3, 7}, point{100, -60}, point{1500, 0.3}, point{-1000, 2000}, point{15000, 0}}) {
        const glyph_run run = all_of(font, 1.37, from);
        for (const auto& at : {right_handed_y_up, left_handed_y_up, right_handed_z_up, slanted_frame})
            for (const output_unit unit :
                 {output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box}) {
                const bool far = std::fabs(from.x) > 500.0;
                if (far && !at.is_along_axes()) continue;
                check_manifold(mesher.plan(run, {.unit = unit,
                                                 .size = 0.37,
                                                 .frame = at,
                                                 .corners = from.y < 0 ? touching::join : touching::part}));
            }
    }
}

TEST_CASE("letters that reach far beyond their pens have a grid for that, too", "[text]")
{
    recorded_outlines font{1000.0};
    REQUIRE(font.add([](auto& pen) {
        for (int i = 0; i < 2000; ++i) square(pen, 700000 + 0.25 * i, 0.25 * i, 0.25);
        square(pen, 0, 0, 500);
    }));
    const glyph_run run = test::row_of(0, {0.0});
    auto mesher = text_mesher{font};
    for (const touching way : {touching::part, touching::join}) {
        const auto plan = mesher.plan(run, {.corners = way});
        check_manifold(plan);
        CHECK(plan->glyphs()[0].built->cells() < 16.0);
    }
}

TEST_CASE("the grid goes by the place, and near the origin it is the font's", "[text]")
{
    const recorded_outlines font = touching_font();
    auto mesher = text_mesher{font};
    const auto cells_at = [&](point from, touching way) {
        const glyph_run run = all_of(font, 0.0, from);
        const auto plan = test::required(mesher.plan(run, {.corners = way}));
        return plan->glyphs()[0].built->cells();
    };
    CHECK(same(cells_at({}, touching::part), 512.0));
    CHECK(same(cells_at({5, 5}, touching::part), 512.0));
    CHECK(same(cells_at({60, 0}, touching::part), 128.0));
    CHECK(same(cells_at({60, 0}, touching::keep), 512.0));
    CHECK(same(cells_at({0, -900}, touching::join), 8.0));
}

TEST_CASE("a cache distinguishes parted, joined and kept letters, and letters on different grids", "[text]")
{
    const recorded_outlines font = touching_font();
    glyph_cache<> cache;
    auto cached = text_mesher{font}.with(cached_in{cache, 1});
    auto alone = text_mesher{font};
    for (int twice = 0; twice < 2; ++twice)
        for (const touching way : {touching::keep, touching::part, touching::join})
            for (const double x : {0.0, 60.0}) {
                const glyph_run run = all_of(font, 1.5, {x, 0});
                const text_options options{.corners = way};
                const auto expected = alone.plan(run, options), found = cached.plan(run, options);
                REQUIRE((expected && found));
                CHECK(test::written(*expected) == test::written(*found));
                CHECK(expected->report().corners_moved == found->report().corners_moved);
            }
    CHECK(cache.statistics().entries == 5 * font.size());
}

TEST_CASE("several workers part the same corners", "[text]")
{
    const recorded_outlines font = touching_font();
    const glyph_run run = all_of(font, 0.75);
    for (const touching way : {touching::part, touching::join})
        for (const bool merge : {false, true}) {
            const text_options options{.merge = merge, .corners = way};
            auto mesher = text_mesher{font};
            const auto expected = test::required(mesher.plan(run, options));
            const test::lit_mesh mesh = test::written(*expected);
            for (const std::size_t count : {std::size_t{1}, std::size_t{3}}) {
                test::scrambled_workers pool{count};
                auto workers = workers_of(pool, [&](std::size_t) noexcept {
                    return result{transformed_outlines<const recorded_outlines>{font, affine{}}};
                });
                REQUIRE(workers);
                auto team = text_mesher{font};
                const auto made = test::required(team.plan(run, options, *workers));
                CHECK(test::written(*made) == mesh);
                CHECK(made->report().corners_moved == expected->report().corners_moved);
            }
        }
}

TEST_CASE("memory may fail while corners are parted, and nothing is allocated the second time", "[text]")
{
    const recorded_outlines font = touching_font();
    const glyph_run run = all_of(font, 0.75);
    const text_options options{.merge = true, .corners = touching::part};
    test::counting_memory counted;
    auto mesher = text_mesher{font, counted.source()}.with(outlined<>{.width = 0.01f});
    bool done = false;
    for (std::size_t request = 1; !done; request += 1 + request / 16) {
        REQUIRE(request < 5000);
        counted.fail_at = counted.requests + request;
        const auto made = mesher.plan(run, options);
        done = static_cast<bool>(made);
        if (!done) CHECK(made.error() == error::out_of_memory);
        if (!done) mesher.trim();
    }
    counted.fail_at = 0;
    REQUIRE(mesher.plan(run, options));
    REQUIRE(mesher.plan(run, options));
    const std::size_t before = counted.requests;
    REQUIRE(mesher.plan(run, options));
    CHECK(counted.requests == before);
}
