// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/profile_points.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A cubic Bezier curve from (0, 0) to (1, end) with two control points, in steps of equal parameter. Its t must not
/// decrease.
struct bezier_section {
    profile_point first = {0.0f, 0.5f};   ///< the control point near the wall
    profile_point second = {0.5f, 1.0f};  ///< the control point near the cap
    float end = 1.0f;                     ///< its height at t = 1

    /// See option_bits.
    [[nodiscard]] option_bits key() const noexcept
    {
        option_bits bits{first.t, first.h, second.t, second.h};
        bits.words[0] |= option_bits{end}.words[0] << 32;
        return bits;
    }

    /// The number of steps for the tolerance, by Wang's bound; 8 if the tolerance is unknown; at most 63.
    ///
    /// From  R. Goldman, Pyramid Algorithms (2003), 5.6.3: n = sqrt(d(d-1)/8 * max|second difference| / tolerance)
    [[nodiscard]] std::uint32_t steps_for(const profile_scale& scale) const noexcept
    {
        if (!(scale.tolerance > 0.0)) return 8;
        const auto bend = [&scale](point a, point b, point d) noexcept {
            const point difference = a - 2.0 * b + d;
            return length(point{scale.width * difference.x, scale.depth * difference.y});
        };
        const cubic c = curve();
        const double most = std::fmax(bend(c.p0, c.p1, c.p2), bend(c.p1, c.p2, c.p3));
        const double n = std::ceil(std::sqrt(0.75 * most / scale.tolerance));
        return n >= 1.0 && n < 63.0 ? static_cast<std::uint32_t>(n) : n < 1.0 ? 1u : 63u;
    }

    /// Whether it stays between heights 0 and 1 and its t does not decrease, except for roundings that add() corrects.
    [[nodiscard]] bool is_valid() const noexcept
    {
        const cubic c = curve();
        if (!is_finite(as_double(end))) return false;
        for (const point p : {c.p1, c.p2})
            if (!is_finite(p.x) || !is_finite(p.y)) return false;
        const point first_leg = c.p1 - c.p0, middle = c.p2 - c.p1, last = c.p3 - c.p2;  // the derivative's points
        bool valid = true;
        const auto look = [&](double s) noexcept {
            if (!(s >= 0.0 && s <= 1.0)) return;
            const double r = 1.0 - s;
            const point p = c.at(s);
            const double grows = r * r * first_leg.x + 2.0 * r * s * middle.x + s * s * last.x;
            valid = valid && grows >= -slack && p.y >= -slack && p.y <= 1.0 + slack;
        };
        look(0.0);
        look(1.0);
        const double bend = first_leg.x - 2.0 * middle.x + last.x;  // where t grows most slowly
        if (!is_zero(bend)) look((first_leg.x - middle.x) / bend);
        const double a = first_leg.y - 2.0 * middle.y + last.y, b = first_leg.y - middle.y, d = b * b - a * first_leg.y;
        if (d >= 0.0)  // where h turns
            for (const double root : {b - std::sqrt(d), b + std::sqrt(d)}) {
                if (!is_zero(a)) look(root / a);
                if (!is_zero(root)) look(first_leg.y / root);
            }
        return valid;
    }

    /// Adds the points of `steps` steps; points beyond 63 steps are not valid.
    void add(std::uint32_t steps, profile_points& out) const noexcept
    {
        const cubic c = curve();
        const auto within = [](double v) noexcept {  // clamps roundings, the only way in which a curve with is_valid()
                                                     // leaves the range
            return static_cast<float>(v < 0.0 && v >= -slack ? 0.0 : v > 1.0 && v <= 1.0 + slack ? 1.0 : v);
        };
        out.add({0.0f, 0.0f});
        double t = 0.0;
        for (std::uint32_t i = 1; i < steps && i < profile_points::most; ++i) {
            const point p = c.at(static_cast<double>(i) / steps);
            t = p.x < t && p.x >= t - slack ? t : p.x;
            out.add({within(t), within(p.y)});
        }
        out.add({1.0f, end});
    }

private:
    static constexpr double slack = 0x1p-30;

    [[nodiscard]] cubic curve() const noexcept
    {
        const auto at = [](profile_point p) noexcept { return point{as_double(p.t), as_double(p.h)}; };
        return {{}, at(first), at(second), {1.0, as_double(end)}};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
