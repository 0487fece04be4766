// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/impl/quarter_ellipse.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

profile_points ready_points(const bevel_profile& p, const profile_scale& scale = {10000.0, 10000.0, 0.0})
{
    return p.at(scale);
}

bevel_profile ellipse(bool convex, std::uint32_t steps = 0)
{
    return convex ? round_profile(steps) : concave_profile(steps);
}

/// How far the chord between two points is from the ellipse at most, sampled; in cells.
double chord_error(profile_point a, profile_point b, bool convex, const profile_scale& scale)
{
    double worst = 0.0;
    for (int i = 1; i < 64; ++i) {
        const double s = i / 64.0;
        double x = (1 - s) * a.t + s * b.t, y = (1 - s) * a.h + s * b.h;
        x = convex ? 1 - x : x;  // on the unit circle about the origin
        y = convex ? y : 1 - y;
        const double r = std::hypot(x, y), on_x = x / r,
                     on_y = y / r;  // a point of the ellipse near it, not the nearest
        worst = std::max(worst, std::hypot((x - on_x) * scale.width, (y - on_y) * scale.depth));
    }
    return worst;
}

}  // namespace

TEST_CASE("quarter ellipses have their points on the ellipse, and the requested number of steps", "[quarter_ellipse]")
{
    const bool convex = GENERATE(true, false);
    for (std::uint32_t steps = 1; steps < profile_points::most; ++steps) {
        const auto made = ready_points(ellipse(convex, steps));
        const auto p = made.view();
        REQUIRE(p.size() == steps + 1);
        REQUIRE(made.is_valid());
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = convex ? 1.0 - double(p[i].t) : double(p[i].t);
            const double y = convex ? double(p[i].h) : 1.0 - double(p[i].h);
            CHECK(std::hypot(x, y) == Catch::Approx(1.0).epsilon(1e-6));
        }
        for (std::size_t i = 2; i < p.size(); ++i) {  // turns to one side only
            const double turn = (double(p[i - 1].t) - p[i - 2].t) * (double(p[i].h) - p[i - 1].h) -
                                (double(p[i - 1].h) - p[i - 2].h) * (double(p[i].t) - p[i - 1].t);
            CHECK((convex ? -turn : turn) > 0.0);
        }
    }
    CHECK_FALSE(ready_points(ellipse(convex, 64)).is_valid());
    CHECK_FALSE(ready_points(ellipse(convex, 0xFFFF'FFFFu)).is_valid());
}

TEST_CASE("quarter ellipses keep their tolerance, with few unnecessary steps", "[quarter_ellipse]")
{
    const bool convex = GENERATE(true, false);
    for (const double width : {500.0, 10000.0, 40000.0})
        for (const double depth : {300.0, 10000.0, 30000.0})
            for (const double tolerance : {30.0, 100.0, 640.0}) {
                const profile_scale scale{width, depth, tolerance};
                const auto made = ready_points(ellipse(convex), scale);
                const auto p = made.view();
                INFO(width << " x " << depth << " within " << tolerance << ": " << p.size() - 1 << " steps");
                double worst = 0.0;
                for (std::size_t i = 1; i < p.size(); ++i)
                    worst = std::max(worst, chord_error(p[i - 1], p[i], convex, scale));
                CHECK(worst <= tolerance);
                if (p.size() > 6 && width == depth) {  // NOLINT: both are one of few numbers
                    const auto fewer = ready_points(ellipse(convex, static_cast<std::uint32_t>(p.size() - 3)), scale);
                    CHECK(chord_error(fewer.view()[0], fewer.view()[1], convex, scale) > tolerance);
                }
            }
}

TEST_CASE("the sines of all quarter ellipses round to one float, even 1e-15 off", "[quarter_ellipse]")
{
    // So that every C library, off by an ulp or two, gives the same floats.
    for (int steps = 1; steps < 64; ++steps)
        for (int i = 1; i < steps; ++i) {
            const double angle = 1.57079632679489661923 * i / steps;
            for (const double v : {std::sin(angle), 1.0 - std::cos(angle)})
                for (const double off : {-1e-15, 1e-15})
                    CHECK(static_cast<float>(v + off) == static_cast<float>(v));  // NOLINT: equal bits are meant
        }
}
