// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/in_circle.hpp>

#include "support/catch.hpp"
#include "support/delaunay.hpp"

using namespace typemesh;

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
        if (in_circle(a, b, c, e) != side) CHECK(in_circle(a, b, c, e) == side);
        const auto seen_a = seen_point::of(a, c), seen_b = seen_point::of(b, c), seen_e = seen_point::of(e, c);
        const int seen_side =
            circle_side(seen_a, seen_b, seen_e, seen_a.cross(seen_b), seen_a.cross(seen_e), seen_e.cross(seen_b));
        if (seen_side != side) CHECK(seen_side == side);
        on_circle += side == 0;
    }
    CHECK(on_circle > 1000);
}

TEST_CASE("in_circle tells one grid step at the ends of the grid", "[core][in_circle]")
{
    constexpr std::int32_t r = 1 << 28;
    constexpr grid_point a{-r, -r}, b{r, -r}, c{r, r};
    STATIC_REQUIRE(in_circle(a, b, c, {-r, r}) == 0);
    STATIC_REQUIRE(in_circle(a, b, c, {-r + 1, r}) == 1);
    STATIC_REQUIRE(in_circle(a, b, {r, r - 1}, {-r, r}) == -1);
    STATIC_REQUIRE(in_circle({0, -r}, {r, 0}, {0, r}, {-r, 0}) == 0);
}

TEST_CASE("multiplying halves agrees with numbers of 128 bits", "[core][in_circle]")
{
    test::dice d{2};
    for (int i = 0; i < 200'000; ++i) {
        const auto roll = [&] { return static_cast<std::int64_t>(d.bits()) >> (2 + d.roll(61)); };
        const std::int64_t a = roll(), b = roll(), c = i % 4 == 0 ? -a : roll(), e = i % 8 == 0 ? b : roll();
        const test::oracle::int128 sum = test::oracle::int128{a} * b + test::oracle::int128{c} * e;
        const detail::two_words words = detail::sum_of_products_in_halves(a, b, c, e);
        const bool equal = static_cast<std::int64_t>(words.high) == static_cast<std::int64_t>(sum >> 64) &&
                           static_cast<std::int64_t>(words.low) == static_cast<std::int64_t>(sum);
        if (!equal) CHECK(equal);
        const detail::two_words chosen = detail::sum_of_products(a, b, c, e);
        const bool agrees = words.high == chosen.high && words.low == chosen.low;
        if (!agrees) CHECK(agrees);
    }
}

TEST_CASE("three products are added in halves as in numbers of 128 bits", "[core][in_circle]")
{
    test::dice d{3};
    for (int i = 0; i < 100'000; ++i) {
        const auto roll = [&] { return static_cast<std::int64_t>(d.bits()) >> (3 + d.roll(60)); };
        const std::int64_t a = roll(), b = roll(), c = roll(), e = roll(), f = i % 4 == 0 ? a : roll(),
                           g = i % 8 == 0 ? b : roll();
        const test::oracle::int128 sum =
            test::oracle::int128{a} * b + test::oracle::int128{c} * e - test::oracle::int128{f} * g;
        for (const detail::two_words words :
             {detail::sum_of_products_in_halves(a, b, c, e, f, g), detail::sum_of_products(a, b, c, e, f, g)}) {
            const bool equal = static_cast<std::int64_t>(words.high) == static_cast<std::int64_t>(sum >> 64) &&
                               static_cast<std::int64_t>(words.low) == static_cast<std::int64_t>(sum);
            if (!equal) CHECK(equal);
        }
    }
}

TEST_CASE("of four points on one circle the diagonal that leaves the smallest is preferred", "[core][in_circle]")
{
    constexpr grid_point a{0, 0}, b{4, 0}, c{4, 4}, d{0, 4};
    STATIC_REQUIRE(prefers_other_diagonal(b, d, a, c));  // now b d, better a c
    STATIC_REQUIRE_FALSE(prefers_other_diagonal(a, c, d, b));
    STATIC_REQUIRE_FALSE(prefers_other_diagonal(c, a, b, d));
}
