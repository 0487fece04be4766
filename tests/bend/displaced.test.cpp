// SPDX-License-Identifier: MIT

#include <typemesh/bend/displaced.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// A surface of one's own: z = a x^2 + b x y + c y^2.
struct saddle {
    double a = 0.3;
    double b = -0.7;
    double c = 0.1;
    const char* refuses = nullptr;

    [[nodiscard]] error refused_options() const noexcept { return refuses == nullptr ? error{} : error::bad(refuses); }
    [[nodiscard]] surface_height operator()(double x, double y) const noexcept
    {
        return {a * x * x + b * x * y + c * y * y, 2.0 * a * x + b * y, b * x + 2.0 * c * y};
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept
    {
        // The rest of a surface's bounds does not matter.
        return {
            .xx = 2.0 * std::fabs(a), .yy = 2.0 * std::fabs(c), .zz = 7.0, .xy = std::fabs(b), .xz = 8.0, .yz = 9.0};
    }
};
struct throwing_saddle : saddle {
    surface_height operator()(double x, double y) const { return saddle::operator()(x, y); }
};

}  // namespace

static_assert(height_surface<saddle> && deformation<displaced<saddle>>);
static_assert(!height_surface<throwing_saddle> && !height_surface<int>);

TEST_CASE("a surface moves text towards the reader by its height, and keeps volumes", "[bend]")
{
    const displaced<saddle> d;
    const box3 all{{-4.0, -2.0, -1.0}, {4.0, 2.0, 0.5}};
    bending::check_jacobian(d, all);
    bending::check_bounds(d, all, 300, 1.001);
    bending::check_inverse(d, all, [&](double3 q) { return double3{q.x, q.y, q.z - d.surface(q.x, q.y).z}; });
    test::dice dice{3};
    for (int round = 0; round < 200; ++round) {
        const double3 p = bending::within(dice, all), q = d(p).at;
        CHECK_QUICKLY(q.x == p.x && q.y == p.y);
        CHECK_QUICKLY(bending::determinant(d(p)) == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("a surface's bounds in z do not matter, and its options are refused by its own names", "[bend]")
{
    const bend_bounds by = displaced<saddle>{}.bend({});
    CHECK(by.zz == 0.0);
    CHECK(by.xz == 0.0);
    CHECK(by.yz == 0.0);
    CHECK(by.xy == 0.7);
    bending::check_refused_option("a", displaced<saddle>{{.refuses = "a"}});
}
