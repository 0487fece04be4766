// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

inline constexpr double half_turn = 3.14159265358979323846;  // radians

// Sines and angles are rounded to 2^-40, so that the number and the points of cubics are the same with every libm.

/// The number of equal cubics that keep an arc of a circle, or of an ellipse, within a tolerance: at least one for each
/// quarter, at most 4,096.
///
///     sweep    the arc's angle, in radians, up to a turn
///     radius   the circle's radius, or the ellipse's greater one
///
/// A cubic over the angle a whose handles have the length 4/3 tan(a/4) lies outside of the unit circle, by at most
/// 2/27 sin^6(a/4) / cos^2(a/4).
[[nodiscard]] inline std::uint32_t cubics_for(double sweep, double radius, double tolerance) noexcept
{
    constexpr std::uint32_t max_pieces = 4096;
    const double turn = std::fabs(sweep);
    if (!(turn <= 3.0 * half_turn)) return 1;  // no number
    auto count = static_cast<std::uint32_t>(std::ceil(turn / (0.5 * half_turn) - 1e-9));
    if (count == 0) count = 1;
    for (; count < max_pieces; count += 1 + count / 4) {
        const double s = steady_sine(0.25 * turn / count), c = steady_cosine(0.25 * turn / count);
        if (!(radius * (2.0 / 27.0) * s * s * s * s * s * s > tolerance * c * c)) break;
    }
    return count < max_pieces ? count : max_pieces;
}

/// An arc as SVG gives it, from its end points: SVG 2, appendix B.2. Its points are map((cos a, sin a)) for the angles
/// from `start` to `start + sweep`, in radians.
struct elliptical_arc {
    affine map;
    double start = 0.0;
    double sweep = 0.0;
    double radius = 0.0;  ///< the greater one; 0: the arc is a line

    /// The arc from `from` to `to`, which are distinct. Radii that are too small for the chord are enlarged. A radius
    /// of 0 gives a line, and so do numbers whose squares are too large or too small.
    [[nodiscard]] static elliptical_arc between(point from, point to, point radii, double degrees, bool large,
                                                bool positive) noexcept
    {
        elliptical_arc arc;
        double rx = std::fabs(radii.x), ry = std::fabs(radii.y);
        if (!(rx > 0.0) || !(ry > 0.0)) return arc;
        const double turn = std::fmod(degrees, 360.0) * (half_turn / 180.0);
        const double c = steady_cosine(turn), s = steady_sine(turn);
        const point half = 0.5 * (from - to);
        // The chord's half in the space where the ellipse is the unit circle.
        point own{(c * half.x + s * half.y) / rx, (c * half.y - s * half.x) / ry};
        double square = dot(own, own);
        if (!(square > 0.0) || !is_finite(square)) return arc;
        double away = 0.0;  // of the centre from the chord, in halves of the chord
        if (square > 1.0) {
            const double grow = std::sqrt(square);
            rx *= grow;
            ry *= grow;
            own = (1.0 / grow) * own;
            square = 1.0;
        } else {
            away = (large == positive ? -1.0 : 1.0) * std::sqrt((1.0 - square) / square);
        }
        const point centre{away * own.y, -away * own.x}, first = own - centre;
        arc.start = steady_angle(first.y, first.x);
        arc.sweep = steady_angle(2.0 * away * square, 1.0 - 2.0 * square);
        if (positive && arc.sweep < 0.0) arc.sweep += 2.0 * half_turn;
        if (!positive && arc.sweep > 0.0) arc.sweep -= 2.0 * half_turn;
        if (!is_finite(arc.sweep)) return {};
        const point middle = lerp(from, to, 0.5);
        arc.map = {c * rx, -s * ry, 0.0, s * rx, c * ry, 0.0};
        const point shift = arc.map(centre) + middle;
        arc.map.dx = shift.x;
        arc.map.dy = shift.y;
        arc.radius = rx > ry ? rx : ry;
        return arc;
    }

    [[nodiscard]] point at(double angle) const noexcept { return map(on_circle(angle)); }

    /// put(control, control, end) for the cubics that follow the arc within the tolerance; the last one ends at `to`.
    template <class Put>
    void cubics(point to, double tolerance, Put&& put) const noexcept
    {
        const std::uint32_t count = cubics_for(sweep, radius, tolerance);
        const double step = sweep / count, handle = 4.0 / 3.0 * steady_tangent(0.25 * step);
        point last = on_circle(start);
        for (std::uint32_t k = 1; k <= count; ++k) {
            const point next = on_circle(start + step * k);
            put(map(last + handle * point{-last.y, last.x}), map(next - handle * point{-next.y, next.x}),
                k == count ? to : map(next));
            last = next;
        }
    }

private:
    [[nodiscard]] static point on_circle(double angle) noexcept { return {steady_cosine(angle), steady_sine(angle)}; }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
