// SPDX-License-Identifier: MIT

#include <typemesh/fill/segments.hpp>

#include "support/catch.hpp"
#include "support/oracle.hpp"

using typemesh::grid_point;
using typemesh::segments_meet;

TEST_CASE("segments_meet() agrees with the oracle on every pair of segments of a 4 x 4 grid", "[fill][segments]")
{
    const auto at = [](int i) { return grid_point{i % 4, i / 4}; };
    int wrong = 0;
    for (int i = 0; i < 16 * 16 * 16 * 16; ++i) {
        const grid_point a = at(i & 15), b = at(i >> 4 & 15), c = at(i >> 8 & 15), d = at(i >> 12);
        wrong += segments_meet(a, b, c, d) != test::oracle::meet(a, b, c, d);
    }
    CHECK(wrong == 0);
}

TEST_CASE("segments_meet() is exact for the largest coordinates", "[fill][segments]")
{
    constexpr std::int32_t r = 1 << 28;
    CHECK(segments_meet({-r, -r}, {r, r}, {-r, r}, {r, -r}));
    CHECK(segments_meet({-r, -r}, {r, r}, {r - 1, r - 1}, {r, -r}));
    CHECK_FALSE(segments_meet({-r, -r}, {r, r}, {r - 1, r - 2}, {r, -r}));
    CHECK_FALSE(segments_meet({-r, -r}, {r, r - 1}, {1, 1}, {-r, r}));
    CHECK(segments_meet({-r, -r}, {r, r - 1}, {1, 0}, {-r, r}));
    static_assert(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
}
