// SPDX-License-Identifier: MIT

#include <typemesh/core/box.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <vector>

using namespace typemesh;

TEST_CASE("a box is the smallest around its points, added in any order or merged from parts", "[core]")
{
    test::dice d{3};
    for (int round = 0; round < 200; ++round) {
        std::vector<point> points;
        for (int n = 1 + d.roll(9); n > 0; --n) points.push_back({d.fraction() - 0.5, 1e6 * (d.fraction() - 0.5)});
        box all, first, second;
        for (const point p : points) all.add(p);
        for (const point p : points) (d.roll(2) == 0 ? first : second).add(p);
        first.merge(second);
        CHECK(first.low == all.low);
        CHECK(first.high == all.high);
        bool left = false, right = false, low = false, high = false;
        for (const point p : points) {
            CHECK((all.low.x <= p.x && p.x <= all.high.x && all.low.y <= p.y && p.y <= all.high.y));
            left = left || p.x == all.low.x;
            right = right || p.x == all.high.x;
            low = low || p.y == all.low.y;
            high = high || p.y == all.high.y;
        }
        CHECK((left && right && low && high));
        CHECK(all.width() == all.high.x - all.low.x);
        CHECK(all.height() == all.high.y - all.low.y);
    }
}

TEST_CASE("a box without points or with one has no size, and merging an empty box changes nothing", "[core]")
{
    box nothing, one;
    nothing.merge(box{});
    CHECK(nothing.empty());
    CHECK(nothing.width() == 0.0);
    CHECK(nothing.height() == 0.0);
    one.add({3, -4});
    CHECK_FALSE(one.empty());
    CHECK(one.width() == 0.0);
    one.merge(nothing);
    CHECK(one.low == point{3, -4});
    CHECK(one.high == point{3, -4});
    nothing.merge(one);
    CHECK(nothing.low == point{3, -4});
    box other;
    for (const point p : {point{2, 3}, point{-1, 5}, point{0, -4}}) other.add(p);
    CHECK(other.low == point{-1, -4});
    CHECK(other.high == point{2, 5});
    CHECK(other.height() == 9.0);
}
