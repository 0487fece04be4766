// SPDX-License-Identifier: MIT
#include <typemesh/bend/arch.hpp>

#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("an arch lifts the middle of the text and keeps its ends", "[bend][warp]")
{
    const box text{{1.0, 0.0}, {5.0, 0.0}};
    const arch upper = arch{.rise = 0.4}.fitted(text);
    CHECK(length(upper({3.0, 0.7}).at - point{3.0, 1.1}) < 1e-12);
    CHECK(length(upper({3.0, 0.0}).at - point{3.0, 0.0}) < 1e-12);
    CHECK(length(upper({5.0, 0.7}).at - point{5.0, 0.7}) < 1e-12);
}

TEST_CASE("arch refuses options that are no numbers or out of range", "[bend][warp]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(arch{.top = 0.0}.refused_options() == error::bad_option);
    CHECK(arch{.rise = nan}.refused_options() == error::bad_option);
    CHECK(arch{.baseline = nan}.refused_options() == error::bad_option);
}
