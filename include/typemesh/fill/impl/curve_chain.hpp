// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Consecutive edges of a loop that follow one curve, from its parameter t0 to t1. All places are in cells.
struct curve_chain {
    std::uint32_t first = 0;  ///< the first edge, counted along the loop from the loop's seam
    std::uint32_t last = 0;   ///< the edge after the last one
    std::uint32_t curve = 0;
    bool follows = false;  ///< whether the edges follow the curve, moved by `shift`
    double t0 = 0.0;
    double t1 = 1.0;
    point shift;  ///< from the curve to the edges: 0, or the place of a glyph among merged ones
    point start;  ///< where the chain begins; the chain before it ends there
};

/// The place of a curve, in cells.
[[nodiscard]] inline point place_on(const curve& c, double t, double cells, point shift) noexcept
{
    return cells * c.at(t) + shift;
}

/// A curve, how far it is moved, in cells, and a parameter on it.
struct moved_curve {
    const curve* shape;
    point shift;
    double t = 0.0;
};

/// Two curves' parameters at a meeting.
struct curve_meeting {
    double s = 0.0;
    double t = 0.0;
    point at;
    bool found = false;
};

/// Looks for the meeting of two curves next to their parameters, by Newton's method in both. It is found if the curves
/// cross there, within a 32nd of a cell, not farther than `reach` from `about`.
[[nodiscard]] inline curve_meeting meeting_of(const moved_curve& of_s, const moved_curve& of_t, double cells,
                                              point about, double reach) noexcept
{
    const curve &a = *of_s.shape, &b = *of_t.shape;
    const point shift_a = of_s.shift, shift_b = of_t.shift;
    double s = of_s.t, t = of_t.t;
    constexpr int max_steps = 12;
    constexpr double close = 0x1p-10;  // a square
    const hodograph of_a{a}, of_b{b};
    const double apart = std::fabs(s - t);
    point gap = place_on(a, s, cells, shift_a) - place_on(b, t, cells, shift_b);
    for (int step = 0; step < max_steps && dot(gap, gap) > 0x1p-40; ++step) {
        const point along = cells * a.degree * of_a.derivative(s), other = cells * b.degree * of_b.derivative(t);
        const double turn = cross(along, other);
        if (!(turn * turn > 0x1p-30 * dot(along, along) * dot(other, other))) return {};
        s -= cross(gap, other) / turn;
        t -= cross(gap, along) / turn;
        if (!(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)) return {};
        gap = place_on(a, s, cells, shift_a) - place_on(b, t, cells, shift_b);
    }
    const point found = place_on(a, s, cells, shift_a);
    if (!(dot(gap, gap) <= close) || !(length(found - about) <= reach)) return {};
    if (&a == &b && !(std::fabs(s - t) > 0.5 * apart)) return {};  // a curve meets itself everywhere
    return {s, t, found, true};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
