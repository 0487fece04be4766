// SPDX-License-Identifier: MIT

#include <typemesh/core/region.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <vector>

using namespace typemesh;

TEST_CASE("a region refers to all of the contours it was proven from", "[core][region]")
{
    contours loops = test::contours_of(test::square_with_holes(2, 5));
    const std::vector<curve> curves(7, curve::from({0, 0}, {1, 1}));
    loops.curves = curves;
    loops.tolerance = 3.5;
    loops.grid = grid{256.0};
    const region r = region::proven(loops, 4, 1, true);
    CHECK(r.points().data() == loops.points.data());
    CHECK(r.points().size() == loops.points.size());
    CHECK(r.edges().data() == loops.edges.data());
    CHECK(r.starts().data() == loops.starts.data());
    CHECK(r.curves().data() == curves.data());
    CHECK(r.curves().size() == 7);
    CHECK(r.grid().cells == 256.0);
    CHECK(r.tolerance() == 3.5);
    CHECK(r.holes() == 4);
    CHECK(r.outers() == 1);
    CHECK(r.loop_count() == 5);
    CHECK(r.is_touching());
    CHECK_FALSE(region::proven(loops, 4, 1).is_touching());
}

TEST_CASE("a region knows its number of triangles before it is cut, and an empty one has none", "[core][region]")
{
    int regions = 0;
    for (const test::shape& s : test::generated_regions()) {
        const contours loops = test::contours_of(s);
        workspace space;
        triangle_list cut;
        const auto proven = monotone{}.prove(loops, space, cut);
        if (!proven) continue;
        INFO(s.name);
        CHECK(region::proven(loops, proven->holes(), proven->outers()).triangle_count() == cut.size());
        ++regions;
    }
    CHECK(regions > 15);
    const region none;
    CHECK(none.triangle_count() == 0);
    CHECK(none.loop_count() == 0);
    CHECK(none.points().empty());
    CHECK_FALSE(none.is_touching());
}
