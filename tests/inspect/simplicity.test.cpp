// SPDX-License-Identifier: MIT

#include <typemesh/inspect/simplicity.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh::inspect;

TEST_CASE("loops that bound a region are distinguished from others", "[inspect]")
{
    for (const auto& c : test::corpus("regions.txt")) {
        INFO(c.shape);
        const auto loops = test::loops_of(c.shape);
        CHECK(is_crossing(loops) == c.is_crossing);
        CHECK(is_region(loops) == c.is_region);
        if (c.is_region) CHECK_FALSE(is_region(test::loops_of(test::reversed(c.shape))));
    }
    const test::polyline outer = test::square(0, 0, 10), inner = test::square(2, 2, 4);
    CHECK_FALSE(is_region({outer, inner}));
    CHECK(separated_by({outer, inner}, 1).inside == 2);
}

TEST_CASE("every way in which two edges can meet is found", "[inspect]")
{
    const test::polyline box = test::square(0, 0, 10);
    const test::polyline crossing[] = {
        {{5, 5}, {15, 5}, {15, 8}},              // an edge across another
        {{10, 5}, {15, 5}, {15, 8}},             // a corner on an edge
        {{10, 10}, {15, 15}, {10, 15}},          // a corner on a corner
        {{10, 2}, {20, 2}, {20, 8}, {10, 8}},    // edges upon each other
        {{20, 0}, {30, 0}, {25, 0}, {25, 9}},    // a spike
        {{20, 0}, {30, 0}, {30, 0}, {25, 9}},    // a point twice
        {{20, 0}, {30, 10}, {30, 0}, {20, 10}},  // an hourglass
        {{20, 0}, {30, 0}},                      // no area
    };
    for (const test::polyline& l : crossing) CHECK(is_crossing({box, l}));
    CHECK_FALSE(is_crossing({box, test::square(11, 0, 5)}));
}
