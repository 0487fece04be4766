// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/orientation.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace typemesh;

namespace {

/// A second way, in coordinates around the origin: a x b + b x c + c x a. Each product is at most 2^56, the sum of six below 2^59.
std::int64_t area_by_sum(grid_point a, grid_point b, grid_point c)
{
    const auto cross = [](grid_point p, grid_point q) { return std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x; };
    return cross(a, b) + cross(b, c) + cross(c, a);
}

constexpr std::int32_t reach = 1 << 28;

}  // namespace

TEST_CASE("orientation is the signed area, exactly, over the whole grid", "[core][orientation]")
{
    std::mt19937 random{3};
    std::uniform_int_distribution<std::int32_t> wide{-reach, reach}, narrow{-3, 3};
    std::size_t wrong = 0;
    for (int i = 0; i < 200000; ++i) {
        const grid_point a{wide(random), wide(random)}, b{wide(random), wide(random)};
        grid_point c{wide(random), wide(random)};
        if (i % 2 == 0) c = {a.x + narrow(random), a.y + narrow(random)};
        const std::int64_t area = orientation(a, b, c);
        wrong += area != area_by_sum(a, b, c);
        wrong += orientation(b, c, a) != area || orientation(b, a, c) != -area;
    }
    CHECK(wrong == 0);
}

TEST_CASE("the largest triangles of the grid do not overflow", "[core][orientation]")
{
    const grid_point corners[] = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    const std::int64_t twice = std::int64_t{2} * reach * 2 * reach;
    CHECK(orientation(corners[0], corners[1], corners[2]) == twice);
    CHECK(orientation(corners[2], corners[1], corners[0]) == -twice);
    CHECK(orientation(corners[3], corners[1], corners[0]) == -twice);
}

TEST_CASE("points on a line have no orientation, and a point one step aside has one", "[core][orientation]")
{
    std::mt19937 random{5};
    std::uniform_int_distribution<std::int32_t> step{-1000, 1000}, times{-1000, 1000};
    for (int i = 0; i < 1000; ++i) {
        const grid_point a{step(random) * 1000, step(random) * 1000};
        const std::int32_t dx = step(random), dy = step(random), k = times(random), m = times(random);
        const grid_point b{a.x + k * dx, a.y + k * dy}, c{a.x + m * dx, a.y + m * dy};
        REQUIRE(orientation(a, b, c) == 0);
        if (k != 0 && dx != 0) REQUIRE(orientation(a, b, {c.x, c.y + 1}) != 0);
    }
}

TEST_CASE("the sweep's order is strict and sorts by x, then y", "[core][orientation]")
{
    std::vector<grid_point> points;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y) points.push_back({x, y});
    for (const grid_point a : points) {
        CHECK(!lexicographic_less(a, a));
        for (const grid_point b : points)
            if (!(a == b)) CHECK(lexicographic_less(a, b) != lexicographic_less(b, a));
    }
    std::vector<grid_point> shuffled = points;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937{1});
    std::sort(shuffled.begin(), shuffled.end(), lexicographic_less);
    CHECK(shuffled == points);
}
