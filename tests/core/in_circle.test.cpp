// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/in_circle.hpp>

#include "support/catch.hpp"
#include "support/delaunay.hpp"

using namespace typemesh;

namespace {

bool equal(const detail::two_words& words, test::oracle::int128 sum)
{
    return static_cast<std::int64_t>(words.high) == static_cast<std::int64_t>(sum >> 64) &&
           static_cast<std::int64_t>(words.low) == static_cast<std::int64_t>(sum);
}

}  // namespace

TEST_CASE("in_circle agrees with the determinant", "[core][in_circle]")
{
    test::dice d{1};
    int on_circle = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::int32_t reach = i % 3 == 0 ? 4 : i % 3 == 1 ? 1000 : 1 << 28;
        const auto roll = [&] { return grid_point{d.roll(2 * reach + 1) - reach, d.roll(2 * reach + 1) - reach}; };
        const grid_point a = roll(), b = roll(), c = roll(), e = roll();
        if (test::oracle::side(a, b, c) <= 0) continue;
        const int side = test::oracle::circle_side(a, b, c, e);
        CHECK_QUICKLY(in_circle(a, b, c, e) == side);
        const auto seen_a = seen_point::of(a, c), seen_b = seen_point::of(b, c), seen_e = seen_point::of(e, c);
        const int seen_side =
            circle_side(seen_a, seen_b, seen_e, seen_a.cross(seen_b), seen_a.cross(seen_e), seen_e.cross(seen_b));
        CHECK_QUICKLY(seen_side == side);
        on_circle += side == 0;
    }
    CHECK(on_circle > 1000);
}

TEST_CASE("in_circle notices one grid step at the ends of the grid", "[core][in_circle]")
{
    constexpr std::int32_t r = 1 << 28;
    constexpr grid_point a{-r, -r}, b{r, -r}, c{r, r};
    STATIC_REQUIRE(in_circle(a, b, c, {-r, r}) == 0);
    STATIC_REQUIRE(in_circle(a, b, c, {-r + 1, r}) == 1);
    STATIC_REQUIRE(in_circle(a, b, {r, r - 1}, {-r, r}) == -1);
    STATIC_REQUIRE(in_circle({0, -r}, {r, 0}, {0, r}, {-r, 0}) == 0);
}

TEST_CASE("sums of two and three products in halves agree with numbers of 128 bits", "[core][in_circle]")
{
    using test::oracle::int128;
    test::dice d{2};
    for (int i = 0; i < 400'000; ++i) {
        const int spare = i % 2 == 0 ? 2 : 3;  // bits: a sum of three products has one bit more
        const auto roll = [&] { return static_cast<std::int64_t>(d.bits()) >> (spare + d.roll(63 - spare)); };
        const std::int64_t a = roll(), b = roll(), c = i % 8 < 2 ? -a : roll(), e = i % 16 < 2 ? b : roll();
        const std::int64_t f = i % 8 < 4 ? a : roll(), g = i % 16 < 4 ? b : roll();
        int128 sum = int128{a} * b + int128{c} * e;
        if (!equal(detail::sum_of_products_in_halves(a, b, c, e), sum)) FAIL("two in halves, round " << i);
        if (!equal(detail::sum_of_products(a, b, c, e), sum)) FAIL("two, round " << i);
        if (spare < 3) continue;
        sum = sum - int128{f} * g;
        if (!equal(detail::sum_of_products_in_halves(a, b, c, e, f, g), sum)) FAIL("three in halves, round " << i);
        if (!equal(detail::sum_of_products(a, b, c, e, f, g), sum)) FAIL("three, round " << i);
    }
}

TEST_CASE("of four points on one circle, the diagonal at the smallest point is preferred", "[core][in_circle]")
{
    constexpr grid_point a{0, 0}, b{4, 0}, c{4, 4}, d{0, 4};
    STATIC_REQUIRE(prefers_other_diagonal(b, d, a, c));  // now b d, better a c
    STATIC_REQUIRE_FALSE(prefers_other_diagonal(a, c, d, b));
    STATIC_REQUIRE_FALSE(prefers_other_diagonal(c, a, b, d));
}
