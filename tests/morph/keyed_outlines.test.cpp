// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/keyed_outlines.hpp>

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

TEST_CASE("outlines at all keys have the same curves, and a closing line that has no length", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    const std::vector<axis_coordinate> at = {-16384, 0, 16384};
    REQUIRE_FALSE(outlines.record(axis, 'q', at));
    REQUIRE(outlines.keys() == 3);
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(outlines.curves(k).size() == 4);
    CHECK(outlines.curves(0)[3].start() == outlines.curves(0)[3].end());
    CHECK(outlines.curves(2)[3].start() == point{400, 0});
    CHECK(outlines.bend_at(1) < 1e-9);
    REQUIRE_FALSE(outlines.record(axis, 'o', at));
    CHECK(outlines.starts().size() == 3);
    CHECK(outlines.bend_at(1) > 1.0);  // the hole bends at 0
}

TEST_CASE("a key that is inserted and removed leaves the others as they were", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    const std::vector<axis_coordinate> at = {-16384, 16384};
    REQUIRE_FALSE(outlines.record(axis, 'w', at));
    const point low = outlines.curves(0)[5].p[1], high = outlines.curves(1)[5].p[1];
    const auto key = outlines.insert(axis, 'w', 4096);
    REQUIRE(key);
    CHECK(*key == 1);
    CHECK(outlines.coordinates()[1] == 4096);
    CHECK(outlines.curves(1)[5].p[1] == lerp(low, high, 0.625));
    const auto next = outlines.insert(axis, 'w', -4096);
    REQUIRE(next);
    CHECK(*next == 1);
    CHECK(outlines.curves(2)[5].p[1] == lerp(low, high, 0.625));
    CHECK(outlines.bend_at(1) < 1e-9);
    outlines.remove(1);
    outlines.remove(1);
    REQUIRE(outlines.keys() == 2);
    CHECK(outlines.curves(0)[5].p[1] == low);
    CHECK(outlines.curves(1)[5].p[1] == high);
}

TEST_CASE("keys at which nothing bends are forgotten at once as one after the other", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines, other;
    std::vector<axis_coordinate> many;
    for (axis_coordinate c = -16384; c <= 16384; c += 1024) many.push_back(c);
    for (const double limit : {0.0, 0.1, 30.0, 1e9}) {
        REQUIRE_FALSE(outlines.record(axis, 'o', many));
        REQUIRE_FALSE(other.record(axis, 'o', many));
        outlines.forget_unbent(limit);
        for (std::size_t k = 1; k + 1 < other.keys();)
            if (other.bend_at(k) <= limit)
                other.remove(k);
            else
                ++k;
        REQUIRE(outlines.keys() == other.keys());
        for (std::size_t k = 0; k < other.keys(); ++k) {
            CHECK(outlines.coordinates()[k] == other.coordinates()[k]);
            for (std::size_t i = 0; i < other.curves(k).size(); ++i)
                CHECK(outlines.curves(k)[i].start() == other.curves(k)[i].start());
        }
    }
    CHECK(outlines.keys() == 2);
}

TEST_CASE("an outline has a limit at all coordinates together", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    std::vector<axis_coordinate> many;
    for (axis_coordinate c = -16384; c <= 16384; ++c) many.push_back(c);
    CHECK(outlines.record(axis, 'o', many) == error::too_many_points);
    CHECK_FALSE(outlines.record(axis, 'q', many));
}
