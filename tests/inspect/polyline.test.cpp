// SPDX-License-Identifier: MIT

#include <typemesh/inspect/polyline.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh::inspect;
using Catch::Approx;
using typemesh::grid_point;

TEST_CASE("winding numbers, areas and distances of polylines are the figure's own", "[inspect]")
{
    const test::polyline outer = test::square(0, 0, 10), inner = test::square(2, 2, 4);
    const std::vector<loop> both{outer, inner};
    CHECK(winding(both, {1, 1}) == 1);
    CHECK(winding(both, {3, 3}) == 2);
    CHECK(winding(both, {11, 3}) == 0);
    const test::polyline turned = test::reversed(inner);
    CHECK(winding({outer, turned}, {3, 3}) == 0);
    CHECK(doubled_area(both) == 232);
    CHECK(doubled_area({outer, turned}) == 168);
    CHECK(length(both) == Approx(56));
    CHECK(distance(both, {5, 7}) == Approx(1));
    CHECK(distance(both, {13, 14}) == Approx(5));
    CHECK(distance(both, {2, 4}) == Approx(0).margin(1e-12));
}

TEST_CASE("segments meet if they have a point in common", "[inspect]")
{
    const grid_point a{0, 0}, b{8, 4};
    CHECK(meet(a, b, {0, 4}, {8, 0}));
    CHECK(meet(a, b, {4, 2}, {4, 9}));
    CHECK(meet(a, b, {-2, -1}, {2, 1}));
    CHECK(meet(a, b, b, {9, 9}));
    CHECK_FALSE(meet(a, b, {4, 3}, {4, 9}));
    CHECK_FALSE(meet(a, b, {10, 5}, {12, 6}));
    CHECK(lies_on({4, 2}, a, b));
    CHECK_FALSE(lies_on({4, 3}, a, b));
    CHECK_FALSE(lies_on({10, 5}, a, b));
    CHECK(side({-(1 << 28), -(1 << 28)}, {1 << 28, 1 << 28}, {0, 1}) == 1);
}

TEST_CASE("a point at the height of corners has winding number 1", "[inspect]")
{
    const test::polyline diamond{{5, 0}, {10, 5}, {5, 10}, {0, 5}}, turned = test::reversed(diamond);
    for (std::int32_t x = -3; x < 14; ++x) {
        if (x == 0 || x == 10) continue;
        const std::int32_t expected = x > 0 && x < 10 ? 1 : 0;
        CHECK(winding(diamond, {x, 5}) == expected);
        CHECK(winding(turned, {x, 5}) == -expected);
    }
}
