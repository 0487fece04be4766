// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bent_measure.hpp>

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/twist.hpp>

#include <cmath>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;
using detail::bent_measure;

namespace {

constexpr double cells_per_em = 512000.0;

template <deformation D>
bent_measure<D> measure_of(const D& d, double step = 0.0)
{
    return {.bends = d,
            .origin = {0.3, -0.1},
            .em_per_cell = 1.0 / cells_per_em,
            .low = -0.2,
            .high = 0.05,
            .step = step,
            .tolerance = 0.001};
}

grid_point random_cell(test::dice& d, std::int32_t size) { return {d.roll(2 * size) - size, d.roll(2 * size) - size}; }

/// Triangles that are small enough for the measure are nowhere farther from their images than the tolerance.
template <deformation D>
void check_tolerance(const D& bends)
{
    const auto m = measure_of(bends);
    test::dice d{71};
    int accepted = 0;
    double worst = 0.0;
    for (int round = 0; round < 4000; ++round) {
        const std::int32_t size = 1000 << d.roll(9);
        const grid_point a = random_cell(d, 400'000);
        const auto other = [&] {
            const grid_point off = random_cell(d, size);
            return grid_point{a.x + off.x, a.y + off.y};
        };
        const grid_point b = other(), c = other();
        CHECK_QUICKLY(m.triangle(a, b, c) >=
                      (1.0 - 1e-12) * (std::max)({m.length(a, b), m.length(b, c), m.length(c, a)}));
        CHECK_QUICKLY(m.edge(a, b) == Approx(m.length(b, a)).epsilon(1e-12));  // without walls
        if (!(m.triangle(a, b, c) <= 1.0)) continue;
        ++accepted;
        for (const double height : {-0.2, 0.0, 0.05}) {
            const double3 p = m.at(a, height), q = m.at(b, height), r = m.at(c, height);
            const double s = 0.6 * d.fraction(), t = 0.4 * d.fraction();
            const double3 place = p + s * (q - p) + t * (r - p),
                          flat = bends(p).at + s * (bends(q).at - bends(p).at) + t * (bends(r).at - bends(p).at);
            worst = (std::max)(worst, length(bends(place).at - flat));
        }
    }
    CHECK(accepted > 100);
    CHECK(worst <= 0.001);
    CHECK(worst > 0.0001);
}

}  // namespace

TEST_CASE("what a bent measure accepts is within the tolerance, at all heights", "[extrude][bent_measure]")
{
    check_tolerance(on_cylinder{.radius = 1.5});
    check_tolerance(on_cylinder{.radius = -1.5, .axis = text_axis::along});
    check_tolerance(on_sphere{.radius = 1.5});
    check_tolerance(twist{.degrees_per_em = 40.0, .across = 0.35});
}

TEST_CASE("a bent measure is the bound in units of the tolerance, with a wall's height for edges only",
          "[extrude][bent_measure]")
{
    const on_cylinder ring{.radius = 2.0};
    const auto m = measure_of(ring, 0.125);
    const grid_point a{0, 0}, b{51'200, 25'600};
    const double3 place = m.at(b, 0.05);
    CHECK(place.x == Approx(0.4));
    CHECK(place.y == Approx(-0.05));
    CHECK(place.z == 0.05);
    // The width is 0.1 em. The cylinder is farthest from its axis at the greatest height.
    const double cap = 0.125 * (2.05 / 4.0 * 0.01), wall = cap + 0.25 * (0.5 * 0.1 * 0.125);
    CHECK(m.length(a, b) == Approx(cap / 0.001));
    CHECK(m.edge(a, b) == Approx(wall / 0.001));
    CHECK(m.triangle(a, {51'200, 0}, b) == Approx(cap / 0.001));
    CHECK(m.length(a, {0, 100'000}) == 0.0);  // along the axis nothing bends
}

TEST_CASE("triangles that turn when they are bent are too large, however close they are", "[extrude][bent_measure]")
{
    // Half around the cylinder and more, the chord runs backwards.
    const on_cylinder thin{.radius = 0.1};
    auto m = measure_of(thin);
    m.origin = {0.0, 0.0};
    m.low = -0.01;
    m.tolerance = 1.0;  // more than the size of the cylinder
    const auto cells = [](double em) { return std::int32_t(std::lround(cells_per_em * em)); };
    const grid_point a{0, 0}, near{cells(0.2), 0}, far{cells(0.45), 0}, top{0, 50'000};
    CHECK(m.triangle(a, near, top) <= 1.0);
    CHECK(m.triangle(a, far, top) > 1.0);
    CHECK(m.triangle(a, far, {far.x, 5}) > 1.0);
    CHECK(m.triangle(a, far, {far.x, 3}) <= 1.0);  // a rounding of a line has no side
}

TEST_CASE("a bent measure knows what stands on an edge, and leaves room beside edges that stay",
          "[extrude][bent_measure]")
{
    const on_cylinder ring{.radius = 2.0};
    auto m = measure_of(ring, 0.125);
    m.em_per_depth = 0.5;
    const grid_point a{0, 0}, b{51'200, 25'600};
    const double cap = m.length(a, b), wall = m.edge(a, b);
    CHECK(wall > cap);
    CHECK(m.outer(a, b) == wall);
    CHECK(m.upright(a, b, 0.25) == Approx(wall));  // 0.125 em
    CHECK(m.upright(a, b, 0.0) == cap);
    CHECK(m.rim(a, b) == cap);
    m.margin = 8.0;
    CHECK(m.rim(a, b) == 8.0 * cap);
    CHECK(m.edge(a, b) == (std::max)(wall, 8.0 * cap));
    CHECK(detail::boundary_measure{m}.edge(a, b) == m.edge(a, b));
    CHECK(detail::boundary_measure{m}.triangle(a, b, a) == 0.0);
    m.margin = 1.0;
    m.riser = 0.2;  // higher than a wall's segment
    CHECK(m.edge(a, b) == Approx(m.upright(a, b, 0.4)));
    m.riser = 0.0;
    m.apart = true;
    CHECK(m.edge(a, b) == cap);
    // A slope is as large as its longest side, if that lies along its box.
    const detail::raised_point p{a, 0.1}, q{b, 0.3}, r{{51'200, 0}, 0.3};
    CHECK(m.slope(p, q, r) == Approx(m.span(p, q)));
    CHECK(m.span(p, q) == Approx(m.upright(a, b, 0.2)));
}

TEST_CASE("a slope turns if its image faces away, unless it is so thin that it has no side", "[extrude][bent_measure]")
{
    const on_cylinder cup{.radius = 0.3};
    auto m = measure_of(cup);
    m.origin = {0.0, 0.0};
    m.low = -0.2;
    m.high = 0.0;
    const auto cells = [](double em) { return std::int32_t(std::lround(cells_per_em * em)); };
    // A long side across the bend, and a corner near it: the arc's height turns the triangle, unless it is high enough.
    const auto turned = [&](std::int32_t height) {
        const detail::raised_point a{{0, 0}, 0.0}, b{{cells(0.4), cells(0.4)}, 0.0},
            c{{cells(0.2) - height, cells(0.2) + height}, 0.0};
        return m.turns(a, b, c);
    };
    CHECK_FALSE(turned(cells(0.2)));
    CHECK(turned(cells(0.001)));
    CHECK(turned(10));
    CHECK_FALSE(turned(2));
    CHECK_FALSE(turned(0));
    // Not by a map that does not bend so much.
    const on_cylinder wide{.radius = 1e6};
    auto still = measure_of(wide);
    CHECK_FALSE(
        still.turns({{0, 0}, 0.0}, {{cells(0.4), cells(0.4)}, 0.0}, {{cells(0.2) - 500, cells(0.2) + 500}, 0.0}));
}
