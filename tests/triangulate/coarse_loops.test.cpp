// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/coarse_loops.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <set>
#include <vector>

using namespace typemesh;
using detail::coarse_loops;

namespace {

/// Loops without their smoothing points, and everything that must be true of them.
struct thinned {
    std::size_t kept = 0;

    thinned(const test::shape& s, std::int64_t straightness, bool sheared = false)
    {
        const contours given = test::contours_of(s);
        const auto points = given.points.view();
        const auto starts = given.starts.view();
        workspace space;
        workspace::scope scratch{space};
        coarse_loops coarse;
        REQUIRE(coarse.take(scratch, points, starts, straightness, sheared));
        kept = coarse.points().size();
        REQUIRE(coarse.starts().size() == starts.size());

        std::vector<std::uint32_t> next(points.size(), ~0u);  // on the boundary as it is now
        std::set<std::uint32_t> here;
        for (std::size_t l = 0; l + 1 < starts.size(); ++l) {
            const std::uint32_t begin = coarse.starts()[l], end = coarse.starts()[l + 1];
            REQUIRE(end - begin >= (std::min)(3u, starts[l + 1] - starts[l]));
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t v = coarse.names()[i], w = coarse.names()[i + 1 == end ? begin : i + 1];
                REQUIRE((v >= starts[l] && v < starts[l + 1]));
                if (i > begin) REQUIRE(v > coarse.names()[i - 1]);
                const grid_point p = points[v], at = coarse.points()[i];
                REQUIRE(at == (sheared ? grid_point{5 * p.x + 2 * p.y, p.y} : p));
                next[v] = w;
                here.insert(v);
                check_turns(points, starts[l], starts[l + 1], v, w, straightness);
            }
        }
        // Each point comes back once, between two that are neighbours at that time, in the order of the loop.
        const bool all = coarse.bring_back([&](std::uint32_t before, std::uint32_t v) {
            REQUIRE(here.count(before) == 1);
            REQUIRE(here.insert(v).second);
            REQUIRE(before < v);
            REQUIRE((next[before] > v || next[before] <= before));
            next[v] = next[before];
            next[before] = v;
            return true;
        });
        REQUIRE(all);
        REQUIRE(here.size() == points.size());
        for (std::size_t l = 0; l + 1 < starts.size(); ++l)
            for (std::uint32_t v = starts[l]; v < starts[l + 1]; ++v)
                REQUIRE(next[v] == (v + 1 == starts[l + 1] ? starts[l] : v + 1));
    }

    /// No edge between v and w turns away from the first one by more than the straightness allows.
    static void check_turns(std::span<const grid_point> points, std::uint32_t begin, std::uint32_t end, std::uint32_t v,
                            std::uint32_t w, std::int64_t straightness)
    {
        const auto after = [&](std::uint32_t i) { return i + 1 == end ? begin : i + 1; };
        if (straightness < 0) REQUIRE(after(v) == w);
        const auto edge = [&](std::uint32_t i) {
            const grid_point a = points[i], b = points[after(i)];
            return std::array<double, 2>{double(b.x) - a.x, double(b.y) - a.y};
        };
        const auto first = edge(v);
        for (std::uint32_t i = after(v); i != w; i = after(i)) {
            const auto e = edge(i);
            const double cross = first[0] * e[1] - first[1] * e[0], dot = first[0] * e[0] + first[1] * e[1];
            REQUIRE(double(straightness) * std::abs(cross) < dot * (1.0 + 1e-12));
        }
    }
};

}  // namespace

TEST_CASE("coarse loops leave out smoothing points, and bring each back in its place", "[triangulate][coarse_loops]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        const contours given = test::contours_of(s);
        INFO(s.name);
        for (const std::int64_t straightness : {2, 4, 8}) CHECK(thinned{s, straightness}.kept <= given.points.size());
        CHECK(thinned{s, coarse_loops::keep_all}.kept == given.points.size());
    }
    test::dice d{91};
    for (int i = 0; i < 500; ++i)
        (void)thinned{{"random", {test::random_polygon(3 + d.roll(40), 14, d)}}, 1 + d.roll(8)};
}

TEST_CASE("a fine circle keeps few points, and a rough star all", "[triangulate][coarse_loops]")
{
    const test::shape circle{"circle", {test::circle(2000, 1e8)}};
    CHECK(thinned{circle, 2}.kept < 20);
    CHECK(thinned{circle, 8}.kept > thinned{circle, 2}.kept);
    CHECK(thinned{{"star", {test::star(60, 1e6, 1)}}, 8}.kept >= 50);
}

TEST_CASE("sheared coarse loops contain the same points", "[triangulate][coarse_loops]")
{
    for (const test::shape& s : {test::shape{"lattice", {test::circle(300, 1e6)}}, test::square_with_holes(6, 7)})
        (void)thinned{s, 2, true};
}

TEST_CASE("bring_back() stops when its callback does, and take() reports that memory ran out",
          "[triangulate][coarse_loops]")
{
    const contours given = test::contours_of(std::vector<test::polyline>{test::circle(500, 1e7)});
    workspace space;
    workspace::scope scratch{space};
    coarse_loops coarse;
    REQUIRE(coarse.take(scratch, given.points.view(), given.starts.view(), 2, false));
    int calls = 0;
    CHECK_FALSE(coarse.bring_back([&](std::uint32_t, std::uint32_t) { return ++calls < 5; }));
    CHECK(calls == 5);

    test::counting_memory failing{.fail_at = 1};
    workspace empty{failing.source()};
    workspace::scope none{empty};
    CHECK_FALSE(coarse_loops{}.take(none, given.points.view(), given.starts.view(), 2, false));
}
