// SPDX-License-Identifier: MIT

// Contours whose points were moved behind their back are told of, not swept in an order that is no more.

#include "support/recorded_asserts.hpp"

#include "support/catch.hpp"

#include <typemesh/sweep/impl/sweep_order.hpp>

using namespace typemesh;

TEST_CASE("moving points after they were sorted is asserted", "[asserts]")
{
    const std::vector<std::string> stale{
        "the points of contours were moved after they had been sorted: call clear() or "
        "forget_order()"};
    contours loops;
    workspace space;
    for (const grid_point p : {grid_point{0, 0}, grid_point{4, 0}, grid_point{0, 3}})
        REQUIRE(loops.points.push_back(p));
    test::failed_asserts.clear();
    REQUIRE(sort_points(loops, space));
    (void)loops.order();
    CHECK(test::failed_asserts.empty());

    loops.points[1].x = -4;
    (void)loops.order();
    CHECK(test::failed_asserts == stale);
    test::failed_asserts.clear();

    loops.points[1] = loops.points[0];  // equal points come by their index
    loops.forget_order();
    REQUIRE(sort_points(loops, space));
    loops.points[2] = loops.points[0];
    (void)loops.order();
    CHECK(test::failed_asserts.empty());
    loops.points[0].x = 1;
    (void)loops.order();
    CHECK(test::failed_asserts == stale);
    test::failed_asserts.clear();
}
