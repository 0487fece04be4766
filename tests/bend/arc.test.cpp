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
