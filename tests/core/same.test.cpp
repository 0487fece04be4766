// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/same.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <limits>

using namespace typemesh;

TEST_CASE("same() is ==: exact to the last bit, equal for both zeros, and never for NaN", "[core]")
{
    const double values[] = {0.0, 1.0, std::nextafter(1.0, 2.0), -1.0, 1e300, 1e-300};
    for (std::size_t i = 0; i < std::size(values); ++i)
        for (std::size_t k = 0; k < std::size(values); ++k) CHECK(same(values[i], values[k]) == (i == k));
    CHECK(same(0.0, -0.0));
    CHECK(is_zero(-0.0f));
#if !defined(__FAST_MATH__)
    CHECK_FALSE(is_zero(std::numeric_limits<float>::denorm_min()));
    CHECK_FALSE(same(std::numeric_limits<double>::infinity(), 1.0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(same(nan, nan));
    CHECK_FALSE(is_zero(nan));
#endif
}
