// SPDX-License-Identifier: MIT

#include <typemesh/vertex/normalised.hpp>

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

static_assert(snorm8{-1.0f}.bits == -127 && unorm8{1.0f}.bits == 255 && snorm16{0.0f}.bits == 0);
static_assert(std::is_trivially_copyable_v<snorm16> && std::is_standard_layout_v<snorm16>);

TEMPLATE_TEST_CASE("every step is unchanged after a float, and every float becomes the nearest step", "[vertex]",
                   snorm8, snorm16, unorm8, unorm16)
{
    using integer = decltype(TestType::bits);
    constexpr int most = TestType::most, least = std::is_signed_v<integer> ? -most : 0;
    for (int bits = least; bits <= most; ++bits) {
        const auto here = TestType::from_bits(static_cast<integer>(bits));
        const float f = static_cast<float>(here);
        if (f != static_cast<float>(bits) / static_cast<float>(most)) FAIL(bits << " means " << f);
        if (TestType{f}.bits != bits) FAIL(bits << " comes back as " << +TestType{f}.bits);
        if (bits == most) break;
        // Rounding is monotone: right everywhere when it is right on both sides of every middle between steps, which
        // lie at odd multiples of 1 / (2 most), never on a float but 0.5 / odd ones.
        const double middle = (bits + 0.5) / most;
        auto below = static_cast<float>(middle), above = below;
        while (static_cast<double>(below) * (2.0 * most) >= 2.0 * bits + 1.0) below = std::nextafter(below, -2.0f);
        while (static_cast<double>(above) * (2.0 * most) <= 2.0 * bits + 1.0) above = std::nextafter(above, 2.0f);
        if (TestType{below}.bits != bits || TestType{above}.bits != bits + 1)
            FAIL("around " << middle << ": " << +TestType{below}.bits << " and " << +TestType{above}.bits);
    }
    SUCCEED();
}

TEMPLATE_TEST_CASE("values out of range become the end of the range", "[vertex]", snorm8, snorm16, unorm8, unorm16)
{
    using integer = decltype(TestType::bits);
    constexpr int most = TestType::most, least = std::is_signed_v<integer> ? -most : 0;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float f : {1.0f, 1.0000001f, 7.0f, 1e30f, infinity}) {
        CHECK(TestType{f}.bits == most);
        CHECK(TestType{-f}.bits == least);
    }
    const int odd = TestType{std::numeric_limits<float>::quiet_NaN()}.bits;
    CHECK((odd == least || odd == most));
}

TEST_CASE("a signed number's lowest pattern means -1, as in graphics interfaces", "[vertex]")
{
    CHECK(static_cast<float>(snorm8::from_bits(-128)) == -1.0f);
    CHECK(static_cast<float>(snorm16::from_bits(-32768)) == -1.0f);
}
