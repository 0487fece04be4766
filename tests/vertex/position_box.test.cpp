// SPDX-License-Identifier: MIT

#include <typemesh/vertex/position_box.hpp>

#include <cmath>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("every step of a box is unchanged after decoding, and the corners are exact", "[vertex]")
{
    const vec3 low{-3.25f, 0.1f, -0.2f}, high{17.5f, 0.9f, 0.0f};
    const auto box = position_box::around(low, high);
    CHECK(box(low) == box_position{0.0f, 0.0f, 0.0f});
    CHECK(box(high) == box_position{1.0f, 1.0f, 1.0f});
    CHECK(box.decoded(box(low)) == low);
    CHECK(box.decoded(box(high)).x == high.x);
    for (int i = 0; i <= 65535; ++i) {
        const auto step = unorm16::from_bits(static_cast<std::uint16_t>(i));
        const box_position p{step, step, step};
        if (!(box(box.decoded(p)) == p)) FAIL(i << " does not come back");
    }
    SUCCEED();
}

TEST_CASE("a position in the box is decoded within half a step", "[vertex]")
{
    const auto box = position_box::around({-3.25f, 0.1f, -0.2f}, {17.5f, 0.9f, 0.0f});
    std::uint32_t random = 1;
    for (int i = 0; i < 100'000; ++i) {
        float f[3];
        for (float& v : f) v = static_cast<float>((random = random * 1664525u + 1013904223u) >> 8) * 0x1p-24f;
        const vec3 p{box.offset.x + f[0] * box.scale.x, box.offset.y + f[1] * box.scale.y,
                     box.offset.z + f[2] * box.scale.z};
        const vec3 q = box.decoded(box(p));
        const double half = 0.5000001 / 65535.0, rounding = 0x1p-24 * 20.0;
        if (std::abs(double(q.x) - p.x) > half * box.scale.x + rounding ||
            std::abs(double(q.y) - p.y) > half * box.scale.y + rounding ||
            std::abs(double(q.z) - p.z) > half * box.scale.z + rounding)
            FAIL(p.x << ' ' << p.y << ' ' << p.z);
    }
    SUCCEED();
}

TEST_CASE("positions outside are moved to the box, and an axis without extent is exact", "[vertex]")
{
    const auto box = position_box::around({0.0f, 0.0f, 0.125f}, {2.0f, 1.0f, 0.125f});
    CHECK(box({-5.0f, 9.0f, 0.125f}) == box_position{0.0f, 1.0f, 0.0f});
    CHECK(box.decoded(box({1.0f, 0.5f, 0.125f})).z == 0.125f);
    const auto nothing = position_box::around({}, {});
    CHECK(nothing.decoded(nothing({})) == vec3{});
}

TEST_CASE("a cube has one scale, its longest side", "[vertex]")
{
    CHECK(position_box::cube_around({1, 2, 3}, {2, 7, 4}).scale == vec3{5, 5, 5});
    CHECK(position_box::cube_around({1, 2, 3}, {9, 7, 4}).scale == vec3{8, 8, 8});
    CHECK(position_box::cube_around({1, 2, 3}, {2, 7, 40}).scale == vec3{37, 37, 37});
    CHECK(position_box::cube_around({1, 2, 3}, {2, 7, 40}).offset == vec3{1, 2, 3});
}
