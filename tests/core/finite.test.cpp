// SPDX-License-Identifier: MIT

#include <typemesh/core/finite.hpp>

#include "support/catch.hpp"

#include <bit>
#include <cstdint>
#include <limits>

using namespace typemesh;

TEST_CASE("all numbers are finite except NaN and the infinities, even under -ffast-math", "[core]")
{
    using limits = std::numeric_limits<double>;
    for (const double v :
         {0.0, -0.0, 1.0, -1.5, limits::denorm_min(), (limits::min)(), (limits::max)(), limits::lowest()})
        CHECK(is_finite(v));
    // Only the exponent decides: the values are made from bits, so that -ffast-math cannot fold the question away.
    for (const std::uint64_t sign : {std::uint64_t{0}, std::uint64_t{1} << 63}) {
        for (const std::uint64_t mantissa : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 51}) {
            CHECK_FALSE(is_finite(std::bit_cast<double>(sign | 0x7FF0'0000'0000'0000u | mantissa)));
            CHECK(is_finite(std::bit_cast<double>(sign | 0x7FE0'0000'0000'0000u | mantissa)));
        }
    }
    volatile double zero = 0.0;
    for (const double v : {limits::infinity(), -limits::infinity(), limits::quiet_NaN(), -limits::quiet_NaN(),
                           limits::signaling_NaN(), 1.0 / zero, zero / zero})
        CHECK(!is_finite(v));
}
