// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/area_path.hpp>

#include <algorithm>
#include <cstdint>
#include <random>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// The least of 2^20 times the area at the places i / 1024, and the greatest size of a coefficient.
struct sampled {
    std::int64_t least = INT64_MAX, size = 0;

    sampled(const area_path::corners& p, const area_path::corners& q)
    {
        const auto cross = [](grid_point a, grid_point b, grid_point c, grid_point d) {
            return (std::int64_t{b.x} - a.x) * (std::int64_t{d.y} - c.y) -
                   (std::int64_t{b.y} - a.y) * (std::int64_t{d.x} - c.x);
        };
        const std::int64_t start = cross(p.a, p.b, p.a, p.c), end = cross(q.a, q.b, q.a, q.c);
        const std::int64_t mixed = cross(p.a, p.b, q.a, q.c) + cross(q.a, q.b, p.a, p.c);
        size = std::max({std::abs(start), std::abs(mixed), std::abs(end)});
        for (std::int64_t i = 1; i < 1024; ++i)
            least = std::min(least, start * (1024 - i) * (1024 - i) + mixed * i * (1024 - i) + end * i * i);
    }
};

}  // namespace

TEST_CASE("an area that is proven positive is positive at all places, and few others are not proven", "[morph]")
{
    std::mt19937 random{7};
    const auto some = [&](int reach) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * reach)) - reach;
    };
    int proven = 0, close = 0;
    for (int i = 0; i < 20000; ++i) {
        const int reach = i % 2 == 0 ? 20 : 5000;
        const auto corner = [&] { return grid_point{some(reach), some(reach)}; };
        const area_path::corners p{corner(), corner(), corner()}, q{corner(), corner(), corner()};
        const sampled found{p, q};
        const bool positive = area_path{p, q}.is_positive();
        if (positive) CHECK(found.least > 0);
        if (!positive) CHECK(found.least <= found.size * 1024);  // not farther from zero than the smallest part is long
        proven += positive ? 1 : 0;
        close += !positive && found.least > 0 ? 1 : 0;
    }
    CHECK(proven > 1500);
    CHECK(close < proven / 20);
}

TEST_CASE("an area may be zero only at the very ends of a way", "[morph]")
{
    const area_path::corners flat{{0, 0}, {10, 0}, {5, 0}}, high{{0, 0}, {10, 0}, {5, 8}},
        low{{0, 0}, {10, 0}, {5, -8}};
    CHECK(area_path{flat, high}.is_positive());
    CHECK(area_path{high, flat}.is_positive());
    CHECK_FALSE(area_path{flat, flat}.is_positive());
    CHECK_FALSE(area_path{low, high}.is_positive());
    CHECK(area_path{low, high}.is_positive(17, 32));
    CHECK_FALSE(area_path{low, high}.is_positive(16, 32));  // zero at the middle, which is no end
    CHECK_FALSE(area_path{low, high}.is_positive(0, 16));
}

TEST_CASE("a triangle that turns over in between is seen, though both ends are good", "[morph]")
{
    // Half a turn: every place is good. Edges that are exchanged on straight ways: the middle is not.
    const area_path::corners start{{0, 0}, {10, 0}, {0, 10}}, turned{{0, 0}, {-10, 0}, {0, -10}};
    CHECK_FALSE(area_path{start, turned}.is_positive());
    const area_path::corners quarter{{0, 0}, {0, 10}, {-10, 0}};
    CHECK(area_path{start, quarter}.is_positive());
    // All three coefficients are positive only in parts: the middle coefficient is negative, but the area is not.
    const area_path::corners a{{0, 0}, {100, 0}, {0, 100}}, b{{0, 0}, {-45, 90}, {-90, -45}};
    CHECK(area_path{a, b}.is_positive() == (sampled{a, b}.least > 0));
}

TEST_CASE("areas at the reach of the grid do not overflow", "[morph]")
{
    constexpr std::int32_t r = area_path::reach;
    const area_path::corners most{{-r, -r}, {r, -r}, {r, r}}, least{{-r, -r}, {r, r}, {r, -r}};
    CHECK(area_path{most, most}.is_positive());
    CHECK_FALSE(area_path{least, least}.is_positive());
    CHECK_FALSE(area_path{most, least}.is_positive());
    const area_path::corners other{{r, -r}, {r, r}, {-r, r}};
    CHECK(area_path{most, other}.is_positive());
}
