// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/tube_thinning.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

/// A corner where two arcs meet, and a line that closes them: a leaf cut in half.
struct thinned_leaf {
    std::vector<grid_point> points;
    std::vector<side_point> sides;
    std::uint32_t starts[2] = {0, 0};

    explicit thinned_leaf(int pieces)
    {
        constexpr double r = 100'000.0;
        for (const double sign : {1.0, -1.0})
            for (int i = sign > 0.0 ? 0 : 1; i <= pieces; ++i) {
                const double t = (sign > 0.0 ? pieces - i : i) / double(pieces) * 1.0;
                points.push_back(
                    {static_cast<std::int32_t>(r * std::sin(t)),
                     static_cast<std::int32_t>(-sign * (r * (1.0 - std::cos(t))) - sign * 0.1 * r * std::sin(t))});
            }
        sides.resize(points.size());
        sides[static_cast<std::size_t>(pieces)].doubled = sides[0].doubled = sides.back().doubled = true;
        for (side_point& s : sides) s.seam = s.doubled;
        starts[1] = static_cast<std::uint32_t>(points.size());
    }
    [[nodiscard]] detail::tube_paths view() const { return {points, starts}; }
};

std::vector<double> one_radius(double radius) { return {radius}; }

}  // namespace

TEST_CASE("points beside a sharp corner make room for a thick tube, within the deviation", "[extrude]")
{
    const thinned_leaf leaf{40};
    for (const double radius : {500.0, 3000.0}) {
        detail::tube_clearance clearance;
        REQUIRE_FALSE(clearance.find(leaf.view(), radius));
        const double plain = clearance.radii()[0];
        detail::tube_thinning thinning;
        REQUIRE_FALSE(thinning.find(leaf.view(), leaf.sides, one_radius(radius), 0.25));
        std::vector<grid_point> kept;
        for (const std::uint32_t i : thinning.kept()) kept.push_back(leaf.points[i]);
        REQUIRE_FALSE(clearance.find({kept, thinning.starts()}, radius));
        CHECK(clearance.radii()[0] >= plain);
        if (plain < radius) CHECK(clearance.radii()[0] > 1.5 * plain);
        // Everything that is sharp stays, and what is left out lies near the new edges.
        std::size_t doubled = 0;
        for (const std::uint32_t i : thinning.kept()) doubled += leaf.sides[i].doubled;
        CHECK(doubled == 3);
        for (const grid_point& p : leaf.points) {
            double nearest = 1e9;
            for (std::size_t i = 0; i < kept.size(); ++i) {
                const point a = delta(kept[i], kept[(i + 1) % kept.size()]), q = delta(kept[i], p);
                const double on = std::fmin(std::fmax(dot(q, a) / dot(a, a), 0.0), 1.0);
                nearest = std::fmin(nearest, length(q - on * a));
            }
            CHECK(nearest <= 0.25 * radius);
        }
    }
}

TEST_CASE("a tiny edge between two sharp corners becomes one corner, whose normals are those of its new edges",
          "[extrude]")
{
    // The foot of a v, ten units wide.
    const std::vector<grid_point> v{{0, 100'000},      {40'000, 0},      {40'500, 0},      {80'500, 100'000},
                                    {60'000, 100'000}, {40'250, 40'000}, {20'000, 100'000}};
    std::vector<side_point> sides(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
        sides[i].before = rounded(wall_normal(v[(i + v.size() - 1) % v.size()], v[i]));
        sides[i].after = rounded(wall_normal(v[i], v[(i + 1) % v.size()]));
        sides[i].doubled = true;
    }
    sides[0].seam = true;
    const std::uint32_t starts[] = {0, static_cast<std::uint32_t>(v.size())};
    detail::tube_thinning thinning;
    REQUIRE_FALSE(thinning.find({v, starts}, sides, one_radius(4000.0), 0.25));
    REQUIRE(thinning.kept().size() == v.size() - 1);
    std::vector<grid_point> points;
    std::vector<side_point> kept;
    for (const std::uint32_t i : thinning.kept()) {
        points.push_back(v[i]);
        kept.push_back(sides[i]);
    }
    thinning.light(points, kept, 0.97);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto dot_of = [](vec2 a, point b) { return double{a.x} * b.x + double{a.y} * b.y; };
        CHECK(dot_of(kept[i].after, wall_normal(points[i], points[(i + 1) % points.size()])) > 0.99);
        CHECK(dot_of(kept[i].before, wall_normal(points[(i + points.size() - 1) % points.size()], points[i])) > 0.99);
    }
    detail::tube_clearance clearance;
    REQUIRE_FALSE(clearance.find({points, thinning.starts()}, 4000.0));
    CHECK(clearance.radii()[0] == Approx(4000.0).epsilon(1e-12));  // the last bits are free under -ffast-math
}

TEST_CASE("no point is left out without need, or if no deviation is allowed", "[extrude]")
{
    const thinned_leaf leaf{40};
    detail::tube_thinning thinning;
    REQUIRE_FALSE(thinning.find(leaf.view(), leaf.sides, one_radius(3000.0), 0.0));
    CHECK(thinning.kept().size() == leaf.points.size());
    REQUIRE_FALSE(thinning.find(leaf.view(), leaf.sides, one_radius(20.0), 0.25));
    CHECK(thinning.kept().size() == leaf.points.size());
    // A circle of chords allows no thicker tube with fewer of them.
    std::vector<grid_point> circle;
    for (int i = 0; i < 64; ++i)
        circle.push_back({static_cast<std::int32_t>(1e5 * std::cos(i * 0.09817477)),
                          static_cast<std::int32_t>(1e5 * std::sin(i * 0.09817477))});
    const std::vector<side_point> smooth(64);
    const std::uint32_t starts[] = {0, 64};
    REQUIRE_FALSE(thinning.find({circle, starts}, smooth, one_radius(2e5), 0.25));
    CHECK(thinning.kept().size() > 32);
}

TEST_CASE("an edge replaces at most 64 points, and the ends of open paths get their edges' normals", "[extrude]")
{
    // A corner beside many points in a line, and a curve at the end.
    std::vector<grid_point> points{{100'000, 10'000}, {0, 0}};
    for (int i = 1; i <= 2000; ++i) points.push_back({50 * i, 0});
    points.push_back({100'040, 20});
    std::vector<side_point> sides(points.size());
    sides.back().before = sides.back().after = rounded(unit(point{20.0, -40.0}));
    const std::uint32_t starts[] = {0, static_cast<std::uint32_t>(points.size())};
    const std::uint8_t open[] = {1};
    detail::tube_thinning thinning;
    REQUIRE_FALSE(thinning.find({points, starts, open}, sides, one_radius(20'000.0), 0.5));
    std::uint32_t gap = 0;
    std::vector<grid_point> kept;
    std::vector<side_point> lit;
    for (std::size_t i = 0; i < thinning.kept().size(); ++i) {
        const std::uint32_t k = thinning.kept()[i];
        if (i != 0) gap = (std::max)(gap, k - thinning.kept()[i - 1] - 1);
        kept.push_back(points[k]);
        lit.push_back(sides[k]);
    }
    CHECK(gap == 64);
    REQUIRE(kept[kept.size() - 2] != points[points.size() - 2]);
    thinning.light(kept, lit, 0.97);
    const vec2 wanted = rounded(wall_normal(kept[kept.size() - 2], kept.back()));
    CHECK((lit.back().before == wanted && lit.back().after == wanted));
}

TEST_CASE("thinning allocates nothing the second time, and says when memory runs out", "[extrude]")
{
    const thinned_leaf leaf{40};
    test::counting_memory counted;
    detail::tube_thinning thinning{counted.source()};
    REQUIRE_FALSE(thinning.find(leaf.view(), leaf.sides, one_radius(3000.0), 0.25));
    const std::size_t warm = counted.requests;
    REQUIRE_FALSE(thinning.find(leaf.view(), leaf.sides, one_radius(3000.0), 0.25));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        detail::tube_thinning poor{failing.source()};
        CHECK(poor.find(leaf.view(), leaf.sides, one_radius(3000.0), 0.25) == error::out_of_memory);
    }
}
