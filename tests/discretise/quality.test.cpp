// SPDX-License-Identifier: MIT
#include <typemesh/discretise/quality.hpp>

#include "support/catch.hpp"

#include <limits>

using namespace typemesh;

TEST_CASE("a better quality is a smaller tolerance", "[quality]")
{
    CHECK(quality::low > quality::normal);
    CHECK(quality::normal > quality::high);
    CHECK(quality::high > quality::best);
    CHECK(quality::low * 2048.0 == Approx(20.48));
    CHECK(quality::best * 16000.0 == Approx(1.0));
}

TEST_CASE("tolerance_for_pixels is the error in em, by default of a quarter of a pixel", "[quality]")
{
    CHECK(tolerance_for_pixels(64.0) == 0.25 / 64.0);
    CHECK(tolerance_for_pixels(64.0, 1.0) == 1.0 / 64.0);
}

TEST_CASE("tolerance_for_pixels returns a bad tolerance for a number that is not positive and finite", "[quality]")
{
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
    CHECK(tolerance_for_pixels(bad) == 0.0);
    CHECK(tolerance_for_pixels(64.0, bad) == 0.0);
    CHECK(tolerance_for_pixels(1e-300, 1e300) == 0.0);  // overflows
}
