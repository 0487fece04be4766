// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/steady_triangles.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// The directed edges that have no reverse, sorted: the boundary.
std::vector<std::pair<std::uint32_t, std::uint32_t>> boundary(const std::vector<triangle>& all)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, open;
    for (const triangle& t : all)
        for (const auto& e : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) edges.push_back(e);
    std::sort(edges.begin(), edges.end());
    for (const auto& e : edges)
        if (!std::binary_search(edges.begin(), edges.end(), std::pair{e.second, e.first})) open.push_back(e);
    return open;
}

}  // namespace

TEST_CASE("flips make triangles hold throughout a stretch", "[morph]")
{
    // A fan from the corner 0 over a row of points that becomes a valley: only flips across the fan hold there.
    std::vector<grid_point> places = {{0, 0}, {100, 0}, {100, 30}, {80, 60}, {60, 80}, {30, 100}, {0, 100}};
    const std::size_t n = places.size();
    const std::vector<grid_point> later = {{0, 0}, {100, 0}, {100, 100}, {60, 98}, {40, 96}, {20, 98}, {0, 100}};
    places.insert(places.end(), later.begin(), later.end());
    std::vector<triangle> fan;
    for (std::uint32_t i = 1; i + 1 < n; ++i) fan.push_back({6, (i + 5) % 7, (i + 6) % 7});
    fan = {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {1, 6, 0}};
    const moving_points points{places, n, {}};
    steady_triangles flips;
    const auto before = boundary(fan);
    std::vector<triangle> held = fan;
    CHECK(flips.repair(points, {}, held) == 0);
    CHECK(boundary(held) == before);
    for (const triangle& t : held) CHECK(points.area(0, t).is_positive());

    places[n + 3] = {60, -50};  // the boundary crosses itself: no triangles hold
    held = fan;
    const moving_points crossing{places, n, {}};
    const std::uint32_t left = flips.repair(crossing, {}, held);
    std::uint32_t sum = 0;
    for (const triangle& t : held) sum += flips.fault(t);
    CHECK(left > 0);
    CHECK(left == sum);
    CHECK(boundary(held) == before);
}

TEST_CASE("a quadrilateral whose diagonal fails is flipped, in one step or over several keys", "[morph]")
{
    //  3 ---- 2       the corner 2 moves to the diagonal from 1 to 3 and beyond it: only the other diagonal holds
    //  |      |
    //  0 ---- 1
    std::vector<grid_point> places = {{0, 0},   {100, 0}, {100, 100}, {0, 100}, {0, 0},   {100, 0},
                                      {60, 60}, {0, 100}, {0, 0},     {100, 0}, {40, 40}, {0, 100}};
    const moving_points points{places, 4, {}};
    steady_triangles flips;
    std::vector<triangle> pair = {{0, 1, 3}, {1, 2, 3}};
    CHECK(flips.repair(points, {.key = 0, .steps = 1}, pair) == 0);
    CHECK(pair[0] == triangle{0, 1, 3});
    CHECK(flips.repair(points, {.key = 0, .steps = 2}, pair) == 0);
    CHECK(flips.fault({0, 1, 2}) == 0);
    CHECK(((pair[0] == triangle{0, 1, 2} || pair[1] == triangle{0, 1, 2}) || pair[0].a == 1 || pair[0].a == 3));
    for (const triangle& t : pair) CHECK(flips.fault(t) == 0);
}
