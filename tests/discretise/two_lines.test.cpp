// SPDX-License-Identifier: MIT
#include <typemesh/discretise/two_lines.hpp>

#include "support/catch.hpp"

#include "discretise/curves.hpp"

using namespace typemesh;
using namespace test;

TEST_CASE("two_lines meets at t = 1/2, whatever the tolerance", "[two_lines]")
{
    const double tolerance = GENERATE(1e-9, 1.0, 1e9);
    const auto q = points_of(two_lines{}, curve::from(quadratic{{0, 0}, {8, 16}, {4, 0}}), tolerance);
    REQUIRE(q.size() == 2);
    CHECK(q[0].p == point{5, 8});
    CHECK(q[0].t == 0.5);
    CHECK(q[1].p == point{4, 0});
    CHECK(q[1].t == 1.0);

    const auto c = points_of(two_lines{}, curve::from(cubic{{0, 0}, {8, 16}, {16, -16}, {8, 8}}), tolerance);
    REQUIRE(c.size() == 2);
    CHECK(c[0].p == point{10, 1});
    CHECK(c[0].t == 0.5);
    CHECK(c[1].p == point{8, 8});
    CHECK(c[1].t == 1.0);
}
