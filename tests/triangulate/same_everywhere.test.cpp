// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/regions.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cstdint>

using namespace typemesh;

namespace {

/// FNV-1a over whole numbers: the same on every machine.
struct checksum {
    std::uint64_t value = 0xCBF2'9CE4'8422'2325u;
    void add(std::uint32_t word)
    {
        for (int i = 0; i < 4; ++i, word >>= 8) value = (value ^ (word & 0xFFu)) * 0x100'0000'01B3u;
    }
};

/// Whole numbers only, so that no compiler can differ in the input: closed polylines on a small grid, most of which cross.
contours scribble(std::uint64_t seed, int points, std::int32_t width)
{
    contours loops;
    REQUIRE(loops.starts.push_back(0));
    for (int i = 0; i < points; ++i) {
        const auto next = [&] {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            return static_cast<std::int32_t>((seed >> 33) % static_cast<std::uint64_t>(width));
        };
        const std::int32_t x = next(), y = next();
        if (!loops.points.empty() && loops.points.back() == grid_point{x, y}) continue;
        REQUIRE(loops.points.push_back({x, y}));
        REQUIRE(loops.edges.push_back({}));
    }
    REQUIRE(loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size())));
    return loops;
}

/// A smooth convex loop of whole numbers only: points on two parabolas.
test::polyline whole_ring(std::int32_t half)
{
    test::polyline ring;
    for (std::int32_t i = -half; i < half; ++i) ring.push_back({i * 100, i * i * 2});
    for (std::int32_t i = half; i > -half; --i) ring.push_back({i * 100, half * half * 4 - i * i * 2});
    return ring;
}

}  // namespace

TEST_CASE("every compiler makes the same regions and triangles of equal grid points", "[triangulate]")
{
    checksum sum, delaunay;
    std::size_t accepted = 0;
    workspace space;
    const auto add = [&](contours& loops, fill_rule rule) {
        const auto filled = fill(loops, rule, space);
        sum.add(static_cast<std::uint32_t>(filled.error().code));
        if (!filled) return;
        ++accepted;
        for (const grid_point p : filled->points())
            sum.add(static_cast<std::uint32_t>(p.x)), sum.add(static_cast<std::uint32_t>(p.y));
        triangle_list triangles;
        REQUIRE_FALSE(monotone{}(*filled, space, triangles));
        for (const triangle t : triangles) sum.add(t.a), sum.add(t.b), sum.add(t.c);
        triangles.clear();
        REQUIRE_FALSE(constrained_delaunay{}(*filled, space, triangles));
        for (const triangle t : triangles) delaunay.add(t.a), delaunay.add(t.b), delaunay.add(t.c);
    };
    for (const auto& given : test::corpus("regions.txt")) {
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            contours loops = test::contours_of(given.shape);
            add(loops, rule);
        }
    }
    for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
        contours loops = scribble(seed, 3 + static_cast<int>(seed % 5), 12);
        add(loops, fill_rule::non_zero);
    }
    CHECK(accepted > 1500);
    CHECK(sum.value == 0x5161970746dd9006u);  // changes only where the triangulation is changed on purpose
    for (const test::polyline& ring : {whole_ring(40), whole_ring(900)}) {  // smooth: points are left out and return
        contours loops = test::contours_of({ring});
        add(loops, fill_rule::non_zero);
    }
    CHECK(delaunay.value == 0xbc4e8939a21a3bcau);
}
