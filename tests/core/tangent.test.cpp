// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/tangent.hpp>

#include <random>

using namespace typemesh;

namespace {

point unit(point p) { return 1.0 / length(p) * p; }

/// The direction of a short chord on one side of t.
point chord(const curve& c, double t, side_of side, double h)
{
    return side == side_of::after ? c.at(t + h) - c.at(t) : c.at(t) - c.at(t - h);
}

}  // namespace

TEST_CASE("a tangent has the direction of shorter and shorter chords", "[core][tangent]")
{
    std::mt19937 random{11};
    std::uniform_real_distribution<double> place{-1000.0, 1000.0}, inside{0.01, 0.99};
    const auto any = [&] { return point{place(random), place(random)}; };
    for (int i = 0; i < 2000; ++i) {
        const curve c = i % 3 == 0   ? curve::from(any(), any())
                        : i % 3 == 1 ? curve::from(quadratic{any(), any(), any()})
                                     : curve::from(cubic{any(), any(), any(), any()});
        const double t = inside(random);
        for (const side_of side : {side_of::before, side_of::after}) {
            const point exact = unit(tangent(c, t, side)), near_by = unit(chord(c, t, side, 1e-6));
            // Where the curve nearly stands still a chord of fixed length in t says little.
            if (length(chord(c, t, side, 1e-6)) > 1e-4) REQUIRE(length(exact - near_by) < 1e-2);
        }
    }
}

TEST_CASE("a handle of length zero leaves the tangent to the next point", "[core][tangent]")
{
    const point a{0, 0}, b{100, 50}, d{300, 0};
    CHECK(cross(tangent(curve::from(quadratic{a, a, d}), 0.0, side_of::after), d - a) == 0.0);
    CHECK(dot(tangent(curve::from(quadratic{a, a, d}), 0.0, side_of::after), d - a) > 0.0);
    CHECK(dot(tangent(curve::from(quadratic{a, d, d}), 1.0, side_of::before), d - a) > 0.0);

    const curve start = curve::from(cubic{a, a, b, d}), twice = curve::from(cubic{a, a, a, d});
    CHECK(unit(tangent(start, 0.0, side_of::after)) == unit(b - a));
    CHECK(unit(tangent(twice, 0.0, side_of::after)) == unit(d - a));
    const curve end = curve::from(cubic{a, b, d, d}), both = curve::from(cubic{a, a, d, d});
    CHECK(length(unit(tangent(end, 1.0, side_of::before)) - unit(d - b)) < 1e-12);
    CHECK(length(unit(tangent(both, 0.0, side_of::after)) - unit(d - a)) < 1e-12);
    CHECK(length(unit(tangent(both, 1.0, side_of::before)) - unit(d - a)) < 1e-12);
}

TEST_CASE("a cusp and a reversal have two opposite tangents, and every other point has one", "[core][tangent]")
{
    const curve cusp = curve::from(cubic{{0, 0}, {100, 100}, {0, 100}, {100, 0}});  // B'(1/2) = 0
    CHECK(length(unit(tangent(cusp, 0.5, side_of::before)) + unit(tangent(cusp, 0.5, side_of::after))) < 1e-12);
    CHECK(unit(tangent(cusp, 0.5, side_of::before)).y > 0.0);

    const curve reversal = curve::from(quadratic{{0, 0}, {100, 0}, {0, 0}});
    CHECK(unit(tangent(reversal, 0.5, side_of::before)) == point{1, 0});
    CHECK(unit(tangent(reversal, 0.5, side_of::after)) == point{-1, 0});

    for (const double t : {0.1, 0.4, 0.6, 1.0})
        CHECK(tangent(cusp, t, side_of::before) == tangent(cusp, t, side_of::after));
}

TEST_CASE("only a curve that is a single point has no tangent", "[core][tangent]")
{
    const point p{3, 4};
    CHECK(tangent(curve::from(quadratic{p, p, p}), 0.5, side_of::after) == point{});
    CHECK(tangent(curve::from(cubic{p, p, p, p}), 0.0, side_of::before) == point{});
    CHECK(!(tangent(curve::from(cubic{p, p, p, {3, 5}}), 0.0, side_of::after) == point{}));
}
