// SPDX-License-Identifier: MIT

// The ready warps: their derivatives, their bounds, where they leave the text, and their options.

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/plane_warp.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

template <class Check>
void each_warp(const Check& check)
{
    const box text{{-1.0, 0.0}, {2.0, 0.0}};
    for (const double degrees : {90.0, -60.0, 1e-7, 0.0, 350.0}) check(fitted_to(arc{.degrees = degrees}, text));
    check(arc{.degrees = 30, .width = 0.7, .middle = -0.4});
    for (const double baseline : {0.0, 0.3, -0.3}) check(fitted_to(arch{.rise = 0.3, .baseline = baseline}, text));
    check(fitted_to(flag{.height = -0.2, .phase = 70}, text));
    check(flag{.height = 0.1, .length = 0.9, .left = 0.3});
    for (const double scale : {0.5, 1.0, 1.5}) check(fitted_to(perspective{.scale = scale}, text));
}

constexpr double step = 1e-4;

}  // namespace

TEST_CASE("the derivatives of every warp are those of its images", "[bend][warp]")
{
    each_warp([](const auto& w) {
        REQUIRE_FALSE(w.refused_options());
        for (double x = -1.0; x < 2.2; x += 0.31)
            for (double y = -0.3; y < 1.0; y += 0.17) {
                const warped_point at = w({x, y});
                const point by_x = (w({x + step, y}).at - w({x - step, y}).at) * (0.5 / step),
                            by_y = (w({x, y + step}).at - w({x, y - step}).at) * (0.5 / step);
                CHECK(length(by_x - at.x) < 1e-6);
                CHECK(length(by_y - at.y) < 1e-6);
            }
    });
}

TEST_CASE("second derivatives never exceed a warp's bounds, which are not far too large", "[bend][warp]")
{
    each_warp([](const auto& w) {
        const box b{{0.4, -0.2}, {0.9, 0.6}};
        const bend_bounds by = w.bend(b);
        double xx = 0.0, xy = 0.0, yy = 0.0;
        for (int i = 0; i <= 40; ++i)
            for (int k = 0; k <= 40; ++k) {
                const point p{b.low.x + b.width() * i / 40, b.low.y + b.height() * k / 40};
                const warped_point right = w({p.x + step, p.y}), left = w({p.x - step, p.y}),
                                   above = w({p.x, p.y + step}), below = w({p.x, p.y - step});
                xx = (std::max)(xx, length(right.x - left.x) * 0.5 / step);
                xy = (std::max)(xy, length(right.y - left.y) * 0.5 / step);
                yy = (std::max)(yy, length(above.y - below.y) * 0.5 / step);
                CHECK(length(above.x - below.x) * 0.5 / step <= by.xy + 1e-3 * by.xy + 1e-6);
            }
        CHECK(xx <= by.xx * 1.001 + 1e-6);
        CHECK(xy <= by.xy * 1.001 + 1e-6);
        CHECK(yy <= by.yy * 1.001 + 1e-6);
        CHECK(by.xx <= 4.0 * xx + 1e-6);
        CHECK(by.xy <= 2.0 * xy + 1e-6);
    });
}

TEST_CASE("fitted warps end where the text ends", "[bend][warp]")
{
    const box text{{1.0, 0.0}, {5.0, 0.0}};
    const arc round = arc{.degrees = 90}.fitted(text);
    CHECK(length(round({3.0, 0.0}).at - point{3.0, 0.0}) < 1e-12);
    const point left = round({1.0, 0.0}).x, right = round({5.0, 0.0}).x;
    CHECK(std::atan2(cross(right, left), dot(right, left)) == Catch::Approx(1.5707963267948966));
    CHECK(length(left) == Catch::Approx(1.0));
    CHECK(round({1.0, 0.0}).at.y < -0.5);  // arched upwards
    CHECK(arc{.degrees = -90}.fitted(text)({1.0, 0.0}).at.y > 0.5);

    const arch upper = arch{.rise = 0.4}.fitted(text);
    CHECK(length(upper({3.0, 0.7}).at - point{3.0, 1.1}) < 1e-12);
    CHECK(length(upper({3.0, 0.0}).at - point{3.0, 0.0}) < 1e-12);
    CHECK(length(upper({5.0, 0.7}).at - point{5.0, 0.7}) < 1e-12);

    const flag waving = flag{.height = 0.4}.fitted(text);
    CHECK(length(waving({2.0, 0.3}).at - point{2.0, 0.7}) < 1e-12);
    CHECK(length(waving({5.0, 0.3}).at - point{5.0, 0.3}) < 1e-10);

    const perspective wall = perspective{.scale = 0.5, .horizon = 0.3}.fitted(text);
    CHECK(length(wall({1.0, 0.9}).at - point{1.0, 0.9}) < 1e-12);
    CHECK(length(wall({5.0, 0.9}).at - point{3.0, 0.6}) < 1e-12);
    CHECK(wall({2.0, 0.3}).at.y == Catch::Approx(0.3));

    // Columns, single pens and no pens at all.
    CHECK(text_span::of({{2.0, -5.0}, {2.0, 0.0}}).width == 1.0);
    CHECK(text_span::of({}).middle() == 0.5);
}

TEST_CASE("warps refuse options that are no numbers or out of range", "[bend][warp]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(arc{.degrees = nan}.refused_options().option == std::string{"degrees"});
    CHECK(arc{.width = -1.0}.refused_options().option == std::string{"width"});
    CHECK(arc{.middle = nan}.refused_options().option == std::string{"middle"});
    CHECK(arch{.top = 0.0}.refused_options() == error::bad_option);
    CHECK(arch{.rise = nan}.refused_options() == error::bad_option);
    CHECK(arch{.baseline = nan}.refused_options() == error::bad_option);
    CHECK(flag{.height = nan}.refused_options() == error::bad_option);
    CHECK(flag{.length = -1.0}.refused_options() == error::bad_option);
    CHECK(flag{.phase = nan}.refused_options() == error::bad_option);
    CHECK(perspective{.scale = 0.0}.refused_options() == error::bad_option);
    CHECK(perspective{.scale = -1.0}.refused_options() == error::bad_option);
    CHECK(perspective{.horizon = nan}.refused_options() == error::bad_option);
}
