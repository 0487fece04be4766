// SPDX-License-Identifier: MIT
#include <typemesh/bend/arc.hpp>

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("an arc turns by its degrees over the whole text, about its middle", "[bend][warp]")
{
    const box text{{1.0, 0.0}, {5.0, 0.0}};
    const arc round = arc{.degrees = 90}.fitted(text);
    CHECK(length(round({3.0, 0.0}).at - point{3.0, 0.0}) < 1e-12);
    const point left = round({1.0, 0.0}).x, right = round({5.0, 0.0}).x;
    CHECK(std::atan2(cross(right, left), dot(right, left)) == Catch::Approx(1.5707963267948966));
    CHECK(length(left) == Catch::Approx(1.0));
    CHECK(round({1.0, 0.0}).at.y < -0.5);  // arched upwards
    CHECK(arc{.degrees = -90}.fitted(text)({1.0, 0.0}).at.y > 0.5);
}

TEST_CASE("arc refuses options that are no numbers or out of range", "[bend][warp]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(arc{.degrees = nan}.refused_options() == error::bad_option);
    CHECK(arc{.width = -1.0}.refused_options() == error::bad_option);
    CHECK(arc{.middle = nan}.refused_options() == error::bad_option);
}

TEST_CASE("an arc of almost no degrees leaves the text where it is", "[bend][warp]")
{
    for (const double degrees : {1e-9, 1e-70, 1e-160, 1e-290, 1e-310, 1e-315, 5e-324, 0.0})
        for (const double sign : {1.0, -1.0}) {
            const arc flat = arc{.degrees = sign * degrees}.fitted({{-2.0, 0.0}, {3.0, 1.0}});
            for (const point p : {point{-2.0, 0.0}, point{1.75, 0.75}, point{3.0, -1.0}}) {
                INFO(degrees);
                const warped_point w = flat(p);
                CHECK(length(w.at - p) < 1e-8);
                CHECK(length(w.x - point{1.0, 0.0}) < 1e-8);
                CHECK(length(w.y - point{0.0, 1.0}) < 1e-8);
            }
        }
}
