// SPDX-License-Identifier: MIT

#include <typemesh/sweep/impl/sweep_order.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

using namespace typemesh;

namespace {

/// Whether points are sorted by x, then y, then index, as std::stable_sort does it.
bool is_right(const std::vector<grid_point>& points, workspace& space)
{
    std::vector<std::uint32_t> order(points.size()), expected(points.size());
    if (!sweep_order(points, space, order.data())) return false;
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return lexicographic_less(points[a], points[b]); });
    return order == expected;
}

std::uint32_t next_random(std::uint64_t& state)
{
    state = state * 6'364'136'223'846'793'005u + 1'442'695'040'888'963'407u;
    return static_cast<std::uint32_t>(state >> 33);
}

}  // namespace

TEST_CASE("sweep_order() sorts points of every number and spread like std::stable_sort", "[core][sweep_order]")
{
    workspace space;
    std::uint64_t seed = 1;
    for (const unsigned n :
         {0u, 1u, 2u, 3u, 12u, 13u, 60u, 200u, 255u, 256u, 257u, 1000u, 2047u, 2048u, 2049u, 20'000u}) {
        for (const std::uint32_t width : {1u, 2u, 7u, 1000u, 1u << 20, (1u << 29) + 1}) {
            for (const std::uint32_t height : {1u, 3u, 1u << 20, (1u << 29) + 1}) {
                std::vector<grid_point> points;
                for (std::size_t i = 0; i < n; ++i)
                    points.push_back({static_cast<std::int32_t>(next_random(seed) % width) - (1 << 28),
                                      static_cast<std::int32_t>(next_random(seed) % height) - (1 << 28)});
                INFO(n << " points in " << width << " x " << height);
                CHECK(is_right(points, space));
            }
        }
    }
}

TEST_CASE("sweep_order() sorts crowds in one column among distant points", "[core][sweep_order]")
{
    workspace space;
    std::uint64_t seed = 2;
    for (const int crowd : {5, 15, 16, 17, 40, 255, 256, 600, 1900}) {
        std::vector<grid_point> points{{-(1 << 28), 5}, {1 << 28, -7}};
        for (int i = 0; i < crowd; ++i)
            points.push_back({static_cast<std::int32_t>(next_random(seed) % 2),
                              static_cast<std::int32_t>(next_random(seed) % 100'000)});
        for (int i = 0; i < 100; ++i) points.push_back({static_cast<std::int32_t>(next_random(seed) % (1u << 28)), 0});
        INFO("a crowd of " << crowd);
        CHECK(is_right(points, space));
        for (grid_point& p : points) p = {p.y, p.x};
        CHECK(is_right(points, space));
    }
}

TEST_CASE("sweep_order() keeps the order of equal points among distant points", "[core][sweep_order]")
{
    workspace space;
    for (const int crowd : {5, 15, 16, 17, 40, 255, 256, 600}) {
        std::vector<grid_point> points{{-(1 << 28), -(1 << 28)}};
        for (int i = 0; i < crowd; ++i) points.push_back({i % 2, 0});
        points.push_back({1 << 28, 1 << 28});
        INFO("a crowd of " << crowd);
        CHECK(is_right(points, space));
    }
}

TEST_CASE("sweep_order() reports that memory ran out", "[core][sweep_order]")
{
    test::counting_memory memory{.fail_at = 1};
    workspace space{memory.source()};
    const std::vector<grid_point> points{{1, 2}, {0, 1}};
    std::uint32_t order[2];
    CHECK_FALSE(sweep_order(points, space, order));
    memory.fail_at = 0;
    CHECK(sweep_order(points, space, order));
    CHECK(order[0] == 1);
}

TEST_CASE("the points of contours are sorted once, until they change", "[sweep]")
{
    contours loops;
    test::counting_memory memory;
    workspace space{memory.source()};
    CHECK(sort_points(loops, space));
    CHECK(loops.order().empty());

    for (const grid_point p : {grid_point{4, 1}, grid_point{0, 7}, grid_point{4, 0}})
        REQUIRE(loops.points.push_back(p));
    CHECK(loops.order().empty());
    REQUIRE(sort_points(loops, space));
    const auto is = [&](std::vector<std::uint32_t> expected) { return std::ranges::equal(loops.order(), expected); };
    CHECK(is({1, 2, 0}));
    const std::size_t before = memory.requests;
    space.trim();
    REQUIRE(sort_points(loops, space));  // nothing to do
    CHECK(memory.requests == before);

    REQUIRE(loops.points.push_back({-1, 0}));
    CHECK(loops.order().empty());
    REQUIRE(sort_points(loops, space));
    CHECK(is({3, 1, 2, 0}));

    loops.forget_order();
    loops.points[1] = {9, 9};
    REQUIRE(sort_points(loops, space));
    CHECK(is({3, 2, 0, 1}));

    loops.forget_order();
    space.trim();
    memory.fail_at = memory.requests + 1;
    CHECK_FALSE(sort_points(loops, space));
    CHECK(loops.order().empty());
}
