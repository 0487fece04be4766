// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A place on a path. The point `at` lies at the distance `from`, and the place itself lies on the line through it with
/// this tangent: on a straight piece, `at` is where the piece begins, so that nothing is rounded twice.
struct path_place {
    point at;
    double from = 0.0;
    point tangent{1.0, 0.0};
    double curvature = 0.0;  ///< positive to the left
};

/// Bounds over a part of a path: of its curvature, of the derivative of the curvature by the length, and of its jumps.
struct path_bounds {
    double low = 0.0, high = 0.0;
    double by = 0.0;
    double jump = 0.0;  ///< the sum of the jumps of the curvature, where pieces meet

    static constexpr double endless = 0x1p120;  // of a corner or a cusp

    constexpr void merge(const path_bounds& b) noexcept
    {
        low = b.low < low ? b.low : low;
        high = b.high > high ? b.high : high;
        by = b.by > by ? b.by : by;
        jump += b.jump;
    }
    /// The greatest size of the curvature.
    [[nodiscard]] constexpr double sharpest() const noexcept { return high > 0.0 - low ? high : 0.0 - low; }
};

/// The length of a cubic from its start to t, by Gauss's rule with 12 points. See path_piece::is_even().
[[nodiscard]] inline double cubic_length(const cubic& c, double t) noexcept
{
    constexpr double nodes[] = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                0.7699026741943047, 0.9041172563704748, 0.9815606342467192};
    constexpr double weights[] = {0.2491470458134027, 0.2334925365383548, 0.2031674267230659,
                                  0.1600783285433463, 0.1069393259953185, 0.0471753363865118};
    const point a = c.p1 - c.p0, b = c.p2 - c.p1, d = c.p3 - c.p2;
    const auto speed = [&](double u) noexcept { return length(lerp(lerp(a, b, u), lerp(b, d, u), u)); };
    double sum = 0.0;
    for (int i = 0; i < 6; ++i)
        sum += weights[i] * (speed(0.5 * t * (1.0 + nodes[i])) + speed(0.5 * t * (1.0 - nodes[i])));
    return 1.5 * t * sum;
}

/// An arc of a circle. Angles are in radians, counter-clockwise.
struct arc_piece {
    point centre;
    double radius = 0.0;
    double first = 0.0;  ///< the angle at which it begins
    double angle = 0.0;  ///< its own
};

/// A piece of a plane_path: a line, an arc of a circle, or a cubic whose speed changes little.
struct path_piece {
    enum class form : std::uint8_t { line, arc, cubic };

    form is = form::line;
    bool corner = false;  ///< whether the path turns at once where the piece begins
    double jump = 0.0;    ///< how far the curvature jumps there
    bool even = true;     ///< whether a cubic's length is certain
    double start = 0.0;   ///< the length of the path before it
    double size = 0.0;    ///< its own length
    cubic c;              ///< a line runs from p0 to p3
    arc_piece round;      ///< of an arc
    path_bounds bounds;

    [[nodiscard]] static path_piece line(point from, point to) noexcept
    {
        path_piece p;
        p.c = {from, from, to, to};
        p.size = length(to - from);
        return p;
    }

    /// An arc from a point around a centre, counter-clockwise if the angle, in radians, is positive.
    [[nodiscard]] static path_piece arc(point from, point centre, double angle) noexcept
    {
        path_piece p;
        p.is = form::arc;
        const point arm = from - centre;
        const double radius = length(arm);
        p.round = {centre, radius, steady(std::atan2(arm.y, arm.x)), angle};
        p.size = radius * std::fabs(angle);
        if (angle < 0.0)
            p.bounds.low = -1.0 / radius;
        else
            p.bounds.high = 1.0 / radius;
        return p;
    }

    /// A piece of a cubic; false if its length is not certain, so that it must be halved.
    ///
    /// The speed is the root of a polynomial q of fourth degree. If q, around the middle, changes by at most half of
    /// its value in Bernstein's ellipse with half axes that sum to 5, the speed is analytic there. Gauss's rule with 12
    /// points is then wrong by at most 64/15 sqrt(1.5 q) 5^-22 / (1 - 5^-2), which is below 2^-48 of the length. The
    /// same holds for each beginning of the piece, whose ellipse lies in the piece's own.
    ///
    /// From  L. N. Trefethen, Approximation Theory and Approximation Practice (2013), theorem 19.3
    [[nodiscard]] static bool read(const cubic& c, path_piece& out) noexcept
    {
        out.is = form::cubic;
        out.c = c;
        const point a = 3.0 * (c.p1 - c.p0), b = 3.0 * (c.p2 - c.p1), d = 3.0 * (c.p3 - c.p2);
        const point v = 0.25 * (a + 2.0 * b + d), v1 = 0.5 * (d - a), v2 = 0.25 * (a - 2.0 * b + d);
        const double q = dot(v, v), q1 = std::fabs(2.0 * dot(v, v1)), q2 = std::fabs(dot(v1, v1) + 2.0 * dot(v, v2)),
                     q3 = std::fabs(2.0 * dot(v1, v2)), q4 = dot(v2, v2);
        constexpr double axis = 0.5 * (5.0 + 0.2);
        out.even = axis * (q1 + axis * (q2 + axis * (q3 + axis * q4))) <= 0.5 * q;
        if (!out.even) {  // for a cusp, the control polygon is close enough
            out.size = (length(a) + length(b) + length(d)) / 3.0;
            out.bounds = {-path_bounds::endless, path_bounds::endless, path_bounds::endless};
            return false;
        }
        out.size = cubic_length(c, 1.0);
        out.bound(q - (q1 + q2 + q3 + q4), q + (q1 + q2 + q3 + q4));
        return true;
    }

    /// The place at a distance from its start, up to its size; path_place::from as a distance along the path.
    [[nodiscard]] path_place at(double along) const noexcept
    {
        switch (is) {
        case form::line: return {c.p0, start, {(c.p3.x - c.p0.x) / size, (c.p3.y - c.p0.y) / size}};
        case form::arc: return arc_at(along);
        case form::cubic: break;
        }
        return cubic_at(along);
    }

private:
    [[nodiscard]] path_place arc_at(double along) const noexcept
    {
        const double side = round.angle < 0.0 ? -1.0 : 1.0, angle = round.first + round.angle * (along / size);
        const point arm{steady_cosine(angle), steady_sine(angle)};
        return {round.centre + round.radius * arm, start + along, {-side * arm.y, side * arm.x}, side / round.radius};
    }

    [[nodiscard]] path_place cubic_at(double along) const noexcept
    {
        const point a = c.p1 - c.p0, b = c.p2 - c.p1, d = c.p3 - c.p2;
        double t = along / size;
        const auto by = [&](double u) noexcept { return 3.0 * lerp(lerp(a, b, u), lerp(b, d, u), u); };
        for (int i = 0; even && i < 8; ++i) {  // Newton's method; the speed is nearly constant
            const double step = (cubic_length(c, t) - along) / length(by(t));
            t = t - step;
            if (std::fabs(step) < 0x1p-50) break;
        }
        const point v = by(t), bend = 6.0 * lerp(b - a, d - b, t);
        const double speed = length(v);
        const point p = c.at(t), tangent = speed > 0.0 ? (1.0 / speed) * v : limit_at(t, bend);
        return {{steady(p.x), steady(p.y)},
                start + along,
                {steady(tangent.x), steady(tangent.y)},
                even ? cross(v, bend) / (speed * speed * speed) : 0.0};
    }

    /// The tangent where a cubic stands still: at a handle of no length, or a cusp. It is the direction in which the
    /// cubic goes on, and at its end the one in which it arrives: of the first derivative that does not vanish.
    [[nodiscard]] point limit_at(double t, point bend) const noexcept
    {
        const point jerk = c.p3 - c.p0 - 3.0 * (c.p2 - c.p1), way = t < 1.0 ? bend : -1.0 * bend;
        const point along = length(way) > 0.0 ? way : jerk;
        const double way_size = length(along);
        return way_size > 0.0 ? (1.0 / way_size) * along : point{1.0, 0.0};
    }

    /// Bounds from Bernstein's coefficients; the squared speed lies between these.
    void bound(double least, double most) noexcept
    {
        const point a[] = {3.0 * (c.p1 - c.p0), 3.0 * (c.p2 - c.p1), 3.0 * (c.p3 - c.p2)},
                    b[] = {2.0 * (a[1] - a[0]), 2.0 * (a[2] - a[1])}, jerk = b[1] - b[0];
        const double turns[] = {cross(a[0], b[0]), (2.0 * cross(a[1], b[0]) + cross(a[0], b[1])) / 3.0,
                                (cross(a[2], b[0]) + 2.0 * cross(a[1], b[1])) / 3.0, cross(a[2], b[1])};
        double low = turns[0], high = turns[0], change = 0.0, bend = 0.0;
        for (const double turn : turns) {
            low = turn < low ? turn : low;
            high = turn > high ? turn : high;
        }
        for (const point v : a) change = std::fabs(cross(v, jerk)) > change ? std::fabs(cross(v, jerk)) : change;
        for (const point v : b) bend = length(v) > bend ? length(v) : bend;
        const double slow = least * std::sqrt(least), fast = most * std::sqrt(most);
        const double farther = std::fabs(low) > std::fabs(high) ? std::fabs(low) : std::fabs(high);
        bounds.low = low / (low < 0.0 ? slow : fast);
        bounds.high = high / (high > 0.0 ? slow : fast);
        bounds.by = (1.0 + 0x1p-30) * (change / (least * least) + 3.0 * farther * bend / (slow * least));
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
