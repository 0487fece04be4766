// SPDX-License-Identifier: MIT

#include <typemesh/vertex/half.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "support/catch.hpp"

using namespace typemesh;

static_assert(std::is_trivially_copyable_v<half> && std::is_standard_layout_v<half>);

namespace {

/// What the bits mean, by the definition.
double meaning(std::uint32_t bits)
{
    const int exponent = static_cast<int>(bits >> 10 & 0x1F);
    const double fraction = bits & 0x3FF;
    const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024.0 + fraction, exponent - 25);
    return (bits & 0x8000) != 0 ? -size : size;
}

std::uint32_t bits_of(float f) { return half{f}.bits; }

}  // namespace

TEST_CASE("all 65,536 halves have the values of their bits, and are unchanged after a float", "[vertex]")
{
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
        const float f = static_cast<float>(half::from_bits(static_cast<std::uint16_t>(bits)));
        std::uint32_t pattern = 0;  // -ffast-math knows neither infinity nor NaN
        std::memcpy(&pattern, &f, sizeof f);
        const std::uint32_t size = bits & 0x7FFF;
        if (size > 0x7C00) {
            if ((pattern & 0x7FFF'FFFF) <= 0x7F80'0000) FAIL("0x" << std::hex << bits << " is not a number");
            if ((bits_of(f) & 0x7FFF) <= 0x7C00) FAIL("0x" << std::hex << bits << " stays no number");
            continue;
        }
        if (size == 0x7C00 ? (pattern & 0x7FFF'FFFF) != 0x7F80'0000 : static_cast<double>(f) != meaning(bits))
            FAIL("0x" << std::hex << bits << " becomes " << f);
        if (bits_of(f) != bits) FAIL("0x" << std::hex << bits << " comes back as 0x" << bits_of(f));
        if ((pattern >> 31 != 0) != ((bits & 0x8000) != 0)) FAIL("0x" << std::hex << bits << " loses its sign");
    }
    SUCCEED();
}

TEST_CASE("every float becomes the nearest half, or the even one half-way between two", "[vertex]")
{
    // Rounding is monotone, so it is right everywhere when it is right on both sides of every middle, and in it.
    for (std::uint32_t low = 0; low < 0x7C00; ++low) {
        const double above = low + 1 == 0x7C00 ? 65536.0 : meaning(low + 1);
        const auto middle = static_cast<float>((meaning(low) + above) / 2);  // 12 bits: exact
        const std::uint32_t even = (low & 1) == 0 ? low : low + 1;
        for (const std::uint32_t sign : {0u, 0x8000u}) {
            const float s = sign != 0 ? -1.0f : 1.0f;
            const bool right = bits_of(s * middle) == (sign | even) &&
                               bits_of(s * std::nextafter(middle, 0.0f)) == (sign | low) &&
                               bits_of(s * std::nextafter(middle, 1e9f)) == (sign | (low + 1));
            if (!right) FAIL("between 0x" << std::hex << low << " and its neighbour");
        }
    }
    SUCCEED();
}

TEST_CASE("halves are right at the ends of their range", "[vertex]")
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    CHECK(bits_of(65504.0f) == 0x7BFF);
    CHECK(bits_of(65519.996f) == 0x7BFF);
    CHECK(bits_of(65520.0f) == 0x7C00);
    CHECK(bits_of(1e30f) == 0x7C00);
    CHECK(bits_of(infinity) == 0x7C00);
    CHECK(bits_of(-infinity) == 0xFC00);
    CHECK(bits_of(-0.0f) == 0x8000);
    CHECK(bits_of(0x1p-24f) == 1);
    CHECK(bits_of(0x1p-25f) == 0);
    CHECK(bits_of(0x1.000002p-25f) == 1);
    CHECK(bits_of(std::numeric_limits<float>::denorm_min()) == 0);
    CHECK((bits_of(std::numeric_limits<float>::quiet_NaN()) & 0x7FFF) > 0x7C00);
}
