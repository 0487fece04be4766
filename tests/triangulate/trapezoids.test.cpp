// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/monotone_sweep.hpp>
#include <typemesh/triangulate/impl/trapezoids.hpp>

#include "support/catch.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <set>
#include <vector>

using namespace typemesh;

namespace {

/// What a sweep writes of one shape; empty if that is no region.
struct swept {
    contours loops;
    std::vector<detail::trapezoid> trapezoids;
    std::vector<std::uint32_t> rank;
    std::uint32_t holes = 0, outers = 0;

    explicit swept(const test::shape& s) : loops{test::contours_of(s)}
    {
        const auto points = loops.points.view();
        trapezoids.resize(2 * points.size() + 2);
        rank.assign(points.size(), ~0u);
        detail::monotone_sweep<true, false, detail::trapezoid_output> sweep{
            points, loops.starts.view(), detail::trapezoid_output{trapezoids.data(), rank.data()}};
        workspace space;
        if (sweep.run(space)) {
            trapezoids.clear();
            return;
        }
        trapezoids.resize(static_cast<std::size_t>(sweep.cutter().end() - trapezoids.data()));
        holes = sweep.holes();
        outers = sweep.outers();
    }
};

}  // namespace

TEST_CASE("points are numbered from left to right, and make n + h - c trapezoids", "[triangulate][trapezoids]")
{
    int regions = 0;
    for (const test::shape& s : test::delaunay_shapes()) {
        const swept made{s};
        if (made.trapezoids.empty()) continue;
        ++regions;
        const auto n = made.rank.size();
        INFO(s.name);
        CHECK(made.trapezoids.size() == n + made.holes - made.outers);
        std::vector<std::uint32_t> order(n, ~0u);
        for (std::uint32_t v = 0; v < n; ++v) order.at(made.rank[v]) = v;
        REQUIRE(std::find(order.begin(), order.end(), ~0u) == order.end());
        for (std::size_t i = 1; i < n; ++i)
            REQUIRE(lexicographic_less(made.loops.points[order[i - 1]], made.loops.points[order[i]]));
    }
    CHECK(regions > 20);
}

TEST_CASE("the two points of a trapezoid see each other", "[triangulate][trapezoids]")
{
    test::dice d{95};
    int looked_at = 0;
    for (int round = 0; round < 2000; ++round) {
        const test::shape s{"random polygon", {test::random_polygon(3 + d.roll(30), 14, d)}};
        const swept made{s};
        const auto& points = made.loops.points;
        const auto n = static_cast<std::uint32_t>(points.size());
        const auto next = [&](std::uint32_t v) { return v + 1 == n ? 0 : v + 1; };
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (const detail::trapezoid& t : made.trapezoids) {
            INFO(s);
            INFO("from " << t.left << " to " << t.right);
            REQUIRE(made.rank[t.left] < made.rank[t.right]);
            REQUIRE(seen.insert({t.left, t.right}).second);
            const grid_point a = points[t.left], b = points[t.right];
            for (std::uint32_t v = 0; v < n; ++v) {  // no edge of the region runs through the line of sight
                const grid_point p = points[v], q = points[next(v)];
                const auto side = [](grid_point from, grid_point to, grid_point at) {
                    const std::int64_t o = orientation(from, to, at);
                    return o > 0 ? 1 : o < 0 ? -1 : 0;
                };
                REQUIRE_FALSE((side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0));
            }
            // Its lower side begins left of its left point or in it, and ends right of its right point or in it.
            const std::uint32_t end = next(t.below);
            REQUIRE(made.rank[t.below] <= made.rank[t.left]);
            REQUIRE(made.rank[end] >= made.rank[t.right]);
            REQUIRE(orientation(points[t.below], points[end], a) >= 0);
            REQUIRE(orientation(points[t.below], points[end], b) >= 0);
            ++looked_at;
        }
    }
    CHECK(looked_at > 10'000);
}
