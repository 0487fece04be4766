// SPDX-License-Identifier: MIT

// The ready warps: their derivatives and their bounds.

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/plane_warp.hpp>

#include <algorithm>
#include <cmath>

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

constexpr double difference_step = 1e-4;

}  // namespace

TEST_CASE("the derivatives of every warp are those of its images", "[bend][warp]")
{
    each_warp([](const auto& w) {
        REQUIRE_FALSE(w.refused_options());
        for (double x = -1.0; x < 2.2; x += 0.31)
            for (double y = -0.3; y < 1.0; y += 0.17) {
                const warped_point at = w({x, y});
                const point by_x = (w({x + difference_step, y}).at - w({x - difference_step, y}).at) *
                                   (0.5 / difference_step),
                            by_y = (w({x, y + difference_step}).at - w({x, y - difference_step}).at) *
                                   (0.5 / difference_step);
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
                const warped_point right = w({p.x + difference_step, p.y}), left = w({p.x - difference_step, p.y}),
                                   above = w({p.x, p.y + difference_step}), below = w({p.x, p.y - difference_step});
                xx = (std::max)(xx, length(right.x - left.x) * 0.5 / difference_step);
                xy = (std::max)(xy, length(right.y - left.y) * 0.5 / difference_step);
                yy = (std::max)(yy, length(above.y - below.y) * 0.5 / difference_step);
                CHECK(length(above.x - below.x) * 0.5 / difference_step <= by.xy + 1e-3 * by.xy + 1e-6);
            }
        CHECK(xx <= by.xx * 1.001 + 1e-6);
        CHECK(xy <= by.xy * 1.001 + 1e-6);
        CHECK(yy <= by.yy * 1.001 + 1e-6);
        CHECK(by.xx <= 4.0 * xx + 1e-6);
        CHECK(by.xy <= 2.0 * xy + 1e-6);
    });
}

TEST_CASE("the span of columns, of single pens and of no pens at all is one em", "[bend][warp]")
{
    CHECK(text_span::of({{2.0, -5.0}, {2.0, 0.0}}).width == 1.0);
    CHECK(text_span::of({}).middle() == 0.5);
}
