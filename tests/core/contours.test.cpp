// SPDX-License-Identifier: MIT

#include <typemesh/core/contours.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <vector>

using namespace typemesh;

namespace {

/// Two points, in descending order, and the order that sorts them.
void fill_and_sort(contours& loops)
{
    REQUIRE(loops.points.push_back({5, 0}));
    REQUIRE(loops.points.push_back({3, 0}));
    std::uint32_t* const order = loops.new_order(2);
    REQUIRE(order != nullptr);
    order[0] = 1;
    order[1] = 0;
}

}  // namespace

TEST_CASE("contours keep the order of their points until it is cleared or forgotten", "[core]")
{
    contours loops;
    CHECK(loops.order().empty());
    fill_and_sort(loops);
    CHECK(std::ranges::equal(loops.order(), std::vector<std::uint32_t>{1, 0}));

    const contours moved = std::move(loops);
    CHECK(moved.order().size() == 2);

    contours again;
    fill_and_sort(again);
    again.clear();
    CHECK(again.order().empty());
    for (const grid_point p : {grid_point{5, 0}, grid_point{3, 0}}) REQUIRE(again.points.push_back(p));
    CHECK(again.order().empty());  // as many as before, but not sorted
    again.clear();
    fill_and_sort(again);
    again.forget_order();
    CHECK(again.order().empty());
}

TEST_CASE("an order is lost when points come or go", "[core]")
{
    contours loops;
    fill_and_sort(loops);
    REQUIRE(loops.points.push_back({4, 0}));
    CHECK(loops.order().empty());
    loops.points.truncate(1);
    CHECK(loops.order().empty());
}

TEST_CASE("contours without memory have no order", "[core]")
{
    test::counting_memory memory;
    contours loops{memory.source()};
    fill_and_sort(loops);
    memory.fail_at = memory.requests + 1;
    CHECK(loops.new_order(1000) == nullptr);
    CHECK(loops.order().empty());
}
