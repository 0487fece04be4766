// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/profile_points.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A cubic Bezier curve from (0, 0) by two control points to (1, end), in steps of equal parameter. Its t may not
/// decrease.
struct bezier_section {
    profile_point first = {0.0f, 0.5f};   ///< the control point near the wall
    profile_point second = {0.5f, 1.0f};  ///< the one near the cap
    float end = 1.0f;                     ///< its height at t = 1

    /// See option_bits.
    [[nodiscard]] option_bits key() const noexcept
    {
        option_bits bits{first.t, first.h, second.t, second.h};
        bits.words[0] |= option_bits{end}.words[0] << 32;
        return bits;
    }

    /// How many steps the tolerance asks for, by Wang's bound; 8 if that is unknown; at most 63.
    ///
    /// From  R. Goldman, Pyramid Algorithms (2003), 5.6.3: n = sqrt(d(d-1)/8 * max|second difference| / tolerance)
    [[nodiscard]] std::uint32_t steps_for(const profile_scale& scale) const noexcept
    {
        if (!(scale.tolerance > 0.0)) return 8;
        const auto bend = [&scale](point a, point b, point d) noexcept {
            const point difference = a - 2.0 * b + d;
            return length({scale.width * difference.x, scale.depth * difference.y});
        };
        const cubic c = curve();
        const double most = std::fmax(bend(c.p0, c.p1, c.p2), bend(c.p1, c.p2, c.p3));
        const double n = std::ceil(std::sqrt(0.75 * most / scale.tolerance));
        return n >= 1.0 && n < 63.0 ? static_cast<std::uint32_t>(n) : n < 1.0 ? 1u : 63u;
    }

    /// Adds the points of that many steps; beyond 63 they are not valid.
    void add(std::uint32_t steps, profile_points& out) const noexcept
    {
        const cubic c = curve();
        out.add({0.0f, 0.0f});
        for (std::uint32_t i = 1; i < steps && i < profile_points::most; ++i) {
            const point p = c.at(static_cast<double>(i) / steps);
            out.add({static_cast<float>(p.x), static_cast<float>(p.y)});
        }
        out.add({1.0f, end});
    }

private:
    [[nodiscard]] cubic curve() const noexcept
    {
        const auto at = [](profile_point p) noexcept { return point{as_double(p.t), as_double(p.h)}; };
        return {{}, at(first), at(second), {1.0, as_double(end)}};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
