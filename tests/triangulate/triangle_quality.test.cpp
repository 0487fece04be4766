// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>
#include <typemesh/triangulate/triangle_quality.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>

using namespace typemesh;

TEST_CASE("a square halved has angles of 45 degrees and an aspect of 2", "[triangulate][quality]")
{
    const grid_point points[] = {{0, 0}, {7, 0}, {7, 7}, {0, 7}};
    const triangle triangles[] = {{0, 1, 2}, {2, 3, 0}};
    const triangle_quality q = analyze_triangles(points, triangles);
    CHECK(q.triangles == 2);
    CHECK(std::abs(q.smallest_angle - 45.0) < 1e-9);
    CHECK(std::abs(q.largest_aspect - 2.0) < 1e-9);
    CHECK(std::abs(q.angle_at(0.5) - 45.0) < 0.06);
}

TEST_CASE("angle_at() returns the angle that a share of all triangles reaches", "[triangulate][quality]")
{
    const grid_point points[] = {{0, 0}, {1000, 0}, {1000, 100}, {1000, 300}, {1000, 1000}};
    const triangle triangles[] = {{0, 1, 2}, {0, 1, 4}, {0, 1, 3}, {0, 1, 2}};
    const double sorted[] = {5.7106, 5.7106, 16.6992, 45.0};  // degrees: atan 0.1, 0.1, 0.3 and 1
    triangle_quality q;
    add_triangles<grid_point>(q, points, triangles);
    for (int counted = 1; counted <= 4; ++counted) {
        INFO(counted << " of 4");
        CHECK(std::abs(q.angle_at(counted * 0.25) - sorted[counted - 1]) < 0.06);
        CHECK(std::abs(q.angle_at(counted * 0.25 - 0.125) - sorted[counted - 1]) < 0.06);
    }
    CHECK(std::abs(q.angle_at(0.0) - sorted[0]) < 0.06);
}

TEST_CASE("quality is right at the ends of the grid, in every order of corners", "[triangulate][quality]")
{
    constexpr std::int32_t r = 1 << 28;
    const grid_point points[] = {{-r, -r}, {r, -r}, {-r, 1 - r}};
    for (const triangle t : {triangle{0, 1, 2}, triangle{1, 2, 0}, triangle{2, 0, 1}, triangle{2, 1, 0}}) {
        const triangle_quality q = analyze_triangles(points, {&t, 1});
        CHECK(std::abs(q.smallest_angle * 0x1p29 / 57.29577951308232 - 1.0) < 1e-6);
        CHECK(std::abs(q.largest_aspect / 0x1p29 - 1.0) < 1e-6);
    }
}

TEST_CASE("a triangle without area has angle 0, and no triangles have no quality", "[triangulate][quality]")
{
    const grid_point points[] = {{0, 0}, {1, 1}, {5, 5}};
    const triangle flat{0, 1, 2};
    CHECK(analyze_triangles(points, {&flat, 1}).smallest_angle == 0.0);
    CHECK(analyze_triangles(points, {&flat, 1}).largest_aspect == 0.0);
    CHECK(analyze_triangles(points, {}).triangles == 0);
    CHECK(analyze_triangles(points, {}).angle_at(0.05) == 0.0);
}

TEST_CASE("constrained_delaunay has the larger smallest angle on every shape", "[triangulate][quality]")
{
    for (const test::shape& s : test::generated_regions()) {
        contours loops = test::contours_of(s);
        workspace space;
        const result<region> filled = fill(loops, fill_rule::non_zero, space);
        if (!filled) continue;
        triangle_list by_sweep, delaunay;
        REQUIRE_FALSE(monotone{}(*filled, space, by_sweep));
        REQUIRE_FALSE(constrained_delaunay{}(*filled, space, delaunay));
        const triangle_quality plain = analyze_triangles(filled->points(), by_sweep.view()),
                               better = analyze_triangles(filled->points(), delaunay.view());
        INFO(s.name);
        CHECK(better.triangles == plain.triangles);
        CHECK(better.smallest_angle >= plain.smallest_angle * (1.0 - 1e-9));
        CHECK(better.angle_at(0.05) >= plain.angle_at(0.05) - 0.11);
    }
}
