// SPDX-License-Identifier: MIT
#include <typemesh/discretise/two_lines.hpp>

#include "support/catch.hpp"

#include "discretise/curves.hpp"

using namespace typemesh;
using namespace test;

TEST_CASE("two_lines meets at t = 1/2, whatever the tolerance", "[two_lines]")
{
    const double tolerance = GENERATE(1e-9, 1.0, 1e9);
    const auto meets_at = [&](const curve& c, point middle) {
        const auto points = points_of(two_lines{}, c, tolerance);
        REQUIRE(points.size() == 2);
        CHECK(points[0].p == middle);
        CHECK(points[0].t == 0.5);
        CHECK(points[1].p == c.end());
        CHECK(points[1].t == 1.0);
    };
    meets_at(curve::from(quadratic{{0, 0}, {8, 16}, {4, 0}}), {5, 8});
    meets_at(curve::from(cubic{{0, 0}, {8, 16}, {16, -16}, {8, 8}}), {10, 1});
}
