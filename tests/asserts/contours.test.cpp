// SPDX-License-Identifier: MIT

// Contours whose points were moved behind their back are told of, not swept in an order that is no more.

#include "support/recorded_asserts.hpp"

#include "support/catch.hpp"

#include <typemesh/plate/layer_arrangement.hpp>
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

TEST_CASE("points of an arrangement that come without the starts of their loops are asserted", "[asserts]")
{
    const std::vector<std::string> missing{"the starts of loops begin with 0 and end with the number of points"};
    const grid_point points[] = {{0, 0}, {4, 0}, {0, 3}};
    const std::uint32_t starts[] = {0, 3}, too_few[] = {0, 2};
    layer_arrangement cells;
    cells.begin({});
    test::failed_asserts.clear();
    REQUIRE(cells.add({points, 3}, {starts, 2}, 0));
    REQUIRE(cells.add({}, {}, 0));
    CHECK(test::failed_asserts.empty());
    REQUIRE(cells.add({points, 3}, {}, 0));
    CHECK(test::failed_asserts == missing);
    test::failed_asserts.clear();
    REQUIRE(cells.add({points, 3}, {too_few, 2}, 0));
    CHECK(test::failed_asserts == missing);
    test::failed_asserts.clear();
}
