// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/conic_fit.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace typemesh;
using namespace typemesh::detail;

namespace {

const curve bent = curve::from(cubic{{0, 0}, {100, 300}, {500, 400}, {700, 0}});
constexpr double fit_cells = 512.0;

grid_point on_grid(point p) { return grid{}.snap(p); }

curve_section section_of(const curve& c, double t0, double t1)
{
    return curve_section::of(c, t0, t1, fit_cells, on_grid(c.at(t0)), on_grid(c.at(t1)));
}

/// The greatest distance of a section from a fitted conic, at 100 places.
double greatest_error(const curve_section& s, grid_point start, const fitted_conic& conic)
{
    conic_arc arc{curve_section::exact(conic.control) - curve_section::exact(start), s.p[s.degree]};
    arc.square = double{conic.weight} * double{conic.weight};
    double worst = 0.0;
    for (int i = 0; i <= 100; ++i) worst = (std::max)(worst, std::abs(arc.at(s.at(0.01 * i)).distance));
    return worst;
}

}  // namespace

TEST_CASE("a section runs between its grid points, beside its curve", "[extrude][curved]")
{
    const auto quadratic_curve = curve::from(quadratic{{10, 20}, {300, 500}, {800, -100}});
    for (const curve& c : {bent, quadratic_curve, curve::from(point{1, 2}, point{30, 40})})
        for (const auto& [t0, t1] : {std::pair{0.0, 1.0}, {0.25, 0.75}, {0.9, 0.3}}) {
            const curve_section s = section_of(c, t0, t1);
            const point start = curve_section::exact(on_grid(c.at(t0))), end = curve_section::exact(on_grid(c.at(t1)));
            CHECK(s.p[0] == point{});
            CHECK(s.p[s.degree] == end - start);
            for (int i = 0; i <= 10; ++i) {
                const double share = 0.1 * i;
                const point off = s.at(share) + start - fit_cells * c.at(t0 + share * (t1 - t0));
                CHECK(length(off) < 0.75);
            }
        }
}

TEST_CASE("a section's height bounds its distance from the chord", "[extrude][curved]")
{
    const curve_section s = section_of(bent, 0.1, 0.5);
    double highest = 0.0;
    for (int i = 0; i <= 100; ++i)
        highest = (std::max)(highest, std::abs(cross(s.p[3], s.at(0.01 * i))) / length(s.p[3]));
    CHECK(s.height() >= highest);
    CHECK(s.height() < 2.0 * highest);
    CHECK(section_of(curve::from(quadratic{{0, 0}, {900, 1}, {500, 0}}), 0.0, 1.0).height() < 0.0);
}

TEST_CASE("a quadratic is its own conic", "[extrude][curved]")
{
    const auto c = curve::from(quadratic{{0, 0}, {300, 500}, {800, -100}});
    const auto fitted = fit_conic(section_of(c, 0.0, 1.0), {0, 0});
    CHECK(fitted.control == grid_point{300 * 512, 500 * 512});
    CHECK(fitted.weight == 1.0f);
    CHECK(greatest_error(section_of(c, 0.0, 1.0), {0, 0}, fitted) < 1e-3);
}

TEST_CASE("a conic that fits a cubic is within the error, and short sections are fitted", "[extrude][curved]")
{
    std::size_t fitted = 0, refused = 0;
    for (int pieces = 1; pieces <= 16; ++pieces)
        for (int i = 0; i < pieces; ++i) {
            const double t0 = double(i) / pieces, t1 = double(i + 1) / pieces;
            const auto s = section_of(bent, t0, t1);
            const grid_point start = on_grid(bent.at(t0));
            const auto conic = fit_conic(s, start);
            if (conic.weight > 0.0f) {
                CHECK(greatest_error(s, start, conic) < conic_error + 0.25);
                ++fitted;
            } else {
                ++refused;
            }
            if (pieces >= 8) CHECK(conic.weight > 0.0f);
        }
    CHECK(fitted > 100);
    CHECK(refused > 0);
}

TEST_CASE("balanced arcs are few: both halves of an uneven cubic are one arc each", "[extrude][curved]")
{
    const auto uneven = curve::from(cubic{{0, 0}, {0, 500}, {300, 700}, {900, 700}});
    for (const double t0 : {0.0, 0.5}) {
        const auto s = section_of(uneven, t0, t0 + 0.5);
        const auto conic = fit_conic(s, on_grid(uneven.at(t0)));
        REQUIRE(conic.weight > 0.0f);
        CHECK(greatest_error(s, on_grid(uneven.at(t0)), conic) < conic_error + 0.25);
    }
}

TEST_CASE("a balanced arc leaves in the direction of its section, and arrives in it", "[extrude][curved]")
{
    for (const double leg : {1.0, 4.0, 20.0, 60.0}) {
        const cubic there{{0, 0}, {leg, 0}, {796, 8}, {796, 8}};
        for (const curve& c : {curve::from(there), curve::from(cubic{there.p3, there.p2, there.p1, there.p0})}) {
            const curve_section s = section_of(c, 0.0, 1.0);
            const grid_point start = on_grid(c.at(0.0));
            const auto conic = fit_conic(s, start);
            if (!(conic.weight > 0.0f)) continue;
            const point control = curve_section::exact(conic.control) - curve_section::exact(start), end = s.p[3];
            CHECK(dot(control, s.at(1e-3)) > 0.0);
            CHECK(dot(end - control, end - s.at(0.999)) > 0.0);
        }
    }
    const auto found = curve::from(cubic{{0, 0}, {4, 0}, {796, 8}, {796, 8}});
    CHECK(fit_conic(section_of(found, 0.0, 1.0), {0, 0}).weight > 0.0f);
}

TEST_CASE("a cubic that is nearly a circle has a circle's weight", "[extrude][curved]")
{
    const double k = 0.5522847498307936 * 100.0;
    const auto c = curve::from(cubic{{100, 0}, {100, k}, {k, 100}, {0, 100}});
    for (const double part : {0.25, 0.5}) {
        const auto s = section_of(c, 0.0, part);
        const auto conic = fit_conic(s, on_grid(c.at(0.0)));
        REQUIRE(conic.weight > 0.0f);
        CHECK(double{conic.weight} == Catch::Approx(std::cos(part * 3.14159265 / 4)).epsilon(0.01));
    }
}

TEST_CASE("sections without a conic are refused: bends, cusps, points, lines", "[extrude][curved]")
{
    for (const auto& c : {cubic{{0, 0}, {100, 100}, {200, -100}, {300, 0}},
                          cubic{{0, 0}, {300, 300}, {0, 300}, {300, 0}}, cubic{{0, 0}, {0, 0}, {0, 0}, {0, 0}},
                          cubic{{0, 0}, {100, 0}, {200, 0}, {300, 0}}, cubic{{0, 0}, {600, 500}, {-600, 500}, {0, 0}}})
        CHECK_FALSE(fit_conic(section_of(curve::from(c), 0.0, 1.0), {0, 0}).weight > 0.0f);
}

TEST_CASE("cubics turn where their curvature changes its sign", "[extrude][curved]")
{
    CHECK(turning_points_of({{0, 0}, {100, 300}, {500, 400}, {700, 0}}).count == 0);
    const auto once = turning_points_of({{0, 0}, {100, 100}, {200, -100}, {300, 0}});
    REQUIRE(once.count == 1);
    CHECK(once.t[0] == Catch::Approx(0.5));
    const cubic twice{{0, 0}, {400, 300}, {-50, 300}, {300, 0}};
    const auto both = turning_points_of(twice);
    for (std::uint32_t i = 0; i < both.count; ++i) {
        const double t = both.t[i], h = 1e-4;
        const auto bend = [&](double u) { return cross(twice.at(u) - twice.at(u - h), twice.at(u + h) - twice.at(u)); };
        CHECK(bend(t - 0.02) * bend(t + 0.02) < 0.0);
    }
    CHECK(turning_points_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).count == 0);
}
