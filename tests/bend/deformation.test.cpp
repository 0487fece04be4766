// SPDX-License-Identifier: MIT

#include <typemesh/bend/deformation.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// A deformation that changes nothing.
struct stillness {
    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        return {p, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept { return {}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};
struct picky_stillness : stillness {
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        return text.high.x > 3.0 ? error{error::goes_around} : error{};
    }
};
struct throwing_stillness : stillness {
    deformed_point operator()(const double3& p) const { return stillness::operator()(p); }
};
struct throwing_bounds : stillness {
    bend_bounds bend(const box3&) const { return {}; }
};
struct without_bounds {
    [[nodiscard]] deformed_point operator()(const double3&) const noexcept { return {}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

}  // namespace

static_assert(deformation<stillness> && deformation<picky_stillness>);
static_assert(!deformation<throwing_stillness> && !deformation<throwing_bounds> && !deformation<without_bounds>);
static_assert(!deformation<int> && !deformation<wave>);
static_assert(deformation<on_cylinder> && deformation<on_sphere> && deformation<twist> && deformation<taper>);

TEST_CASE("a deformation without a law for whole texts refuses none", "[bend]")
{
    const box3 short_text{{0.0, 0.0, 0.0}, {2.0, 1.0, 0.0}}, long_text{{0.0, 0.0, 0.0}, {4.0, 1.0, 0.0}};
    CHECK(refused_text(stillness{}, long_text) == error::none);
    CHECK(refused_text(picky_stillness{}, short_text) == error::none);
    CHECK(refused_text(picky_stillness{}, long_text) == error::goes_around);
}

TEST_CASE("every ready deformation agrees with its derivatives on a line through space", "[bend]")
{
    // The way along the image of a line is the integral of the derivative: Simpson's rule, exact to the fourth order.
    std::size_t kinds = 0;
    bending::each_ready([&](const auto& d, const box3& all) {
        ++kinds;
        test::dice dice{21};
        for (int round = 0; round < 5; ++round) {
            const double3 from = bending::within(dice, all), to = from + 0.002 * (bending::within(dice, all) - from);
            const double3 way = to - from;
            const auto slope = [&](double t) {
                const deformed_point at = d(from + t * way);
                return way.x * at.x + way.y * at.y + way.z * at.z;
            };
            double3 sum = slope(0.0) + slope(1.0);
            const int steps = 16;
            for (int i = 1; i < steps; ++i) sum = sum + (i % 2 == 1 ? 4.0 : 2.0) * slope(double(i) / steps);
            const double3 moved = (1.0 / (3.0 * steps)) * sum;
            CHECK_QUICKLY(length(moved - (d(to).at - d(from).at)) < 1e-7 * length(way) + 1e-14);
        }
    });
    CHECK(kinds > 60);
}
