// SPDX-License-Identifier: MIT
#pragma once

// The ready deformations with many options, and the laws of every deformation.

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/displaced.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/wave.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "support/catch.hpp"
#include "support/regions.hpp"

namespace bending {

using namespace typemesh;

inline double within(test::dice& d, double low, double high) { return low + (high - low) * d.fraction(); }
inline double3 within(test::dice& d, const box3& b)
{
    return {within(d, b.low.x, b.high.x), within(d, b.low.y, b.high.y), within(d, b.low.z, b.high.z)};
}
/// A box of random place and size in another one; its edges are at least `least` long.
inline box3 box_within(test::dice& d, const box3& b, double least, double share)
{
    const auto cut = [&](double low, double high, double& from, double& to) {
        const double size = least + (high - low - least) * share * d.fraction();
        from = within(d, low, high - size);
        to = from + size;
    };
    box3 out;
    cut(b.low.x, b.high.x, out.low.x, out.high.x);
    cut(b.low.y, b.high.y, out.low.y, out.high.y);
    cut(b.low.z, b.high.z, out.low.z, out.high.z);
    return out;
}

inline double3 step_along(int axis, double by)
{
    return {axis == 0 ? by : 0.0, axis == 1 ? by : 0.0, axis == 2 ? by : 0.0};
}
inline double3 column(const deformed_point& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
inline double bound_of(const bend_bounds& b, int i, int j)
{
    const double all[3][3] = {{b.xx, b.xy, b.xz}, {b.xy, b.yy, b.yz}, {b.xz, b.yz, b.zz}};
    return all[i][j];
}
inline double determinant(const deformed_point& p) { return dot(p.x, cross(p.y, p.z)); }
inline double farthest(double3 a, double3 b) { return length(a - b); }

// Each of these calls use(deformation, box in which text may stand) for many options.

template <class Use>
void each_on_cylinder(const Use& use)
{
    for (const double radius : {2.0, -2.0, 0.3, -0.3, 60.0})
        for (const text_axis axis : {text_axis::up, text_axis::along}) {
            INFO("on_cylinder, radius " << radius << (axis == text_axis::up ? ", axis up" : ", axis along"));
            const double size = 3.0 * std::fabs(radius), deep = 0.8 * std::fabs(radius);
            use(on_cylinder{.radius = radius, .axis = axis}, box3{{-size, -size, -deep}, {size, size, deep}});
        }
}
template <class Use>
void each_on_sphere(const Use& use)
{
    for (const double radius : {3.0, -3.0, 0.5, -20.0}) {
        INFO("on_sphere, radius " << radius);
        const double size = std::fabs(radius);  // up to 57 degrees of latitude
        use(on_sphere{.radius = radius}, box3{{-3.0 * size, -size, -0.8 * size}, {3.0 * size, size, 0.8 * size}});
    }
}
template <class Use>
void each_twist(const Use& use)
{
    for (const double turn : {20.0, -75.0, 360.0})
        for (const text_axis axis : {text_axis::along, text_axis::up})
            for (const double across : {0.0, 0.35, -3.0})
                for (const double depth : {0.0, -0.25}) {
                    INFO("twist, " << turn << " degrees, axis " << int(axis) << " at " << across << ", " << depth);
                    use(twist{.degrees_per_em = turn, .axis = axis, .across = across, .depth = depth},
                        box3{{-4.0, -2.0, -1.0}, {4.0, 2.0, 0.5}});
                }
}
template <class Use>
void each_taper(const Use& use)
{
    for (const double growth : {-0.1, 0.3, 0.0, -2.0})
        for (const text_axis axis : {text_axis::along, text_axis::up}) {
            INFO("taper, growth " << growth << ", axis " << int(axis));
            use(taper{.growth = growth, .axis = axis}, box3{{-2.0, -2.0, -1.0}, {2.0, 2.0, 0.5}});
        }
}
template <class Use>
void each_wave(const Use& use)
{
    for (const double height : {0.1, -0.4})
        for (const double size : {2.0, -0.7})
            for (const double direction : {0.0, 90.0, 37.0, -200.0})
                for (const double phase : {0.0, 110.0}) {
                    INFO("wave, " << height << ' ' << size << ' ' << direction << ' ' << phase);
                    use(displaced<wave>{{.height = height, .length = size, .direction = direction, .phase = phase}},
                        box3{{-4.0, -2.0, -1.0}, {4.0, 2.0, 0.5}});
                }
}
template <class Use>
void each_ready(const Use& use)
{
    each_on_cylinder(use);
    each_on_sphere(use);
    each_twist(use);
    each_taper(use);
    each_wave(use);
}

/// The columns of the Jacobian matrix are the central differences of the positions.
template <deformation D>
void check_jacobian(const D& d, const box3& all, int rounds = 300)
{
    test::dice dice{11};
    constexpr double h = 0x1p-14;
    double worst = 0.0;
    for (int round = 0; round < rounds; ++round) {
        const double3 p = within(dice, all);
        const deformed_point at = d(p);
        for (int axis = 0; axis < 3; ++axis) {
            const double3 step = step_along(axis, h);
            const double3 slope = (0.5 / h) * (d(p + step).at - d(p - step).at);
            worst = (std::max)(worst, farthest(slope, column(at, axis)) / (1.0 + length(slope)));
        }
    }
    CHECK(worst < 1e-6);  // third derivatives, and the rounding of sines to 40 bits
}

/// The bounds over random boxes are never below the differences of the Jacobian's columns in them, and over small boxes
/// they are not much above. Returns the number of points that were compared.
template <deformation D>
std::size_t check_bounds(const D& d, const box3& all, int boxes = 100, double slack = 2.0)
{
    test::dice dice{12};
    constexpr double h = 0x1p-13;
    std::size_t points = 0;
    double worst = 0.0, loosest = 0.0;
    for (int round = 0; round < boxes; ++round) {
        const bool is_small = round % 2 == 0;
        const box3 b = box_within(dice, all, 4.0 * h, is_small ? 1.0 / 64 : 1.0);
        const bend_bounds bounds = d.bend(b);
        const double3 margin{h, h, h};
        const box3 inner{b.low + margin, b.high - margin};
        double found[3][3] = {};
        for (int k = 0; k < 40; ++k) {
            double3 p = within(dice, inner);
            if (k < 8)  // the corners
                p = {(k & 1) != 0 ? inner.high.x : inner.low.x, (k & 2) != 0 ? inner.high.y : inner.low.y,
                     (k & 4) != 0 ? inner.high.z : inner.low.z};
            ++points;
            for (int j = 0; j < 3; ++j) {
                const deformed_point before = d(p - step_along(j, h)), after = d(p + step_along(j, h));
                for (int i = 0; i < 3; ++i) {
                    const double bent = farthest(column(after, i), column(before, i)) / (2.0 * h);
                    worst = (std::max)(worst, bent - bound_of(bounds, i, j));
                    found[i][j] = (std::max)(found[i][j], bent);
                }
            }
        }
        for (int i = 0; is_small && i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                loosest = (std::max)(loosest, (bound_of(bounds, i, j) - 1e-3) / (found[i][j] + 1e-12));
    }
    CHECK(worst < 1e-8);  // the mean of the second derivative between two points of the box: roundings remain
    CHECK(loosest < slack);
    return points;
}

/// A second implementation, the other way round, returns each point.
template <deformation D, class Inverse>
void check_inverse(const D& d, const box3& all, const Inverse& back, int rounds = 500)
{
    test::dice dice{13};
    double worst = 0.0;
    for (int round = 0; round < rounds; ++round) {
        const double3 p = within(dice, all), q = back(d(p).at);
        worst = (std::max)(worst, farthest(p, q) / (1.0 + length(p)));
    }
    CHECK(worst < 1e-12);
}

/// The options are refused by the name of one of them.
template <class D>
void check_refused_option(const char* name, const D& how)
{
    const error e = how.refused_options();
    INFO(name);
    CHECK(e == error::bad_option);
    REQUIRE(e.option != nullptr);
    CHECK(std::string{e.option} == name);
}

/// Numbers that no option may be.
inline const std::array<double, 3> not_finite{std::nan(""), HUGE_VAL, -HUGE_VAL};

}  // namespace bending
