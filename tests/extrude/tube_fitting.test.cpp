// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/tube_fitting.hpp>

#include "shapes.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>

#include <cmath>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

constexpr double fitting_crease = 0.96;

struct fitted_shape {
    detail::tube_fitting fitting;
    buffer<side_point> sides;

    fitted_shape(const shapes::shape& s, double radius, double cut)
    {
        const region r = s.made();
        REQUIRE(plan_sides(r, curve_normals{}, texture_mapping::em, sides));
        REQUIRE_FALSE(fitting.fit({r.points(), r.starts()}, sides, radius, cut, fitting_crease));
    }
};

double distance_to_paths(grid_point p, const detail::tube_fitting& f)
{
    double nearest = 1e18;
    for (std::size_t k = 0; k + 1 < f.starts().size(); ++k)
        for (std::uint32_t i = f.starts()[k], end = f.starts()[k + 1]; i < end; ++i) {
            const grid_point a = f.points()[i], b = f.points()[i + 1 == end ? f.starts()[k] : i + 1];
            const point along = delta(a, b), q = delta(a, p);
            const double on = std::fmin(std::fmax(dot(q, along) / dot(along, along), 0.0), 1.0);
            nearest = std::fmin(nearest, length(q - on * along));
        }
    return nearest;
}

}  // namespace

TEST_CASE("a tube's path leaves the outline by no more than its radius allows, however thick it was wanted",
          "[extrude]")
{
    for (const auto& s : shapes::all())
        for (const double radius : {2000.0, 20'000.0, 1e7})
            for (const double cut : {0.25, 0.5}) {
                INFO(s.name << " " << radius);
                const fitted_shape f{s, radius, cut};
                CHECK(f.sides.size() == f.fitting.points().size());
                double thickest = 0.0;
                for (const double r : f.fitting.clearance().radii()) thickest = std::fmax(thickest, r);
                for (const grid_point& p : s.loops.points)
                    CHECK(distance_to_paths(p, f.fitting) <= 1.5 * cut * thickest + 1e-6);
            }
}

TEST_CASE("without a cut all points stay, and with one no tube of these letters becomes thinner", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const fitted_shape whole{s, 1e7, 0.0}, cut{s, 1e7, 0.5};
        CHECK(whole.fitting.points().size() == s.points());
        for (std::size_t k = 0; k < whole.fitting.clearance().radii().size(); ++k)
            CHECK(cut.fitting.clearance().radii()[k] >= 0.75 * whole.fitting.clearance().radii()[k]);
    }
}

TEST_CASE("thinning makes no paths meet, and goes on elsewhere", "[extrude]")
{
    // A curve beside a corner; a line that ends just above the curve, and one that crosses it from below. A chord would
    // cross the first line, too.
    constexpr double unit_cells = 512.0;
    std::vector<grid_point> points;
    const auto add = [&](double x, double y) {
        points.push_back({static_cast<std::int32_t>(x * unit_cells), static_cast<std::int32_t>(y * unit_cells)});
    };
    add(60.0, 14.0);
    add(0.0, 0.0);
    for (int i = 1; i <= 60; ++i) {
        const double t = i / 60.0;
        add(24.0 * t * (1.0 - t) + 40.0 * t * t, -20.0 * t * (1.0 - t) - 6.0 * t * t);
    }
    add(120.0, -6.0);
    std::vector<std::uint32_t> starts{0, static_cast<std::uint32_t>(points.size())};
    add(10.0, -4.7);
    add(10.0, 1.0);
    starts.push_back(static_cast<std::uint32_t>(points.size()));
    add(14.0, -12.0);
    add(14.0, -5.9);
    starts.push_back(static_cast<std::uint32_t>(points.size()));
    // Far away, a path that can be thinned.
    for (std::size_t i = 0; i < starts[1]; ++i) points.push_back({points[i].x + 1'000'000, points[i].y});
    starts.push_back(static_cast<std::uint32_t>(points.size()));
    const std::vector<std::uint8_t> open(4, 1);
    const auto fit = [&](double cut) {
        buffer<side_point> sides;
        for (std::size_t i = 0; i < points.size(); ++i) REQUIRE(sides.push_back({}));
        detail::tube_fitting f;
        REQUIRE_FALSE(f.fit({points, starts, open}, sides, 10.0 * unit_cells, cut, fitting_crease));
        std::vector<bool> meets;
        for (std::size_t k = 0; k < 4; ++k) meets.push_back(f.clearance().meets(k));
        return std::pair{meets, f.starts()[4] - f.starts()[3]};
    };
    const auto drawn = fit(0.0), cut = fit(0.5);
    CHECK(drawn.first == std::vector<bool>{true, false, true, false});
    CHECK(cut.first == drawn.first);
    CHECK(cut.second < drawn.second);
}

TEST_CASE("tubes are fitted without allocations the second time, and say when memory runs out", "[extrude]")
{
    const shapes::shape s = shapes::ribbon(8);
    const region r = s.made();
    const auto fit = [&](detail::tube_fitting& f) {
        buffer<side_point> sides;
        REQUIRE(plan_sides(r, curve_normals{}, texture_mapping::em, sides));
        return f.fit({r.points(), r.starts()}, sides, 20'000.0, 0.5, fitting_crease);
    };
    test::counting_memory counted;
    detail::tube_fitting fitting{counted.source()};
    REQUIRE_FALSE(fit(fitting));
    const std::size_t warm = counted.requests;
    REQUIRE_FALSE(fit(fitting));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        detail::tube_fitting poor{failing.source()};
        CHECK(fit(poor) == error::out_of_memory);
    }
}
