// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/wall_normal.hpp>

#include <limits>

#include "support/catch.hpp"

using namespace typemesh;
using Catch::Approx;

TEST_CASE("a wall's normal points to the right of its edge", "[extrude]")
{
    CHECK(wall_normal({0, 0}, {5, 0}) == point{0.0, -1.0});
    CHECK(wall_normal({0, 0}, {0, 5}) == point{1.0, 0.0});
    const point n = wall_normal({-(1 << 28), -(1 << 28)}, {1 << 28, 1 << 28});
    CHECK(n.x == Approx(std::sqrt(0.5)));
    CHECK(n.y == Approx(-std::sqrt(0.5)));
}

TEST_CASE("a joint's normal is the normalised sum of its walls' normals", "[extrude]")
{
    for (int degrees = -179; degrees < 180; ++degrees) {
        const double turn = degrees * 3.14159265358979323846 / 180.0;
        const grid_point a{-100000000, 0}, b{0, 0},
            c{static_cast<std::int32_t>(1e8 * std::cos(turn)), static_cast<std::int32_t>(1e8 * std::sin(turn))};
        const point n = joint_normal(a, b, c, wall_normal(a, b), wall_normal(b, c));
        INFO(degrees);
        CHECK(n.x == Approx(std::sin(turn / 2)).margin(1e-6));
        CHECK(n.y == Approx(-std::cos(turn / 2)).margin(1e-6));
    }
}

TEST_CASE("the tip of the sharpest needle on the grid has a unit normal along it", "[extrude]")
{
    // The walls' normals are opposite to the last bit; only the exact turn distinguishes a tip from a notch.
    const grid_point a{-(1 << 28), 0}, tip{1 << 28, 1}, c{-(1 << 28) + 1, 0}, d{-(1 << 28), 1};
    const point out = joint_normal(a, tip, d, wall_normal(a, tip), wall_normal(tip, d));
    CHECK(out.x == Approx(1.0));
    const point in = joint_normal(d, tip, c, wall_normal(d, tip), wall_normal(tip, c));
    CHECK(in.x == Approx(-1.0));
}

TEST_CASE("the tip of a slanted needle has a unit normal along it, however close its walls are", "[extrude]")
{
    for (const std::int32_t n : {3, 1000, 1 << 20, 1 << 28}) {  // an angle of n^-2 / 2: normals cancel from 2^27 on
        const grid_point a{-n, 1 - n}, tip{0, 0}, c{1 - n, 2 - n};
        INFO(n);
        const point out = joint_normal(a, tip, c, wall_normal(a, tip), wall_normal(tip, c));
        CHECK(out.x == Approx(std::sqrt(0.5)).epsilon(2.0 / n));
        CHECK(out.y == Approx(std::sqrt(0.5)).epsilon(2.0 / n));
        const point in = joint_normal(c, tip, a, wall_normal(c, tip), wall_normal(tip, a));
        CHECK(in.x == -out.x);
        CHECK(in.y == -out.y);
    }
}

TEST_CASE("crease angles lie between 0 and 180 degrees", "[extrude]")
{
    CHECK(is_crease_angle(0.0f));
    CHECK(is_crease_angle(180.0f));
    CHECK_FALSE(is_crease_angle(-0.01f));
    CHECK_FALSE(is_crease_angle(180.01f));
    CHECK_FALSE(is_crease_angle(std::numeric_limits<float>::infinity()));
    CHECK_FALSE(is_crease_angle(std::numeric_limits<float>::quiet_NaN()));
    CHECK(crease_cosine(60.0f) == Approx(0.5).margin(1e-7));
    CHECK(crease_cosine(180.0f) > -1.0);
}
