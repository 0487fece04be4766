// SPDX-License-Identifier: MIT
#include <typemesh/bend/flag.hpp>

#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("one wave of a flag fits the text", "[bend][warp]")
{
    const box text{{1.0, 0.0}, {5.0, 0.0}};
    const flag waving = flag{.height = 0.4}.fitted(text);
    CHECK(length(waving({2.0, 0.3}).at - point{2.0, 0.7}) < 1e-12);
    CHECK(length(waving({5.0, 0.3}).at - point{5.0, 0.3}) < 1e-10);
}

TEST_CASE("flag refuses options that are no numbers or out of range", "[bend][warp]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(flag{.height = nan}.refused_options() == error::bad_option);
    CHECK(flag{.length = -1.0}.refused_options() == error::bad_option);
    CHECK(flag{.phase = nan}.refused_options() == error::bad_option);
}
