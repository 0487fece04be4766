// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/affine.hpp>

#include <limits>

using namespace typemesh;

TEST_CASE("a map turns, slants and moves points as its six numbers say", "[core]")
{
    CHECK(affine{}(point{3, -4}) == point{3, -4});
    CHECK(affine{.dx = 1, .dy = 2}(point{3, -4}) == point{4, -2});
    CHECK(affine{.xy = 0.5}(point{3, -4}) == point{1, -4});
    CHECK(affine{.xx = 0, .xy = 1, .yx = -1, .yy = 0}(point{3, -4}) == point{-4, -3});  // a quarter to the right
}

TEST_CASE("scaled_before() maps a point as the map does the scaled point", "[core]")
{
    const affine map{2, 3, 5, 7, 11, 13};
    const point p{17, 19};
    CHECK(scaled_before(map, 0.5)(p) == map(0.5 * p));
    CHECK(scaled_before(map, 1.0) == map);
}

TEST_CASE("two maps are equal if all six numbers are, and a map with a NaN equals none", "[core]")
{
    const affine map{2, 3, 5, 7, 11, 13};
    CHECK(map == affine{map});
    for (const auto number : {&affine::xx, &affine::xy, &affine::dx, &affine::yx, &affine::yy, &affine::dy}) {
        affine other = map;
        other.*number += 1.0;
        CHECK_FALSE(other == map);
#ifndef __FAST_MATH__  // there no number is a NaN
        other.*number = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(other == affine{other});
#endif
    }
    CHECK(affine{.dx = 0.0} == affine{.dx = -0.0});
}
