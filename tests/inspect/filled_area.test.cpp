// SPDX-License-Identifier: MIT

#include <typemesh/inspect/filled_area.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh::inspect;
using Catch::Approx;
using typemesh::fill_rule;

TEST_CASE("the filled area of crossing loops is the area of the figure, by both rules", "[inspect]")
{
    const test::polyline a = test::square(0, 0, 10), b = test::square(5, 5, 10);
    const std::vector<loop> overlap{a, b};
    CHECK(doubled_filled_area(overlap, fill_rule::non_zero) == Approx(350));
    CHECK(doubled_filled_area(overlap, fill_rule::even_odd) == Approx(300));
    const test::polyline hourglass{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
    CHECK(doubled_filled_area({hourglass}, fill_rule::non_zero) == Approx(100));
    const test::polyline back = test::reversed(b);
    CHECK(doubled_filled_area({a, back}, fill_rule::non_zero) == Approx(300));
    for (const test::shape& s : test::generated_regions()) {
        const auto loops = test::loops_of(s);
        if (s.loops[0].size() > 1000 || !is_region(loops)) continue;
        CHECK(doubled_filled_area(loops, fill_rule::non_zero) == Approx(static_cast<double>(doubled_area(loops))));
    }
}

TEST_CASE("edges pass through the grid points nearest to their crossings", "[inspect]")
{
    const test::polyline a{{0, 0}, {9, 3}, {0, 3}}, b{{5, -5}, {6, 9}, {20, 0}};
    const rerouted_loops led = reroute_through_crossings({a, b});
    CHECK(led.all[0].size() == 5);
    CHECK(led.all[1].size() == 5);
    CHECK(led.bent_length > 0);
    for (const test::polyline& l : led.all)
        for (const test::grid_point p : l) CHECK(distance({a, b}, p) < 0.71);
    const rerouted_loops straight = reroute_through_crossings({test::square(0, 0, 10)});
    CHECK(straight.all[0] == test::square(0, 0, 10));
    CHECK_FALSE(straight.bent_length > 0);
}
