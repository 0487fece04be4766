// SPDX-License-Identifier: MIT

#include <typemesh/vertex/ten_bit.hpp>

#include <cmath>

#include "support/catch.hpp"

using namespace typemesh;

static_assert(sizeof(snorm10) == 4 && sizeof(unorm10) == 4);
static_assert(snorm10{1.0f, -1.0f, 0.0f, -1.0f}.bits == (0x1FFu | 0x201u << 10 | 3u << 30));
static_assert(unorm10{1.0f, 0.0f, 0.0f, 1.0f}.bits == (0x3FFu | 3u << 30));

TEST_CASE("each of 1023 signed and 1024 unsigned steps is unchanged after decoding, in each position", "[vertex]")
{
    for (int i = -511; i <= 511; ++i) {
        const float f = static_cast<float>(i) / 511.0f;
        const vec4 x = snorm10{f, 0.0f, 1.0f, -1.0f}.decoded(), y = snorm10{-1.0f, f, 0.0f, 1.0f}.decoded(),
                   z = snorm10{1.0f, -1.0f, f, 0.0f}.decoded();
        CHECK(x == vec4{f, 0.0f, 1.0f, -1.0f});
        CHECK(y == vec4{-1.0f, f, 0.0f, 1.0f});
        CHECK(z == vec4{1.0f, -1.0f, f, 0.0f});
    }
    for (int i = 0; i <= 1023; ++i) {
        const float f = static_cast<float>(i) / 1023.0f;
        CHECK(unorm10{f, 1.0f, 0.0f, 1.0f}.decoded() == vec4{f, 1.0f, 0.0f, 1.0f});
        CHECK(unorm10{1.0f, f, 0.0f, 0.0f}.decoded() == vec4{1.0f, f, 0.0f, 0.0f});
        CHECK(unorm10{0.0f, 1.0f, f, 1.0f / 3.0f}.decoded() == vec4{0.0f, 1.0f, f, 1.0f / 3.0f});
    }
}

TEST_CASE("every float becomes the nearest 10-bit step", "[vertex]")
{
    for (int i = 0; i < 511; ++i) {
        const double middle = (i + 0.5) / 511.0;
        const auto low = static_cast<float>(middle - 1e-7), high = static_cast<float>(middle + 1e-7);
        for (const float s : {1.0f, -1.0f}) {
            CHECK(snorm10{s * low, 0, 0}.decoded().x == s * (static_cast<float>(i) / 511.0f));
            CHECK(snorm10{s * high, 0, 0}.decoded().x == s * (static_cast<float>(i + 1) / 511.0f));
        }
    }
    for (int i = 0; i < 1023; ++i) {
        const double middle = (i + 0.5) / 1023.0;
        CHECK(unorm10{static_cast<float>(middle - 1e-7), 0, 0}.decoded().x == static_cast<float>(i) / 1023.0f);
        CHECK(unorm10{static_cast<float>(middle + 1e-7), 0, 0}.decoded().x == static_cast<float>(i + 1) / 1023.0f);
    }
}

TEST_CASE("10-bit numbers out of range become the end of the range, and the lowest pattern means -1", "[vertex]")
{
    CHECK(snorm10{7.0f, -7.0f, 1.5f, -9.0f}.decoded() == vec4{1.0f, -1.0f, 1.0f, -1.0f});
    CHECK(unorm10{7.0f, -7.0f, 1.5f, 9.0f}.decoded() == vec4{1.0f, 0.0f, 1.0f, 1.0f});
    snorm10 lowest;
    lowest.bits = 0x200u | 2u << 30;
    CHECK(lowest.decoded() == vec4{-1.0f, 0.0f, 0.0f, -1.0f});
}
