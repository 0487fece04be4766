// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/impl/bezier_section.hpp>

#include <cmath>
#include <cstdint>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

profile_points bezier_points(const bezier_section& curve, std::uint32_t steps = 0,
                             const profile_scale& scale = {1000.0, 1000.0, 0.0})
{
    return bezier_profile(curve, steps).at(scale);
}

}  // namespace

TEST_CASE("a Bézier profile has its points on the curve and the right ends", "[bezier_section]")
{
    const auto made = bezier_points({{0.1f, 0.9f}, {0.6f, 0.2f}, 0.7f}, 10);
    REQUIRE(made.view().size() == 11);
    CHECK(made.is_valid());
    CHECK(same(made.view().back().h, 0.7f));
    for (int i = 0; i <= 10; ++i) {
        const double u = i / 10.0, v = 1 - u;
        CHECK(made.view()[std::size_t(i)].t == Catch::Approx(3 * v * v * u * 0.1 + 3 * v * u * u * 0.6 + u * u * u));
        CHECK(made.view()[std::size_t(i)].h ==
              Catch::Approx(3 * v * v * u * 0.9 + 3 * v * u * u * 0.2 + u * u * u * 0.7));
    }
}

TEST_CASE("a Bézier profile by tolerance keeps it", "[bezier_section]")
{
    for (const double tolerance : {1.0, 5.0, 50.0}) {
        const profile_scale scale{1000.0, 2000.0, tolerance};
        const auto made = bezier_points({{0.0f, 1.0f}, {1.0f, 0.0f}, 1.0f}, 0, scale);
        const auto n = made.view().size() - 1;
        REQUIRE(made.is_valid());
        REQUIRE(n < 63);
        for (std::size_t i = 0; i < n; ++i) {
            const profile_point a = made.view()[i], b = made.view()[i + 1];
            for (int k = 1; k < 32; ++k) {  // points of the curve against the chord's line
                const double u = (double(i) + k / 32.0) / double(n), v = 1 - u;
                const double t = 3 * v * u * u + u * u * u, h = 3 * v * v * u + u * u * u;
                const double x = (b.t - double(a.t)) * scale.width, y = (b.h - double(a.h)) * scale.depth;
                const double off = ((t - a.t) * scale.width * y - (h - a.h) * scale.depth * x) / std::hypot(x, y);
                CHECK(std::abs(off) <= tolerance);
            }
        }
    }
    CHECK(bezier_points({}, 0, {1e9, 1e9, 1e-3}).view().size() == 64);
    CHECK(bezier_points({}).view().size() == 9);
}

TEST_CASE("a Bézier profile is not valid if it runs back or has too many steps", "[bezier_section]")
{
    CHECK_FALSE(bezier_points({{1.0f, 0.0f}, {-1.0f, 1.0f}, 1.0f}, 8).is_valid());
    CHECK_FALSE(bezier_points({{0.0f, 3.0f}, {1.0f, 1.0f}, 1.0f}, 8).is_valid());
    CHECK_FALSE(bezier_points({{0.0f, 0.0f}, {1.0f, 1.0f}, 1.0f}, 64).is_valid());
    CHECK(bezier_points({{0.0f, 0.0f}, {1.0f, 1.0f}, 1.0f}, 63).is_valid());
}
