// SPDX-License-Identifier: MIT

#include <typemesh/bend/twist.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// The point of flat text that a twist has moved here: turned back.
double3 untwisted(const twist& d, double3 q)
{
    const bool along = d.axis == text_axis::along;
    const double back = -d.degrees_per_em * (along ? q.x : q.y) * test::turn_once / 360.0, c = std::cos(back),
                 s = std::sin(back), u = (along ? q.y : q.x) - d.across, w = q.z - d.depth;
    const double old_u = d.across + c * u - s * w, old_w = d.depth + s * u + c * w;
    return along ? double3{q.x, old_u, old_w} : double3{old_u, q.y, old_w};
}

}  // namespace

TEST_CASE("a twist's derivatives and bounds are those of its positions, it can be undone and keeps volumes", "[bend]")
{
    std::size_t points = 0;
    bending::each_twist([&](const twist& d, const box3& all) {
        CHECK(d.refused_options() == error::none);
        if (d.degrees_per_em < 100.0) bending::check_jacobian(d, all);
        points += bending::check_bounds(d, all, 80);
        bending::check_inverse(d, all, [&](double3 q) { return untwisted(d, q); });
        test::dice dice{8};
        for (int round = 0; round < 200; ++round)
            CHECK_QUICKLY(bending::determinant(d(bending::within(dice, all))) == Approx(1.0).epsilon(4e-12));
    });
    CHECK(points > 100'000);
}

TEST_CASE("a twist turns each place by its angle around the axis, which stays", "[bend]")
{
    const twist quarter{.degrees_per_em = 90.0, .across = 0.35, .depth = -0.1};
    // At x = 0 nothing moves; on the axis nothing moves; at x = 1 the top of the letters has turned towards the reader.
    const double3 still = quarter({0.0, 0.8, 0.3}).at, axis = quarter({2.7, 0.35, -0.1}).at,
                  top = quarter({1.0, 1.35, -0.1}).at;
    CHECK(length(still - double3{0.0, 0.8, 0.3}) < 4e-12);
    CHECK(length(axis - double3{2.7, 0.35, -0.1}) < 4e-12);
    CHECK(length(top - double3{1.0, 0.35, 0.9}) < 4e-12);
    const twist up{.degrees_per_em = 90.0, .axis = text_axis::up, .across = 0.5};
    CHECK(length(up({1.5, 1.0, 0.0}).at - double3{0.5, 1.0, 1.0}) < 4e-12);
    // Turning on from any place: the picture at x + s is the picture at x, turned by s.
    test::dice dice{9};
    for (int round = 0; round < 200; ++round) {
        const double x = bending::within(dice, -3.0, 3.0), y = bending::within(dice, -1.0, 1.0),
                     z = bending::within(dice, -1.0, 1.0);
        const double3 first = quarter({x, y, z}).at;
        CHECK_QUICKLY(
            length(quarter({1.0, first.y, first.z}).at - quarter({x + 1.0, y, z}).at - double3{-x, 0.0, 0.0}) < 4e-12);
    }
}

TEST_CASE("a twist's bounds see how far the box is from the axis", "[bend]")
{
    const double turn = test::turn_once / 360.0 * 30.0;
    const twist d{.degrees_per_em = 30.0, .across = 1.0, .depth = -2.0};
    const bend_bounds by = d.bend({{0.0, -3.0, -3.0}, {1.0, 2.0, 1.0}});
    CHECK(by.xx == Approx(turn * turn * 5.0));  // 4 across, 3 deep
    CHECK(by.xy == Approx(turn));
    CHECK(by.xz == Approx(turn));
    CHECK(by.yy == 0.0);
    CHECK(by.zz == 0.0);
    CHECK(by.yz == 0.0);
    const bend_bounds far_off = d.bend({{0.0, 4.0, -2.0}, {1.0, 5.0, -2.0}});
    CHECK(far_off.xx == Approx(turn * turn * 4.0));
}

TEST_CASE("a twist's numbers must be finite", "[bend]")
{
    for (const double bad : bending::not_finite) {
        bending::check_refused_option("degrees_per_em", twist{.degrees_per_em = bad});
        bending::check_refused_option("across", twist{.across = bad});
        bending::check_refused_option("depth", twist{.depth = bad});
    }
    CHECK(twist{.degrees_per_em = 0.0}.refused_options() == error::none);
    CHECK(refused_text(twist{}, {{-1e3, -1e3, 0.0}, {1e3, 1e3, 0.0}}) == error::none);
}
