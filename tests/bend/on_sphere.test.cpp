// SPDX-License-Identifier: MIT

#include <typemesh/bend/on_sphere.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// The point of flat text that a sphere has moved here.
double3 off_sphere(const on_sphere& d, double3 q)
{
    const double side = d.radius > 0.0 ? 1.0 : -1.0, z = q.z + d.radius, flat = std::hypot(q.x, z);
    return {d.radius * std::atan2(side * q.x, side * z), d.radius * std::atan2(side * q.y, flat),
            side * std::hypot(flat, q.y) - d.radius};
}

}  // namespace

TEST_CASE("a sphere's derivatives and bounds are those of its positions, and it can be undone", "[bend]")
{
    std::size_t points = 0;
    bending::each_on_sphere([&](const on_sphere& d, const box3& all) {
        CHECK(d.refused_options() == error::none);
        bending::check_jacobian(d, all);
        points += bending::check_bounds(d, all, 700);
        bending::check_inverse(d, all, [&](double3 q) { return off_sphere(d, q); });
    });
    CHECK(points > 100'000);
}

TEST_CASE("a sphere's bounds hold near the poles and beyond them", "[bend]")
{
    for (const double radius : {1.0, -2.0}) {
        const on_sphere d{.radius = radius};
        const double size = std::fabs(radius);
        for (const double middle : {1.5, -1.6, 3.1, -0.01}) {
            CAPTURE(radius, middle);
            const box3 all{{-size, (middle - 0.3) * size, -0.5 * size}, {size, (middle + 0.3) * size, 0.5 * size}};
            bending::check_jacobian(d, all);
            bending::check_bounds(d, all, 200, 1e18);
        }
    }
}

TEST_CASE("text on a sphere keeps the equator and the meridians, and its origin stays", "[bend]")
{
    test::dice dice{7};
    bending::each_on_sphere([&](const on_sphere& d, const box3& all) {
        const double3 origin = d({}).at;
        CHECK((origin.x == 0.0 && origin.y == 0.0 && origin.z == 0.0));
        const double r = std::fabs(d.radius);
        for (int round = 0; round < 200; ++round) {
            double3 p = bending::within(dice, all);
            p.z = 0.0;
            const deformed_point at = d(p);
            CHECK_QUICKLY(length(at.at + double3{0.0, 0.0, d.radius}) == Approx(r).epsilon(4e-12));
            CHECK_QUICKLY(length(at.y) == Approx(1.0).epsilon(4e-12));
            CHECK_QUICKLY(length(at.x) == Approx(std::cos(p.y / d.radius)).epsilon(4e-12));
            CHECK_QUICKLY(length(at.z) == Approx(1.0).epsilon(4e-12));
            // The three columns are perpendicular, and right-handed.
            CHECK_QUICKLY(std::fabs(dot(at.x, at.y)) + std::fabs(dot(at.y, at.z)) + std::fabs(dot(at.z, at.x)) < 4e-12);
            CHECK_QUICKLY(bending::determinant(at) == Approx(std::cos(p.y / d.radius)).epsilon(4e-12));
            p.y = 0.0;
            CHECK_QUICKLY(length(d(p).x) == Approx(1.0).epsilon(4e-12));
            CHECK_QUICKLY(std::fabs(d(p).at.y) < 4e-12 * r);
        }
    });
}

TEST_CASE("on a sphere of a huge radius, text is flat", "[bend]")
{
    test::dice dice{6};
    const box3 all{{-30.0, -3.0, -1.0}, {30.0, 3.0, 0.5}};
    for (const double radius : {1e6, -1e9, 1e12, 1e15, -1e200, 1e300}) {
        CAPTURE(radius);
        const on_sphere d{.radius = radius};
        double worst = 0.0;
        for (int round = 0; round < 100; ++round) {
            const double3 p = bending::within(dice, all), q = d(p).at;
            const double sag = 0.5 * (p.x * (p.x / radius) + p.y * (p.y / radius));
            worst = (std::max)({worst, std::fabs(q.z - (p.z - sag)), std::fabs(q.x - p.x) - 60.0 / std::fabs(radius),
                                std::fabs(q.y - p.y) - 60.0 / std::fabs(radius)});
        }
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("a sphere's radius, a text that reaches a pole and one longer than the equator are refused", "[bend]")
{
    for (const double bad : bending::not_finite) bending::check_refused_option("radius", on_sphere{.radius = bad});
    for (const double bad : {0.0, -0.0, 1e-300, -1e-7})
        bending::check_refused_option("radius", on_sphere{.radius = bad});
    for (const double radius : {1.0, -1.0, 7.0}) {
        CAPTURE(radius);
        const on_sphere d{.radius = radius};
        const double quarter = 0.25 * test::turn_once * std::fabs(radius);
        const auto text = [&](double low, double high, double long_) {
            return box3{{0.4, low * quarter, 0.0}, {0.4 + 4.0 * long_ * quarter, high * quarter, 0.0}};
        };
        CHECK(refused_text(d, text(-0.999, 0.999, 0.999)) == error::none);
        CHECK(refused_text(d, text(-0.1, 1.001, 0.5)) == error::folds_over);
        CHECK(refused_text(d, text(-1.001, 0.1, 0.5)) == error::folds_over);
        CHECK(refused_text(d, text(-0.1, 0.1, 1.001)) == error::goes_around);
        CHECK(refused_text(d, text(-0.1, std::nan(""), 0.1)) == error::folds_over);
    }
}
