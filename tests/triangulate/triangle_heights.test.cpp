// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/triangle_heights.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>

using namespace typemesh;

TEST_CASE("a triangle's level tells how often its height has to be doubled to reach 2^-16 em",
          "[triangulate][triangle_heights]")
{
    const grid g{.cells = 512.0, .units_per_em = 2048.0};  // 2^-20 em is one cell
    const triangle_heights heights{g};
    const auto level = [&](std::int32_t length, std::int32_t middle, std::int32_t height) {
        return heights.level({-length, 0}, {middle, -height}, {length, 0});
    };
    for (const std::int32_t length : {40, 1000, 1 << 20, 1 << 27}) {
        for (const std::int32_t middle : {0, 7, -33}) {
            CHECK(level(length, middle, 17) == 0);
            CHECK(level(length, middle, 16) == 0);
            CHECK(level(length, middle, 15) == 1);
            CHECK(level(length, middle, 8) == 1);
            CHECK(level(length, middle, 7) == 2);
            CHECK(level(length, middle, 2) == 3);
            CHECK(level(length, middle, 1) == 4);  // just not low
        }
    }
    // Slanted: height times length is the doubled area, 1 here.
    for (std::uint32_t k = 1; k < 20; ++k) {
        const std::int32_t reach = 1 << k;
        CHECK(heights.level({0, 0}, {reach, 1}, {2 * reach + 1, 2}, 1) == (std::min)(12u, 4 + k + 2));
        CHECK(heights.is_low({0, 0}, {reach, 0}, {2 * reach + 1, 1}));
    }
    CHECK_FALSE(triangle_heights{grid{}}.is_low({0, 0}, {1000, 0}, {2001, 1}));  // no em, nothing is low
    CHECK(triangle_heights{grid{}}.doubled_area_of_low() == 0);
}

TEST_CASE("a triangle is low exactly where its height is below 2^-20 em, and levels follow the height",
          "[triangulate][triangle_heights]")
{
    test::dice d{61};
    for (const double em : {1000.0 * 512.0, 2048.0 * 512.0, 0x1p25}) {
        const triangle_heights heights{{.cells = 512.0, .units_per_em = em / 512.0}};
        int low = 0, high = 0;
        for (int round = 0; round < 20'000; ++round) {
            const std::int32_t length = 1 << (2 + d.roll(26)), slant = d.roll(2 * length) - length;
            const grid_point a{d.roll(100), d.roll(100)}, b{a.x + length, a.y + slant};
            const double share = d.fraction();
            const grid_point c{a.x + static_cast<std::int32_t>(share * length),
                               a.y + static_cast<std::int32_t>(share * slant) + d.roll(100)};
            const std::int64_t doubled = orientation(a, b, c);
            if (doubled <= 0) continue;
            const auto side = [](grid_point p, grid_point q) {
                return std::hypot(double(p.x) - q.x, double(p.y) - q.y);
            };
            const double height = double(doubled) / (std::max)({side(a, b), side(b, c), side(c, a)});
            const double doublings = std::log2(em * 0x1p-16 / height);         // until it is 2^-16 em
            if (std::abs(doublings - std::round(doublings)) < 1e-9) continue;  // too near for doubles to tell
            const auto wanted = static_cast<std::uint32_t>((std::clamp)(std::ceil(doublings), 0.0, 12.0));
            INFO("height " << height << " cells of an em of " << em);
            REQUIRE(heights.level(a, b, c) == wanted);
            REQUIRE(heights.is_low(a, b, c) == (wanted >= triangle_heights::low));
            REQUIRE(heights.level(b, c, a) == wanted);
            if (doubled >= heights.doubled_area_of_low()) REQUIRE(wanted < triangle_heights::low);
            (wanted >= triangle_heights::low ? low : high) += 1;
        }
        CHECK(low > 100);
        CHECK(high > 100);
    }
}
