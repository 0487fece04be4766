// SPDX-License-Identifier: MIT

#include <typemesh/core/point.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <limits>

using namespace typemesh;

TEST_CASE("lerp keeps its ends exactly, and cross and dot turn with the plane", "[core]")
{
    test::dice d{5};
    const auto any = [&] { return point{1e3 * d.fraction() - 500.0, 1e-3 * d.fraction()}; };
    for (int round = 0; round < 1000; ++round) {
        const point a = any(), b = any();
        CHECK(lerp(a, b, 0.0) == a);
        CHECK(lerp(a, b, 1.0) == b);
        CHECK(cross(a, b) == Catch::Approx(-cross(b, a)).margin(1e-12));
        CHECK(dot(a, b) == dot(b, a));
        const point turned{-a.y, a.x};  // by a quarter, to the left
        CHECK(cross(a, turned) == Catch::Approx(dot(a, a)));
        CHECK(std::abs(dot(a, turned)) <= 1e-15 * dot(a, a));
        CHECK(length(3.0 * a) == Catch::Approx(3.0 * length(a)));
    }
}

TEST_CASE("grid points are equal if both coordinates are, up to the ends of their range", "[core]")
{
    const std::int32_t values[] = {(std::numeric_limits<std::int32_t>::min)(), -1, 0, 1,
                                   (std::numeric_limits<std::int32_t>::max)()};
    for (const std::int32_t x : values)
        for (const std::int32_t y : values)
            for (const std::int32_t u : values)
                for (const std::int32_t v : values) CHECK((grid_point{x, y} == grid_point{u, v}) == (x == u && y == v));
}

TEST_CASE("vectors are equal if all their components are, and NaN equals nothing", "[core]")
{
    CHECK(vec3{1, 2, 3} == vec3{1, 2, 3});
    CHECK_FALSE(vec3{1, 2, 3} == vec3{1, 2, 4});
    CHECK_FALSE(vec2{1, 2} == vec2{2, 2});
    CHECK_FALSE(vec4{1, 2, 3, 4} == vec4{1, 2, 3, -4});
    CHECK(vec2{0.0f, -0.0f} == vec2{-0.0f, 0.0f});
#if !defined(__FAST_MATH__)
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(vec2{nan, 0} == vec2{nan, 0});
#endif
}
