// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/inflated_normals.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

/// A part of an inflated letter on a grid of 1000 cells per em. Points of the outline have the height 0.
struct leaning_mesh {
    contours loops;
    triangle_list triangles;
    buffer<membrane_point> membrane;
    buffer<membrane_lean> leans;

    leaning_mesh(const std::vector<grid_point>& places, const std::vector<membrane_point>& points,
                 const std::vector<triangle>& of, float flatness = 0.0f)
    {
        for (const grid_point p : places) REQUIRE(loops.points.push_back(p));
        for (const membrane_point& p : points) REQUIRE(membrane.push_back(p));
        for (const triangle& t : of) REQUIRE(triangles.push_back(t));
        detail::inflated_normals normals;
        REQUIRE(normals(loops, triangles, membrane, leans, 1000.0, flatness));
        CHECK(loops.points.size() == membrane.size());
        CHECK(loops.points.size() == leans.size());
    }

    /// How far the slope of a corner points up a triangle: not of unit length.
    [[nodiscard]] double upward(std::size_t at, std::uint32_t corner) const
    {
        const triangle t = triangles[at];
        const point u = delta(loops.points[t.a], loops.points[t.b]), v = delta(loops.points[t.a], loops.points[t.c]);
        const double along_u = as_double(membrane[t.b].height) - as_double(membrane[t.a].height),
                     along_v = as_double(membrane[t.c].height) - as_double(membrane[t.a].height);
        const vec2 slope = membrane[corner].slope;
        return dot(point{as_double(slope.x), as_double(slope.y)},
                   {along_u * v.y - along_v * u.y, along_v * u.x - along_u * v.x});
    }
};

}  // namespace

TEST_CASE("a slope at the outline that points down a triangle turns to point up all, or the triangle gets its own",
          "[extrude]")
{
    // The middle of an outline along x, and its three triangles. The second rises down to the right: from (0, 1), its
    // direction is 132 degrees away, or 168.
    for (const bool can_turn : {true, false}) {
        CAPTURE(can_turn);
        const grid_point at = can_turn ? grid_point{20, 5} : grid_point{20, 3},
                         to = can_turn ? grid_point{70, 60} : grid_point{120, 25};
        const vec2 up = {0.0f, 1.0f};
        const leaning_mesh m{{{0, 0}, {300, 0}, at, to, {-100, 0}},
                             {{0.0f, up}, {0.0f, up}, {0.02f, {}}, {0.02f, {}}, {0.0f, up}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
        CHECK(m.loops.points.size() == (can_turn ? 5 : 6));
        CHECK(m.loops.points.back() == (can_turn ? grid_point{-100, 0} : grid_point{0, 0}));
        CHECK((m.membrane[0].slope == up) != can_turn);
        CHECK(m.membrane[1].slope == up);
        CHECK(m.membrane[4].slope == up);
        CHECK(m.triangles[0] == triangle{0, 1, 2});
        CHECK(m.triangles[1] == triangle{can_turn ? 0u : 5u, 2, 3});
        CHECK(m.triangles[2] == triangle{0, 3, 4});
        for (std::size_t t = 0; t < 3; ++t) CHECK(m.upward(t, m.triangles[t].a) > 0.0);
        // not farther than needed, by 15 degrees
        const vec2 slope = m.membrane[m.triangles[1].a].slope;
        CHECK(as_double(slope.x) * as_double(slope.x) + as_double(slope.y) * as_double(slope.y) == Catch::Approx(1.0));
        if (can_turn) CHECK(as_double(slope.y) > std::cos((42.3 + 15.0) * 3.14159265 / 180.0));
    }
}

TEST_CASE("a triangle of three outline points is level: its corners get points without a slope", "[extrude]")
{
    const leaning_mesh m{
        {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {20, 80}},
        {{0.0f, {0.6f, 0.8f}}, {0.0f, {-0.6f, 0.8f}}, {0.0f, {-0.8f, -0.6f}}, {0.0f, {0.8f, -0.6f}}, {0.02f, {}}},
        {{0, 1, 2}, {0, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    REQUIRE(m.loops.points.size() == 7);
    CHECK(m.triangles[0] == triangle{5, 1, 6});  // no other triangle keeps the second point
    for (const std::uint32_t i : {1u, 5u, 6u}) CHECK(m.membrane[i].slope == vec2{});
    CHECK(m.membrane[0].slope == vec2{0.6f, 0.8f});
    CHECK(m.membrane[2].slope == vec2{-0.8f, -0.6f});
    CHECK(m.loops.points[5] == grid_point{0, 0});
    CHECK(m.loops.points[6] == grid_point{100, 100});
}

TEST_CASE("inside, the least product of a point's slope and its triangles' slopes is kept, as the limit makes them",
          "[extrude]")
{
    for (const float flatness : {0.0f, 50.0f}) {
        CAPTURE(flatness);
        const leaning_mesh m{{{0, 0}, {100, 0}, {0, 100}, {-100, 0}},
                             {{0.02f, {0.02f, 0.0f}}, {0.01f, {}}, {0.02f, {}}, {0.01f, {}}},
                             {{0, 1, 2}, {0, 2, 3}},
                             flatness};
        // The first triangle falls by 0.1 em per em; flattened, 0.02 becomes 0.02 / sqrt(2) and 0.01 0.01 / sqrt(1.25).
        const double fall = flatness > 0.0f ? 10.0 * (0.02 / std::sqrt(2.0) - 0.01 / std::sqrt(1.25)) : 0.1;
        CHECK(as_double(m.leans[0].least) == Catch::Approx(-0.02 * fall));
        for (const std::uint32_t i : {1u, 2u, 3u}) CHECK(std::abs(m.leans[i].least) <= 0.0f);
    }
}
