// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/inflated_corners.hpp>

#include "support/catch.hpp"

#include <vector>

using namespace typemesh;

TEST_CASE("a hard corner of an inflated outline becomes two points, one for the triangles of each edge", "[extrude]")
{
    // A square with a hard corner at its first point, and a point in its middle.
    for (const bool is_hole : {false, true}) {  // counter-clockwise; then seen as a corner of 270 degrees
        CAPTURE(is_hole);
        contours loops;
        triangle_list triangles;
        buffer<membrane_point> membrane;
        std::vector<side_point> sides(4);
        REQUIRE(loops.starts.push_back(0));
        REQUIRE(loops.starts.push_back(4));
        const grid_point square[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
        for (int i = 0; i < 4; ++i) {
            REQUIRE(loops.points.push_back(square[is_hole ? (4 - i) % 4 : i]));
            REQUIRE(membrane.push_back({0.0f, {-1.0f, 0.0f}}));
        }
        sides[0] = {{-1.0f, 0.0f}, {0.0f, -1.0f}, 0.0f, true, false};
        sides[2] = {{1.0f, 0.0f}, {1.0f, 0.0f}, 0.0f, true, true};  // a seam is no corner
        if (is_hole) {
            for (const grid_point p : {grid_point{-50, 50}, grid_point{-50, -50}, grid_point{50, -50}})
                REQUIRE(loops.points.push_back(p));
            // around the corner, from the edge that leaves it to the edge that arrives
            for (const triangle t : {triangle{0, 1, 4}, triangle{0, 4, 5}, triangle{0, 5, 6}, triangle{0, 6, 3}})
                REQUIRE(triangles.push_back(t));
            for (int i = 0; i < 3; ++i) REQUIRE(membrane.push_back({1.0f, {}}));
        } else {
            REQUIRE(loops.points.push_back({50, 50}));
            REQUIRE(membrane.push_back({1.0f, {}}));
            for (const triangle t : {triangle{0, 1, 4}, triangle{1, 2, 4}, triangle{2, 3, 4}, triangle{3, 0, 4}})
                REQUIRE(triangles.push_back(t));
        }
        const auto before = static_cast<std::uint32_t>(loops.points.size());
        detail::inflated_corners corners;
        REQUIRE(corners(loops, 4, sides, triangles, membrane));
        REQUIRE(loops.points.size() == before + 1);
        CHECK(loops.points.back() == loops.points[0]);
        REQUIRE(membrane.size() == before + 1);
        CHECK(membrane.back().slope == vec2{0.0f, 1.0f});  // into the letter, from the wall after
        if (is_hole) {
            CHECK(triangles[0].a == before);
            CHECK(triangles[1].a == before);
            CHECK(triangles[2].a == 0);
            CHECK(triangles[3].a == 0);
        } else {
            CHECK(triangles[0].a == before);
            CHECK(triangles[1].b == 2);
            CHECK(triangles[3].b == 0);
        }
    }
}

TEST_CASE("a corner of an inflated outline with a single triangle stays one point, whose normal halves the angle",
          "[extrude]")
{
    contours loops;
    triangle_list triangles;
    buffer<membrane_point> membrane;
    std::vector<side_point> sides(3);
    REQUIRE(loops.starts.push_back(0));
    REQUIRE(loops.starts.push_back(3));
    for (const grid_point p : {grid_point{0, 0}, grid_point{1000, 0}, grid_point{0, 10}}) {
        REQUIRE(loops.points.push_back(p));
        REQUIRE(membrane.push_back({0.0f, {-1.0f, 0.0f}}));
    }
    sides[0] = {{-1.0f, 0.0f}, {0.0f, -1.0f}, 0.0f, true, false};
    REQUIRE(triangles.push_back({0, 1, 2}));
    detail::inflated_corners corners;
    REQUIRE(corners(loops, 3, sides, triangles, membrane));
    CHECK(loops.points.size() == 3);
    CHECK(membrane.size() == 3);
    CHECK((triangles[0].a == 0 && triangles[0].b == 1 && triangles[0].c == 2));
    CHECK(membrane[0].slope.x == Catch::Approx(0.70710678));
    CHECK(membrane[0].slope.y == Catch::Approx(0.70710678));
}
