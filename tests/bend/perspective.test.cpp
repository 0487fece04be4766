// SPDX-License-Identifier: MIT
#include <typemesh/bend/perspective.hpp>

#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("the right end of a text in perspective has its scale", "[bend][warp]")
{
    const box text{{1.0, 0.0}, {5.0, 0.0}};
    const perspective wall = perspective{.scale = 0.5, .horizon = 0.3}.fitted(text);
    CHECK(length(wall({1.0, 0.9}).at - point{1.0, 0.9}) < 1e-12);
    CHECK(length(wall({5.0, 0.9}).at - point{3.0, 0.6}) < 1e-12);
    CHECK(wall({2.0, 0.3}).at.y == Catch::Approx(0.3));
}

TEST_CASE("perspective refuses options that are no numbers or out of range", "[bend][warp]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(perspective{.scale = 0.0}.refused_options() == error::bad_option);
    CHECK(perspective{.scale = -1.0}.refused_options() == error::bad_option);
    CHECK(perspective{.horizon = nan}.refused_options() == error::bad_option);
}
