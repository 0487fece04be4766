// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/pinched_edges.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <map>
#include <utility>

using namespace typemesh;

TEST_CASE("inner edges of an inflated outline get points over their first ends, one for edges side by side",
          "[extrude]")
{
    // A zigzag without inner points: a strip of 2 n + 2 points, whose edges across and along are inner but for the rim.
    for (const std::uint32_t n : {1u, 2u, 7u, 101u, 102u, 107u}) {
        CAPTURE(n);
        const bool apart = n > 100;
        contours loops;
        triangle_list triangles;
        buffer<membrane_point> membrane;
        const std::uint32_t rim = 2 * n + 2;
        REQUIRE(loops.starts.push_back(0));
        REQUIRE(loops.starts.push_back(rim));
        for (std::uint32_t i = 0; i < rim; ++i) {
            const auto x = static_cast<std::int32_t>(i <= n ? i : rim - 1 - i);
            REQUIRE(loops.points.push_back({100 * x, i <= n ? 0 : 1}));
            REQUIRE(membrane.push_back({}));
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            REQUIRE(triangles.push_back({i, i + 1, rim - 1 - i}));
            REQUIRE(triangles.push_back({i + 1, rim - 2 - i, rim - 1 - i}));
        }
        // Edge by edge along the strip, two and two have the same first end.
        const std::size_t added = n, before = triangles.size();
        detail::pinched_edges pinches;
        REQUIRE(pinches(loops, rim, triangles, membrane, 0x1p-22f, apart));
        CHECK(loops.points.size() == rim + added);
        CHECK(membrane.size() == rim + added);
        CHECK(triangles.size() == before + 2 * added);
        // No edge joins two points of the outline but the outline's own, and each of these once.
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        std::int64_t area = 0;
        std::size_t turned = 0, upright = 0, without_area = 0;
        for (const triangle t : triangles) {
            for (const auto& e : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) ++edges[e];
            const std::int64_t own = orientation(loops.points[t.a], loops.points[t.b], loops.points[t.c]);
            area += own;
            turned += own < 0;
            upright += own == 0;
            const grid_point a = loops.points[t.a], b = loops.points[t.b], c = loops.points[t.c];
            without_area += a == b && b == c;
        }
        std::size_t on_rim = 0;
        for (const auto& [e, count] : edges) {
            CHECK(count == 1);
            if (e.first >= rim || e.second >= rim) {
                CHECK(edges.count({e.second, e.first}) == 1);
                continue;
            }
            CHECK(e.second == (e.first + 1) % rim);
            ++on_rim;
        }
        CHECK(on_rim == rim);
        CHECK(area == 200 * std::int64_t{n});
        CHECK(turned == 0);
        CHECK(upright == 2 * added);
        CHECK(without_area == 0);
        // Their heights are tiny, the least in each place; no two are equal if places are not known to be apart.
        std::map<float, int> heights;
        std::map<std::pair<std::int32_t, std::int32_t>, float> greatest;
        for (std::size_t i = rim; i < membrane.size(); ++i) {
            CHECK(membrane[i].height > 0.0f);
            CHECK(membrane[i].height < 1e-4f);
            ++heights[membrane[i].height];
            float& height = greatest[{loops.points[i].x, loops.points[i].y}];
            CHECK(membrane[i].height > height);
            if (apart) CHECK(membrane[i].height == height + 0x1p-22f);
            height = membrane[i].height;
        }
        if (!apart) CHECK(heights.size() == added);
    }
}

TEST_CASE("inner edges that leave a point, but not side by side, get points of different heights over it", "[extrude]")
{
    //     4 ----- 3 ----- 2      The edges 0 2 and 0 4 are pinched. The inner point 6 stands between them.
    //     |  \     6     /  |
    //     5 ------ 0 ------ 1
    for (const bool apart : {false, true}) {
        CAPTURE(apart);
        contours loops;
        triangle_list triangles;
        buffer<membrane_point> membrane;
        constexpr std::uint32_t rim = 6;
        REQUIRE(loops.starts.push_back(0));
        REQUIRE(loops.starts.push_back(rim));
        for (const grid_point p : {grid_point{0, 0}, {20, 0}, {20, 20}, {0, 20}, {-20, 20}, {-20, 0}, {0, 10}})
            REQUIRE(loops.points.push_back(p));
        for (std::uint32_t i = 0; i <= rim; ++i) REQUIRE(membrane.push_back({i < rim ? 0.0f : 1.0f, {}}));
        for (const triangle t : {triangle{0, 1, 2}, {0, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 0, 6}, {0, 4, 5}})
            REQUIRE(triangles.push_back(t));
        detail::pinched_edges pinches;
        REQUIRE(pinches(loops, rim, triangles, membrane, 0x1p-22f, apart));
        REQUIRE(loops.points.size() == rim + 3);
        REQUIRE(membrane.size() == rim + 3);
        CHECK(loops.points[7] == grid_point{0, 0});
        CHECK(loops.points[8] == grid_point{0, 0});
        CHECK((std::min)(membrane[7].height, membrane[8].height) == 0x1p-22f);
        CHECK((std::max)(membrane[7].height, membrane[8].height) == 0x1p-21f);
        CHECK(triangles.size() == 10);
    }
}
