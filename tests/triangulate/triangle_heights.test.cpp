// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/triangle_heights.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>

using namespace typemesh;

TEST_CASE("a level counts how often a height must be doubled to reach 2^-16 em", "[triangulate][triangle_heights]")
{
    const grid g{.cells = 512.0, .units_per_em = 2048.0};  // 2^-20 em is one cell
    const triangle_heights heights{g};
    const auto level = [&](std::int32_t length, std::int32_t middle, std::int32_t height) {
        return heights.level({-length, 0}, {middle, -height}, {length, 0});
    };
    for (const std::int32_t length : {40, 1000, 1 << 20, 1 << 27}) {
        for (const std::int32_t middle : {0, 7, -33})
            for (const auto& [height, expected] : {std::pair{17, 0u},
                                                   {16, 0u},
                                                   {15, 1u},
                                                   {8, 1u},
                                                   {7, 2u},
                                                   {2, 3u},
                                                   {1, 4u}})  // a level of 4 is not low
                CHECK(level(length, middle, height) == expected);
    }
    // Slanted: height times length is the doubled area, 1 here.
    for (std::uint32_t k = 1; k < 20; ++k) {
        const std::int32_t reach = 1 << k;
        CHECK(heights.level({0, 0}, {reach, 1}, {2 * reach + 1, 2}, 1) == (std::min)(12u, 4 + k + 2));
        CHECK(heights.is_low({0, 0}, {reach, 0}, {2 * reach + 1, 1}));
    }
    CHECK_FALSE(triangle_heights{grid{}}.is_low({0, 0}, {1000, 0}, {2001, 1}));  // without an em nothing is low
    CHECK(triangle_heights{grid{}}.doubled_area_of_low() == 0);
}

TEST_CASE("levels are exact for triangles of all sizes", "[triangulate][triangle_heights]")
{
    test::dice d{11};
    for (int i = 0; i < 20'000; ++i) {
        const double em = std::ldexp(1.0 + d.fraction(), 14 + d.roll(11));
        const std::int32_t reach = 1 << (3 + d.roll(25));
        const grid_point a{d.roll(reach) - reach / 2, d.roll(reach) - reach / 2},
            b{d.roll(reach) - reach / 2, d.roll(reach) - reach / 2};
        const double along = d.fraction();
        const grid_point c{static_cast<std::int32_t>(a.x + along * (b.x - a.x)) + d.roll(5) - 2,
                           static_cast<std::int32_t>(a.y + along * (b.y - a.y)) + d.roll(5) - 2};
        if (orientation(a, b, c) <= 0) continue;
        const auto side = [](grid_point p, grid_point q) { return std::hypot(double(p.x) - q.x, double(p.y) - q.y); };
        const double longest = (std::max)({side(a, b), side(b, c), side(c, a)});
        const double height = static_cast<double>(orientation(a, b, c)) / longest;
        const double span = i % 2 == 0 ? 0.0 : longest;  // of the grid: unknown, or no larger than the triangle
        const triangle_heights heights{grid{.cells = 1.0, .units_per_em = em, .span = span}};
        const std::uint32_t level = heights.level(a, b, c);
        const double whole = std::floor(em);
        if (level > 0) CHECK(height * std::ldexp(1.0, 15 + static_cast<int>(level)) < whole * (1.0 + 1e-12));
        if (level < 12) CHECK(height * std::ldexp(1.0, 16 + static_cast<int>(level)) > whole * (1.0 - 1e-12));
        CHECK(heights.is_low(a, b, c) == (level >= triangle_heights::low));
    }
}
