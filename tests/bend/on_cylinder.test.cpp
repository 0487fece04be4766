// SPDX-License-Identifier: MIT

#include <typemesh/bend/on_cylinder.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// The point of flat text that a cylinder has moved here.
double3 off_cylinder(const on_cylinder& d, double3 q)
{
    const bool up = d.axis == text_axis::up;
    const double side = d.radius > 0.0 ? 1.0 : -1.0, around = up ? q.x : q.y, out = q.z + d.radius;
    const double angle = std::atan2(side * around, side * out), z = side * std::hypot(around, out) - d.radius;
    return up ? double3{d.radius * angle, q.y, z} : double3{q.x, d.radius * angle, z};
}

}  // namespace

TEST_CASE("a cylinder's derivatives and bounds are those of its positions, and it can be undone", "[bend]")
{
    std::size_t points = 0;
    bending::each_on_cylinder([&](const on_cylinder& d, const box3& all) {
        CHECK(d.refused_options() == error::none);
        bending::check_jacobian(d, all);
        points += bending::check_bounds(d, all, 300);
        bending::check_inverse(d, all, [&](double3 q) { return off_cylinder(d, q); });
    });
    CHECK(points > 100'000);
}

TEST_CASE("a cylinder's bounds are the greatest second derivatives", "[bend]")
{
    test::dice dice{3};
    bending::each_on_cylinder([&](const on_cylinder& d, const box3& all) {
        const box3 b = bending::box_within(dice, all, 0.01, 1.0);
        const bend_bounds by = d.bend(b);
        const bool up = d.axis == text_axis::up;
        const double r = std::fabs(d.radius),
                     deepest = (std::max)(std::fabs(d.radius + b.low.z), std::fabs(d.radius + b.high.z));
        CHECK((up ? by.xx : by.yy) == Approx(deepest / (r * r)).epsilon(4e-12));
        CHECK((up ? by.xz : by.yz) == Approx(1.0 / r).epsilon(4e-12));
        CHECK((up ? by.yy : by.xx) == 0.0);
        CHECK((up ? by.yz : by.xz) == 0.0);
        CHECK(by.zz == 0.0);
        CHECK(by.xy == 0.0);
    });
}

TEST_CASE("text on a cylinder keeps its lengths, and its origin stays", "[bend]")
{
    bending::each_on_cylinder([&](const on_cylinder& d, const box3&) {
        const double3 origin = d({}).at;
        CHECK((origin.x == 0.0 && origin.y == 0.0 && origin.z == 0.0));
        const bool up = d.axis == text_axis::up;
        const auto on_line = [&](double s) { return d(up ? double3{s, 0.1, 0.0} : double3{0.1, s, 0.0}); };
        const double r = std::fabs(d.radius), from = -0.7 * r, to = 2.1 * r;
        double around = 0.0;
        double3 last = on_line(from).at;
        const int steps = 4096;
        for (int i = 1; i <= steps; ++i) {
            const deformed_point next = on_line(from + (to - from) * i / steps);
            around += length(next.at - last);
            last = next.at;
            const double3 along = up ? next.x : next.y;
            CHECK_QUICKLY(std::fabs(length(along) - 1.0) < 4e-12);
            // Everything at z = 0 lies on the cylinder itself.
            CHECK_QUICKLY(std::hypot(up ? last.x : last.y, last.z + d.radius) == Approx(r).epsilon(4e-12));
        }
        CHECK(around == Approx(to - from).epsilon(1e-7));
        // And its normal points away from the axis if the radius is positive, otherwise towards it.
        const double3 away{up ? last.x : 0.0, up ? 0.0 : last.y, last.z + d.radius};
        CHECK(dot(on_line(to).z, away) == Approx(d.radius).epsilon(4e-12));
    });
}

TEST_CASE("on a cylinder of a huge radius, text is flat", "[bend]")
{
    test::dice dice{5};
    const box3 all{{-30.0, -3.0, -1.0}, {30.0, 3.0, 0.5}};
    for (const double radius : {1e6, 1e9, -1e12, 1e15, -1e200, 1e300}) {
        for (const text_axis axis : {text_axis::up, text_axis::along}) {
            CAPTURE(radius, int(axis));
            const on_cylinder d{.radius = radius, .axis = axis};
            double worst = 0.0;
            for (int round = 0; round < 100; ++round) {
                const double3 p = bending::within(dice, all), q = d(p).at;
                const double s = axis == text_axis::up ? p.x : p.y, sag = 0.5 * s * (s / radius);
                worst =
                    (std::max)({worst, std::fabs(q.z - (p.z - sag)), std::fabs(q.x - p.x) - 31.0 / std::fabs(radius),
                                std::fabs(q.y - p.y) - 31.0 / std::fabs(radius)});
            }
            CHECK(worst < 1e-9);
            CHECK(d.bend(all).xx <= 1.000001 / std::fabs(radius));
        }
    }
}

TEST_CASE("a cylinder's radius and a text longer than its circumference are refused", "[bend]")
{
    for (const double bad : bending::not_finite) bending::check_refused_option("radius", on_cylinder{.radius = bad});
    for (const double bad : {0.0, -0.0, 1e-300, 5e-324, -1e-7})
        bending::check_refused_option("radius", on_cylinder{.radius = bad});
    CHECK(on_cylinder{}.refused_options() == error::none);
    CHECK(on_cylinder{.radius = 1e-5}.refused_options() == error::none);

    for (const double radius : {1.0, -1.0, 0.25}) {
        const double around = test::turn_once * std::fabs(radius);
        const box3 fits{{-0.3, 0.0, 0.0}, {-0.3 + 0.9999 * around, 100.0, 0.0}},
            is_long{{-0.3, 0.0, 0.0}, {-0.3 + 1.0001 * around, 0.1, 0.0}};
        const auto turned = [](const box3& b) {
            return box3{{b.low.y, b.low.x, b.low.z}, {b.high.y, b.high.x, b.high.z}};
        };
        const on_cylinder up{.radius = radius}, along{.radius = radius, .axis = text_axis::along};
        CHECK(refused_text(up, fits) == error::none);
        CHECK(refused_text(up, is_long) == error::goes_around);
        CHECK(refused_text(along, turned(fits)) == error::none);
        CHECK(refused_text(along, turned(is_long)) == error::goes_around);
        CHECK(refused_text(along, is_long) == (0.1 <= around ? error::none : error::goes_around));
    }
}
