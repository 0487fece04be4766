// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/tube_clearance.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace typemesh;

namespace {

/// Paths with their strips, computed plainly.
struct strip_paths {
    std::vector<grid_point> points;
    std::vector<std::uint32_t> starts{0};

    void add(const std::vector<grid_point>& path)
    {
        points.insert(points.end(), path.begin(), path.end());
        starts.push_back(static_cast<std::uint32_t>(points.size()));
    }
    [[nodiscard]] detail::tube_paths view() const { return {points, starts}; }
};

struct quad_strip {
    point corners[4];  // counter-clockwise if not turned inside out
    std::uint32_t path, joints[2];
};

std::vector<quad_strip> quad_strips_of(const strip_paths& all, const std::vector<double>& radii)
{
    std::vector<quad_strip> made;
    for (std::uint32_t k = 0; k + 1 < all.starts.size(); ++k) {
        const std::uint32_t first = all.starts[k], count = all.starts[k + 1] - first;
        const auto at = [&](std::uint32_t i) {
            const grid_point p = all.points[first + i % count];
            return point{double(p.x), double(p.y)};
        };
        const auto lean = [&](std::uint32_t i) {
            const point a = at(i + count - 1), b = at(i), c = at(i + 1);
            const point in = unit(outward(b - a)), out = unit(outward(c - b));
            return radii[k] / (1.0 + dot(in, out)) * (in + out);
        };
        for (std::uint32_t i = 0; i < count; ++i)
            made.push_back({{at(i) + lean(i), at(i + 1) + lean(i + 1), at(i + 1) - lean(i + 1), at(i) - lean(i)},
                            k,
                            {first + i, first + (i + 1) % count}});
    }
    return made;
}

bool is_turned(const quad_strip& s)
{
    const point way = s.corners[1] - s.corners[0], other = s.corners[2] - s.corners[3];
    return dot(way, other) <= 0.0;
}

/// Whether two convex quadrilaterals overlap: no side of either separates them.
bool strips_overlap(const quad_strip& a, const quad_strip& b)
{
    const quad_strip* const both[2] = {&a, &b};
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 4; ++i) {
            const point from = both[k]->corners[i], n = outward(both[k]->corners[(i + 1) % 4] - from);
            bool apart = true;
            for (const point& p : both[1 - k]->corners) apart = apart && dot(p - from, n) >= 0.0;
            if (apart) return false;
        }
    return true;
}

/// Whether any strip is turned inside out or overlaps one that is no neighbour of it.
bool has_conflict(const strip_paths& all, const std::vector<double>& radii)
{
    const auto made = quad_strips_of(all, radii);
    for (const quad_strip& s : made) {
        if (is_turned(s)) return true;
        for (const quad_strip& t : made) {
            const bool neighbours =
                s.joints[0] == t.joints[0] || s.joints[0] == t.joints[1] || s.joints[1] == t.joints[0];
            if (!neighbours && strips_overlap(s, t)) return true;
        }
    }
    return false;
}

std::vector<double> found_radii(const strip_paths& all, double wanted)
{
    detail::tube_clearance clearance;
    REQUIRE_FALSE(clearance.find(all.view(), wanted));
    return {clearance.radii().begin(), clearance.radii().end()};
}

/// A star-shaped polygon with random corners.
std::vector<grid_point> random_star(std::mt19937& random, int corners, double x, double size)
{
    std::vector<grid_point> p;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * 3.14159265358979323846 * i / corners,
                     r = size * (0.3 + 0.7 * double(random() % 1000) / 1000.0);
        p.push_back(
            {static_cast<std::int32_t>(x + r * std::cos(angle)), static_cast<std::int32_t>(r * std::sin(angle))});
    }
    return p;
}

}  // namespace

TEST_CASE("tubes as thick as allowed do not meet, and a little thicker they do", "[extrude]")
{
    std::mt19937 random{7};
    for (int round = 0; round < 300; ++round) {
        strip_paths all;
        all.add(random_star(random, 3 + round % 17, 0.0, 100'000.0));
        const std::vector<double> radii = found_radii(all, 1e7);
        CHECK_FALSE(has_conflict(all, radii));
        // The rule for tips besides: radius * tan(turn / 2) fits into both edges of a corner.
        const std::vector<double> more{radii[0] * 1.001 / detail::tube_clearance::kept};
        bool tip = false;
        for (const quad_strip& s : quad_strips_of(all, more)) {
            const point p{double(all.points[s.joints[0]].x), double(all.points[s.joints[0]].y)},
                q{double(all.points[s.joints[1]].x), double(all.points[s.joints[1]].y)};
            const double length = typemesh::length(q - p);
            tip = tip || std::fabs(dot(s.corners[0] - p, q - p)) >= length * length ||
                  std::fabs(dot(s.corners[1] - q, q - p)) >= length * length;
        }
        CHECK((tip || has_conflict(all, more)));
    }
}

TEST_CASE("tubes along several paths keep apart, also if some are thinner than others", "[extrude]")
{
    std::mt19937 random{11};
    for (int round = 0; round < 300; ++round) {
        strip_paths all;
        const double gap = 1000.0 * (1 + round % 50);
        all.add(random_star(random, 5 + round % 13, 0.0, 100'000.0));
        all.add(random_star(random, 3 + round % 5, 100'000.0 + gap + 30'000.0, 30'000.0));
        all.add(random_star(random, 4, 160'000.0 + 2.0 * gap + 8'000.0, 8'000.0));
        for (const double wanted : {500.0, 20'000.0, 1e7}) {
            const std::vector<double> radii = found_radii(all, wanted);
            for (const double r : radii) CHECK((r > 0.0 && r <= wanted));
            CHECK_FALSE(has_conflict(all, radii));
        }
    }
    // A path that must be thin leaves its neighbour the rest of their distance.
    strip_paths nested;
    nested.add({{0, 0}, {100'000, 0}, {100'000, 100'000}, {0, 100'000}});
    nested.add({{40'000, 40'000}, {40'000, 60'000}, {60'000, 60'000}, {60'000, 40'000}});
    const std::vector<double> radii = found_radii(nested, 1e7);
    CHECK(radii[1] == Catch::Approx(10'000.0 * 63.0 / 64.0));
    CHECK(radii[0] == Catch::Approx((40'000.0 - radii[1]) * 63.0 / 64.0));
}

TEST_CASE("paths that meet are told apart from paths that are near", "[extrude]")
{
    detail::tube_clearance clearance;
    strip_paths touching;
    touching.add({{0, 0}, {1000, 0}, {500, 800}});
    touching.add({{500, 0}, {1000, -800}, {0, -800}});
    touching.add({{5000, 0}, {6000, 0}, {5500, 800}});
    REQUIRE_FALSE(clearance.find(touching.view(), 100.0));
    CHECK(clearance.meets(0));
    CHECK(clearance.meets(1));
    CHECK_FALSE(clearance.meets(2));
    CHECK(clearance.radii()[0] == 100.0);  // NOLINT
    strip_paths close;
    close.add({{0, 0}, {1000, 0}, {500, 800}});
    close.add({{500, -2}, {1000, -800}, {0, -800}});
    REQUIRE_FALSE(clearance.find(close.view(), 100.0));
    CHECK_FALSE(clearance.meets(0));
    CHECK(clearance.radii()[0] < 1.0);
}

TEST_CASE("a point just beyond a long edge does not stop its tube", "[extrude]")
{
    for (const std::int32_t length : {1000, 1 << 20, 1 << 24, 200'000'000})
        for (const std::int32_t step : {1, 2, 10}) {
            strip_paths all;
            all.add({{-length, 0}, {0, 0}, {step, 0}, {length, 0}, {length, length}, {-length, length}});
            CHECK(found_radii(all, 100.0)[0] == 100.0);  // NOLINT
        }
}

TEST_CASE("the search for clearances allocates nothing the second time, and says when memory runs out", "[extrude]")
{
    std::mt19937 random{3};
    strip_paths all;
    all.add(random_star(random, 40, 0.0, 100'000.0));
    test::counting_memory counted;
    detail::tube_clearance clearance{counted.source()};
    REQUIRE_FALSE(clearance.find(all.view(), 1e5));
    const std::size_t warm = counted.requests;
    REQUIRE_FALSE(clearance.find(all.view(), 1e5));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        detail::tube_clearance poor{failing.source()};
        CHECK(poor.find(all.view(), 1e5) == error::out_of_memory);
    }
}

TEST_CASE("a tube's radius in em is never larger than the one in cells", "[extrude]")
{
    CHECK(detail::tube_radius(3.9, 1000.0, 0.5f) == 0.0f);    // NOLINT
    CHECK(detail::tube_radius(500.0, 1000.0, 0.5f) == 0.5f);  // NOLINT
    for (double cells = 5.0; cells < 400.0; cells *= 1.37) {
        const float r = detail::tube_radius(cells, 1000.0, 0.5f);
        CHECK(double{r} * 1000.0 <= cells);
        CHECK(double{r} * 1000.0 > cells * (1.0 - 1e-6));
    }
}
