// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_vertices.hpp>

#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/texture.hpp>

#include <cmath>
#include <vector>

#include "plain_sweep.hpp"
#include "shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// The vertices of what is swept already, with the sides that are there.
void make_vertices(const region& r, const profile_levels& levels, bevel_vertices::sharing how, bevel_data& data)
{
    REQUIRE(add_strips(levels, 30.0f, bevel_shading::by_slope, data.of<bevel_strip>()));
    workspace space;
    workspace::scope scratch{space};
    bevel_light light{em_mapping::after_seam};
    REQUIRE(light.prepare(r, data.of<side_point>().view(), data.swept, scratch));
    REQUIRE_FALSE(bevel_vertices{data, light, how}.make(levels, scratch));
}

/// The bevel of a shape swept by the plainest of sweeps, 20 units wide and deep.
void make_plain_bevel(const shapes::shape& s, const profile_points& points, bevel_vertices::sharing how,
                      bevel_data& data)
{
    const region r = s.made();
    REQUIRE(plan_sides(r, curve_normals{}, texture_mapping::em, data.of<side_point>()));
    const profile_scale scale{10240.0, 10240.0, 0.0};
    const profile_levels levels{points, scale};
    std::vector<double> distances;
    for (const profile_level& l : levels.view()) distances.push_back(l.distance);
    sweeps::plain_sweep{}(r, {distances, 0.0, 0.0}, data.swept);
    make_vertices(r, levels, how, data);
}

/// A roof over a polygon, given by hand: all its faces meet in (0, 0).
struct roof {
    std::vector<point> corners;
    std::uint32_t n;
    double width;
    contours loops;
    std::vector<curve> curves{shapes::line({0, 0}, {1, 0})};
    bevel_data data;

    roof(std::vector<point> p, double w)
        : corners{std::move(p)}, n{static_cast<std::uint32_t>(corners.size())}, width{w}
    {
        for (const point c : corners) {
            const grid_point at{static_cast<std::int32_t>(c.x), static_cast<std::int32_t>(c.y)};
            REQUIRE(
                (loops.points.push_back(at) && loops.edges.push_back({}) && data.swept.nodes.push_back({at, 0.0f})));
        }
        loops.curves = curves;
        REQUIRE((loops.starts.push_back(0) && loops.starts.push_back(n) &&
                 data.swept.nodes.push_back({{0, 0}, static_cast<float>(width)})));
        for (std::uint32_t i = 0; i < n; ++i)
            REQUIRE((data.swept.cells.push_back({i, 0, i}) && data.swept.triangles.push_back({i, (i + 1) % n, n})));
        REQUIRE((data.swept.cells.push_back({0, 0, n}) && data.swept.levels.push_back(0.0) &&
                 data.swept.levels.push_back(width)));
    }

    region made() const { return region::proven(loops, 0, 1); }
    void make(bevel_vertices::sharing how)
    {
        make_vertices(made(), profile_levels{{{0, 0}, {1, 1}}, {width, width, 0.0}}, how, data);
    }
};

std::vector<point> regular(std::uint32_t n, double radius)
{
    std::vector<point> p;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double a = 6.283185307179586 * i / n;
        p.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    return p;
}

constexpr bevel_vertices::sharing everything_near{0.966, 512.0};

const std::vector<triangle> pyramid{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

/// Slopes over a square of 2000 cells, 1024 wide, whose points from the fifth on lie inside at these distances. Whether
/// they are low inside.
bool is_low(const std::vector<swept_node>& inside, const std::vector<triangle>& triangles, float low,
            const profile_points& profile = {{0, 0}, {1, 1}})
{
    roof square{{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}}, 1024.0};
    swept_region& swept = square.data.swept;
    swept.nodes.truncate(4);
    swept.cells.clear();
    swept.triangles.clear();
    for (const swept_node& n : inside) REQUIRE(swept.nodes.push_back(n));
    for (std::uint32_t i = 0; i < 4; ++i)
        REQUIRE((swept.edges_at.push_back({i, i, (i + 1) % 4}) && swept.cells.push_back({i, 0, i == 0 ? 0u : 4u})));
    for (const triangle& t : triangles) REQUIRE(swept.triangles.push_back(t));
    for (std::size_t c = 1; c < 4; ++c) swept.cells[c].first_triangle = static_cast<std::uint32_t>(triangles.size());
    REQUIRE((swept.cells.push_back({0, 0, static_cast<std::uint32_t>(triangles.size())}) &&
             swept.at_level.push_back(0) && swept.at_level.push_back(4) && swept.at_level.push_back(4)));
    const region r = square.made();
    REQUIRE(plan_sides(r, curve_normals{}, texture_mapping::em, square.data.of<side_point>()));
    const profile_levels levels{profile, {1024.0, 1024.0, 0.0}};
    REQUIRE(add_strips(levels, 30.0f, bevel_shading::by_slope, square.data.of<bevel_strip>()));
    workspace space;
    workspace::scope scratch{space};
    bevel_light light{em_mapping::after_seam};
    REQUIRE(light.prepare(r, square.data.of<side_point>().view(), swept, scratch));
    bevel_vertices vertices{square.data, light, everything_near};
    REQUIRE_FALSE(vertices.make(levels, scratch));
    const auto found = vertices.is_low_inside(low, scratch);
    REQUIRE(found);
    return *found;
}

}  // namespace

TEST_CASE("a bevel has one triangle for each of the sweep's, and two for each edge at a riser", "[bevel_vertices]")
{
    const profile_points points{{0, 0}, {0.5f, 0.25f}, {0.5f, 0.75f}, {1, 1}};
    const shapes::shape all[] = {shapes::letter_e(), shapes::letter_d(8), shapes::ring(8)};
    for (const auto& s : all) {
        INFO(s.name);
        bevel_data data;
        make_plain_bevel(s, points, everything_near, data);
        const auto vertices = data.of<bevel_vertex>().view();
        CHECK(data.of<bevel_triangle>().size() == 6 * s.points());
        std::vector<bool> used(vertices.size());
        for (const auto& [t] : data.of<bevel_triangle>()) {
            for (const std::uint32_t c : {t.a, t.b, t.c}) {
                REQUIRE(c < vertices.size());
                used[c] = true;
            }
            CHECK(vertices[t.a].strip == vertices[t.b].strip);
            CHECK(vertices[t.a].strip == vertices[t.c].strip);
        }
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            CHECK(used[i]);
            CHECK(std::hypot(double(vertices[i].outward.x), double(vertices[i].outward.y)) ==
                  Catch::Approx(1.0).margin(1e-6));
            CHECK((is_zero(vertices[i].share) || same(vertices[i].share, 1.0f)));
        }
    }
}

TEST_CASE("corners share a vertex where normals and texture agree, and only there", "[bevel_vertices]")
{
    const profile_points chamfer{{0, 0}, {1, 1}}, bent{{0, 0}, {0.5f, 0.6f}, {1, 1}},
        broken{{0, 0}, {0.5f, 0.9f}, {1, 1}};
    const auto count = [](const shapes::shape& s, const profile_points& p, bevel_vertices::sharing how) {
        bevel_data data;
        make_plain_bevel(s, p, how, data);
        return data.of<bevel_vertex>().size();
    };
    const auto e = shapes::letter_e();
    const auto ring = shapes::ring(8);  // 32 and 64 points, all soft, two seams
    CHECK(count(e, chamfer, everything_near) == 4 * 12);
    CHECK(count(e, chamfer, {-1.0, -1.0}) == 2 * 12);
    CHECK(count(ring, chamfer, everything_near) == 2 * (96 + 2));
    CHECK(count(ring, chamfer, {everything_near.crease, -1.0}) == 2 * 96);
    CHECK(count(ring, chamfer, {2.0, -1.0}) == 4 * 96);
    CHECK(count(ring, bent, everything_near) == 3 * (96 + 2));
    CHECK(count(ring, broken, everything_near) == 4 * (96 + 2));
}

TEST_CASE("vertices and time are proportional to the number of faces that meet in a point", "[bevel_vertices]")
{
    constexpr std::uint32_t n = 100000;
    roof cone{regular(n, 2e8), 2e8};
    bevel_data& data = cone.data;
    side_point side;
    for (std::uint32_t i = 0; i < n; ++i) {
        side.before = side.after = rounded(unit(cone.corners[i]));
        side.along = static_cast<float>(i) * 12566.0f;
        REQUIRE(data.of<side_point>().push_back(side));
    }
    cone.make(everything_near);
    CHECK(data.of<bevel_triangle>().size() == n);
    CHECK(data.of<bevel_vertex>().size() > n + n / 2);
    CHECK(data.of<bevel_vertex>().size() <= 3 * n);
}

TEST_CASE("a vertex's normal is less than 90 degrees off its faces at every crease angle", "[bevel_vertices]")
{
    // Roofs over regular polygons and a narrow triangle, moved so that all faces meet in (0, 0): the normals turn round
    // once there.
    for (const std::uint32_t sides : {2u, 3u, 4u, 5u, 7u, 12u}) {
        const bool narrow = sides == 2;
        // The narrow one is 20000 wide and 200000 high: its incircle's radius is the width.
        const double width = narrow ? 9512.0 : 20000.0 * std::cos(3.14159265 / sides);
        const std::vector<point> triangle{{-10000.0, -width}, {10000.0, -width}, {0.0, 200000.0 - width}};
        roof over{narrow ? triangle : regular(sides, 20000.0), width};
        bevel_data& data = over.data;
        const std::uint32_t n = over.n;
        for (const double degrees : {15.0, 60.0, 91.0, 121.0, 145.0, 180.0}) {
            data.clear();
            REQUIRE(plan_sides(over.made(), curve_normals{static_cast<float>(degrees)}, texture_mapping::em,
                               data.of<side_point>()));
            over.make({std::cos(degrees / 180.0 * 3.14159265), -1.0});
            const auto vertices = data.of<bevel_vertex>().view();
            for (std::uint32_t i = 0; i < n; ++i) {
                const auto& [t] = data.of<bevel_triangle>()[i];
                const point along = over.corners[(i + 1) % n] - over.corners[i];
                CAPTURE(sides, degrees, i);
                for (const std::uint32_t c : {t.a, t.b, t.c})
                    CHECK(dot(point{along.y, -along.x}, point{vertices[c].outward.x, vertices[c].outward.y}) > 0.0);
            }
            if (degrees > 120.0 && n > 4) CHECK(vertices.size() < 3 * n);  // and yet they do share
        }
    }
}

TEST_CASE("slopes are low inside where a node is lower than asked, and not where it is as low", "[bevel_vertices]")
{
    constexpr float share = 0x1p-8f;  // of 1024 cells: a height of four
    CHECK_FALSE(is_low({{{0, 0}, 4.0f}}, pyramid, share));
    CHECK(is_low({{{0, 0}, std::nextafter(4.0f, 0.0f)}}, pyramid, share));
    CHECK(is_low({{{0, 0}, 4.0f}}, pyramid, std::nextafter(share, 1.0f)));
    CHECK_FALSE(is_low({{{0, 0}, 1024.0f}}, pyramid, 1.0f));
    CHECK(is_low({{{0, 0}, 0.0f}}, pyramid, 0x1p-20f));
}

TEST_CASE("slopes are low inside where an edge of theirs joins two points of the outline", "[bevel_vertices]")
{
    const std::vector<swept_node> two{{{300, -300}, 700.0f}, {{-300, 300}, 700.0f}};
    constexpr float share = 0x1p-8f;
    // From 0 to 2 between the nodes, or none: from one node to the other.
    CHECK(is_low(two, {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {2, 3, 5}, {3, 0, 5}, {0, 2, 5}}, share));
    CHECK_FALSE(is_low(two, {{0, 1, 4}, {1, 2, 4}, {2, 5, 4}, {2, 3, 5}, {3, 0, 5}, {0, 4, 5}}, share));
    CHECK(is_low({}, {{0, 1, 2}, {0, 2, 3}}, share));
}

TEST_CASE("slopes are low inside if their profile returns to the outline's height", "[bevel_vertices]")
{
    const auto is_low_with = [&](float h) { return is_low({{{0, 0}, 1000.0f}}, pyramid, 0x1p-8f, {{0, 0}, {1, h}}); };
    CHECK_FALSE(is_low_with(1.0f));
    CHECK_FALSE(is_low_with(0x1p-7f));
    CHECK(is_low_with(0x1p-9f));
}
