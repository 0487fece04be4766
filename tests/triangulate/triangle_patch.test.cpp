// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/triangle_patch.hpp>

#include "support/catch.hpp"
#include "support/oracle.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

using namespace typemesh;
using detail::triangle_neighbours;
using detail::triangle_patch;

namespace {

/// The numbers of triangles at each level: the lowest first, so that less is better.
using tally = std::array<std::uint32_t, triangle_heights::levels>;

tally operator+(tally a, const tally& b)
{
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
}
tally of(const triangle_heights& heights, grid_point a, grid_point b, grid_point c)
{
    tally t{};
    const std::uint32_t level = heights.level(a, b, c);
    if (level != 0) ++t[triangle_heights::levels - 1 - level];
    return t;
}

/// The best of all triangulations of a convex polygon.
tally best_of(const test::polyline& p, const triangle_heights& heights)
{
    std::map<std::pair<std::size_t, std::size_t>, tally> known;
    const auto over = [&](const auto& self, std::size_t i, std::size_t j) -> tally {
        if (j == i + 1) return {};
        if (const auto found = known.find({i, j}); found != known.end()) return found->second;
        tally best;
        best.fill(~0u >> 8);
        for (std::size_t k = i + 1; k < j; ++k)
            if (orientation(p[i], p[k], p[j]) > 0)
                best = (std::min)(best, self(self, i, k) + self(self, k, j) + of(heights, p[i], p[k], p[j]));
        return known[{i, j}] = best;
    };
    return over(over, 0, p.size() - 1);
}

/// A flat convex polygon: an arc with chords of different lengths, so that many triangles are low.
test::polyline flat_arc(test::dice& d, int n)
{
    test::polyline p;
    std::int32_t x = 0;
    for (int i = 0; i < n; ++i) {
        p.push_back({x, static_cast<std::int32_t>(std::int64_t{x} * x / 40'000)});
        x += 400 + d.roll(2000);
    }
    return p;
}

}  // namespace

TEST_CASE("a patch that may grow over a whole polygon cuts it in the best way", "[triangulate][triangle_patch]")
{
    test::dice d{81};
    int improved = 0;
    for (int round = 0; round < 2000; ++round) {
        const test::polyline p = flat_arc(d, 4 + d.roll(12));
        const auto n = static_cast<std::uint32_t>(p.size());
        const contours loops = test::contours_of(std::vector<test::polyline>{p});
        const region r = region::proven(loops, 0, 1);
        REQUIRE(test::oracle::broken_cycle(test::oracle::loops_of(r)) == "");
        std::vector<triangle> triangles;
        for (std::uint32_t i = 0; i + 2 < n; ++i) triangles.push_back({n - 1, i, i + 1});  // a fan with low triangles
        const triangle_heights heights{{.cells = 1.0, .units_per_em = 0x1p20 * (1 + d.roll(60))}};
        const auto tally_of = [&] {
            tally sum{};
            for (const triangle t : triangles) sum = sum + of(heights, p[t.a], p[t.b], p[t.c]);
            return sum;
        };
        const tally before = tally_of();
        std::uint32_t low = n;
        for (std::uint32_t t = 0; t < triangles.size() && low == n; ++t)
            if (heights.is_low(p[triangles[t].a], p[triangles[t].b], p[triangles[t].c])) low = t;
        if (low == n) continue;
        triangle_neighbours neighbours{n, r.starts(), triangles};
        triangle_patch patch{r.points(), triangles, heights, neighbours};
        std::int64_t looks = 1'000'000;
        const auto outcome = patch.raise(low, looks);
        INFO(test::shape({"arc", {p}}));
        REQUIRE(test::oracle::broken_law(r, triangles) == "");
        REQUIRE(outcome.improved == (tally_of() < before));
        REQUIRE(tally_of() <= before);
        if (!outcome.clear) REQUIRE(tally_of() == best_of(p, heights));  // it has grown over everything
        improved += outcome.improved;
    }
    CHECK(improved > 300);
}

TEST_CASE("a patch stops when its number of looks is used up", "[triangulate][triangle_patch]")
{
    const test::polyline p{{0, 0}, {1000, 1}, {2000, 4}, {3000, 9}, {4000, 16}};
    const contours loops = test::contours_of(std::vector<test::polyline>{p});
    const region r = region::proven(loops, 0, 1);
    std::vector<triangle> triangles{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}};
    const std::vector<triangle> given = triangles;
    const triangle_heights heights{{.cells = 1.0, .units_per_em = 0x1p25}};
    REQUIRE(heights.is_low(p[4], p[0], p[1]));
    triangle_neighbours neighbours{5, r.starts(), triangles};
    triangle_patch patch{r.points(), triangles, heights, neighbours};
    std::int64_t none = 0;
    const auto outcome = patch.raise(0, none);
    CHECK_FALSE(outcome.improved);
    CHECK((triangles == given));
}
