// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/crossing.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <array>

using namespace typemesh;

namespace {

/// Unsigned numbers of 128 bits, which can only be multiplied and compared.
struct wide {
    std::uint64_t high, low;
    static wide product(std::uint64_t a, std::uint64_t b)
    {
        const std::uint64_t ah = a >> 32, al = a & 0xFFFF'FFFFu, bh = b >> 32, bl = b & 0xFFFF'FFFFu;
        const std::uint64_t middle = ah * bl + (al * bl >> 32), other = al * bh + (middle & 0xFFFF'FFFFu);
        return {ah * bh + (middle >> 32) + (other >> 32), other << 32 | ((al * bl) & 0xFFFF'FFFFu)};
    }
    friend bool operator<=(wide a, wide b) { return a.high != b.high ? a.high < b.high : a.low <= b.low; }
};

std::uint64_t size_of(std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); }

/// Whether `rounded` is size * part / whole to the nearest integer: |2 (size part - rounded whole)| <= whole, where
/// sides are compared as products of 128 bits: (2 rounded - 1) whole <= 2 size part <= (2 rounded + 1) whole.
bool is_nearest(std::uint64_t size, std::uint64_t part, std::uint64_t whole, std::uint64_t rounded)
{
    const wide exact = wide::product(2 * size, part);
    return (rounded == 0 || wide::product(2 * rounded - 1, whole) <= exact) &&
           exact <= wide::product(2 * rounded + 1, whole);
}

}  // namespace

TEST_CASE("scaled() rounds size * part / whole exactly, up to the budget", "[fill][crossing]")
{
    test::dice d{31};
    const auto any = [&](int bits) {
        std::uint64_t v = 0;
        for (int i = 0; i < bits; ++i) v = v << 1 | static_cast<std::uint64_t>(d.roll(2));
        return static_cast<std::int64_t>(v);
    };
    for (int i = 0; i < 20'000; ++i) {
        const std::int64_t whole = 1 + any(1 + d.roll(60)), size = any(1 + d.roll(29));
        const std::int64_t part = d.roll(8) == 0 ? whole - any(1 + d.roll(3)) % whole : any(60) % (whole + 1);
        const detail::quotient above = detail::scaled(size, part, whole), below = detail::scaled(-size, part, whole);
        const std::int64_t up = above.nearest(), down = below.nearest();
        INFO(size << " * " << part << " / " << whole);
        REQUIRE(up >= 0);
        REQUIRE(is_nearest(size_of(size), size_of(part), size_of(whole), size_of(up)));
        REQUIRE(down <= 0);
        REQUIRE(is_nearest(size_of(size), size_of(part), size_of(whole), size_of(down)));
        for (const detail::quotient& q : {above, below}) {
            CHECK(q.rest >= 0);
            CHECK(q.rest < whole);
            CHECK(q.is_exact() == (q.rest == 0));
        }
        CHECK(detail::scaled(size, 0, whole).nearest() == 0);
        CHECK(detail::scaled(size, whole, whole).nearest() == size);
    }
    CHECK(detail::scaled(3, 1, 2).nearest() == 2);  // halves go up
    CHECK(detail::scaled(-3, 1, 2).nearest() == -1);
    CHECK(detail::scaled(-3, 1, 2).floor == -2);
    CHECK(detail::scaled(3, 1, 2).floor == 1);
}

TEST_CASE("crossing_of() lies in both boxes, and within half a cell of both lines", "[fill][crossing]")
{
    test::dice d{32};
    int found = 0;
    for (int i = 0; i < 40'000; ++i) {
        const int reach = 1 << (1 + d.roll(28));
        const auto any = [&] { return grid_point{d.roll(2 * reach + 1) - reach, d.roll(2 * reach + 1) - reach}; };
        const std::array<grid_point, 4> p{any(), any(), any(), any()};
        grid_point x{};
        if (!crossing_of(p[0], p[1], p[2], p[3], x)) continue;
        ++found;
        for (int k = 0; k < 4; k += 2) {
            const grid_point a = p[static_cast<std::size_t>(k)], b = p[static_cast<std::size_t>(k) + 1];
            CHECK((std::min)(a.x, b.x) <= x.x);
            CHECK(x.x <= (std::max)(a.x, b.x));
            CHECK((std::min)(a.y, b.y) <= x.y);
            CHECK(x.y <= (std::max)(a.y, b.y));
            // |2 orientation| <= |dx| + |dy|: the cell round x meets the line. 2^62 at most.
            const std::int64_t cell = std::abs(std::int64_t{b.x} - a.x) + std::abs(std::int64_t{b.y} - a.y);
            CHECK(std::abs(2 * orientation(a, b, x)) <= cell);
        }
    }
    CHECK(found > 5000);
}

TEST_CASE("crossing_of() rejects segments that miss, touch with an end, or are parallel", "[fill][crossing]")
{
    const grid_point a{0, 0}, b{10, 10};
    const std::pair<grid_point, grid_point> others[] = {
        {{20, 0}, {30, 5}}, {{5, 5}, {9, 0}}, {{9, 0}, {5, 5}},  {{10, 10}, {20, 0}}, {{1, 0}, {11, 10}},
        {{2, 2}, {7, 7}},   {{0, 0}, {0, 9}}, {{10, 0}, {6, 4}}, {{0, 0}, {10, 10}},  {{3, 3}, {3, 3}},
    };
    for (const auto& [c, e] : others) {
        INFO(c.x << ' ' << c.y << "  " << e.x << ' ' << e.y);
        grid_point x{77, 77};
        CHECK_FALSE(crossing_of(a, b, c, e, x));
        CHECK_FALSE(crossing_of(c, e, b, a, x));
        CHECK(x == grid_point{77, 77});
    }
    grid_point x{};
    REQUIRE(crossing_of(a, b, {0, 10}, {10, 0}, x));
    CHECK(x == grid_point{5, 5});
    constexpr std::int32_t reach = 1 << 28;
    REQUIRE(crossing_of({-reach, -reach}, {reach, reach}, {-reach, reach}, {reach, -reach}, x));
    CHECK(x == grid_point{0, 0});
}

TEST_CASE("an edge that ends on another one does not cross it", "[fill][crossing]")
{
    for (const std::int32_t to : {4, -4}) {
        const grid_point foot{2, 0}, top{2, to}, left{0, 0}, right{4, 0};
        grid_point at;
        for (const auto& [c, d] : {std::pair{left, right}, {right, left}})
            for (const auto& [a, b] : {std::pair{foot, top}, {top, foot}}) {
                CHECK_FALSE(crossing_of(a, b, c, d, at));
                CHECK_FALSE(crossing_of(c, d, a, b, at));
            }
    }
}
