// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A section of a curve between two grid points, in cells from its start. It is the curve's own section, moved so that
/// it begins and ends exactly in these points: by less than a cell, except where contours cross or have been moved.
struct curve_section {
    std::uint32_t degree = 1;
    point p[4] = {};

    /// The section from t0 to t1, which may run against the curve (t0 > t1). `cells`: per font unit.
    [[nodiscard]] static curve_section of(const curve& c, double t0, double t1, double cells, grid_point start,
                                          grid_point end) noexcept
    {
        curve_section s;
        s.degree = c.degree;
        for (std::uint32_t k = 0; k <= c.degree; ++k) s.p[k] = cells * blossom(c, t0, t1, k);
        const point from = exact(start), to = exact(end) - from;
        const point at_start = -1.0 * s.p[0], at_end = to - s.p[c.degree];
        for (std::uint32_t k = 0; k <= c.degree; ++k)
            s.p[k] = s.p[k] + lerp(at_start, at_end, static_cast<double>(k) / c.degree);
        s.p[0] = {};
        s.p[c.degree] = to;
        return s;
    }

    [[nodiscard]] point at(double t) const noexcept { return curve{degree, {p[0], p[1], p[2], p[3]}}.at(t); }

    /// A limit for the distance between the section and its chord; negative if the section runs beyond its ends.
    [[nodiscard]] double height() const noexcept
    {
        const point chord = p[degree];
        const double size = length(chord);
        double highest = 0.0;
        for (std::uint32_t k = 1; k < degree; ++k) {
            const double along = dot(p[k], chord), across = cross(chord, p[k]);
            if (along < -size || along > size * (size + 1.0)) return -1.0;
            const double h = across < 0.0 ? -across : across;
            highest = h > highest ? h : highest;
        }
        return size > 0.0 ? (degree == 2 ? 0.5 : 0.75) * highest / size : -1.0;
    }

    [[nodiscard]] static constexpr point exact(grid_point g) noexcept
    {
        return {static_cast<double>(g.x), static_cast<double>(g.y)};
    }

private:
    /// Control point k of the section.
    [[nodiscard]] static point blossom(const curve& c, double t0, double t1, std::uint32_t k) noexcept
    {
        point q[4] = {c.p[0], c.p[1], c.p[2], c.p[3]};
        for (std::uint32_t left = c.degree; left > 0; --left) {
            const double t = left > c.degree - k ? t1 : t0;
            for (std::uint32_t i = 0; i < left; ++i) q[i] = lerp(q[i], q[i + 1], t);
        }
        return q[0];
    }
};

/// The parameters from 0 to 1, ascending, at which a cubic turns from one side to the other: at inflections, and on
/// both sides of a cusp.
struct turning_points {
    std::uint32_t count = 0;
    double t[2] = {};
};
[[nodiscard]] inline turning_points turning_points_of(const cubic& q) noexcept
{
    const point a = q.p1 - q.p0, b = q.p2 - q.p1, d = q.p3 - q.p2;
    // cross(B', B'') = 18 * (ab (1 - t)^2 + ad t (1 - t) + bd t^2)
    const double ab = cross(a, b), ad = cross(a, d), bd = cross(b, d);
    const double square = ab - ad + bd, linear = ad - 2.0 * ab, under = linear * linear - 4.0 * square * ab;
    turning_points found;
    if (!(under > 0.0)) return found;
    const double half = -0.5 * (linear + (linear < 0.0 ? -std::sqrt(under) : std::sqrt(under)));
    double first = half / square, second = ab / half;  // infinite, or not a number, where there is no solution
    if (second < first) {
        const double other = first;
        first = second;
        second = other;
    }
    for (const double t : {first, second})
        if (t > 0.0 && t < 1.0) found.t[found.count++] = t;
    return found;
}

/// An arc of a conic: the points with b^2 = 4 w^2 a c, where a, b, c are the barycentric coordinates in the triangle of
/// start, control point and end, and w is the weight. It touches the legs of the triangle in its ends.
///
/// From  G. Farin, Curves and Surfaces for CAGD, 5th ed. (2002), 12.5
class conic_arc {
public:
    /// `control` and `end` relative to the start, in cells; they are not collinear with it.
    conic_arc(point control, point end) noexcept : control_{control}, end_{end}, area_{cross(control, end)} {}

    /// The square of the weight.
    double square = 1.0;

    /// A point's place in the triangle, and its distance from the arc.
    struct place {
        double a, b, c;
        double slope;     ///< the length of the gradient of b^2 - 4 square a c, per cell
        double distance;  ///< signed, in cells, to first order; positive on the control point's side
    };
    [[nodiscard]] place at(point q) const noexcept
    {
        place s{};
        s.b = cross(q, end_) / area_;
        s.c = cross(control_, q) / area_;
        s.a = 1.0 - s.b - s.c;
        const point db{end_.y / area_, -end_.x / area_}, dc{-control_.y / area_, control_.x / area_};
        const point da = -1.0 * (db + dc);
        const point slope = 2.0 * s.b * db - 4.0 * square * (s.c * da + s.a * dc);
        s.slope = length(slope);
        s.distance = s.slope > 0.0 ? (s.b * s.b - 4.0 * square * s.a * s.c) / s.slope : 0.0;
        return s;
    }

    /// Whether q is within `allowed` cells of the arc.
    [[nodiscard]] bool passes(point q, double allowed) const noexcept
    {
        const place s = at(q);
        if (s.a < 0.0 || s.c < 0.0) {  // beyond an end
            const point from_end = q - end_;
            return dot(q, q) <= allowed * allowed || dot(from_end, from_end) <= allowed * allowed;
        }
        return s.distance <= allowed && s.distance >= -allowed;
    }

private:
    point control_;
    point end_;
    double area_;
};

/// The result of conic_fit().
struct fitted_conic {
    grid_point control;
    float weight = 0.0f;  ///< 0: no conic fits
};

/// The greatest distance between a section and its conic, before rounding.
inline constexpr double conic_error = 2.0;

/// Moves the control point along the chord, so that one weight suits both halves of an arc: the greatest error becomes
/// about a third. At its ends, the arc then only nearly touches the section. The control point moves by less than half
/// of each leg: near an end it could get behind it, and the arc would run backwards from there.
[[nodiscard]] inline point balanced(const curve_section& s, point control) noexcept
{
    constexpr double place = 0.19;  // where both halves should agree, so that the error is least between
    const point end = s.p[s.degree], early = s.at(place), late = s.at(1.0 - place);
    const auto difference = [&](double shift) noexcept {
        const conic_arc arc{control + shift * end, end};
        const auto e = arc.at(early), l = arc.at(late);
        return e.b * e.b * (l.a * l.c) - l.b * l.b * (e.a * e.c);
    };
    constexpr double step = 0x1p-10;
    const double before = difference(0.0), slope = (difference(step) - before) / step, shift = -before / slope;
    if (!(shift > -0.0625 && shift < 0.0625)) return control;
    const point by = shift * end, leg = end - control;
    return 4.0 * dot(by, by) < dot(control, control) && 4.0 * dot(by, by) < dot(leg, leg) ? control + by : control;
}

/// The conic through the ends of a section that touches it there, or nearly. A quadratic's is the quadratic itself. A
/// cubic's is compared with the cubic in seven places. The control point is rounded to the grid before the weight is
/// chosen.
///
///     start    the grid point of the section's start
[[nodiscard]] inline fitted_conic fit_conic(const curve_section& s, grid_point start) noexcept
{
    const point end = s.p[s.degree];
    point control = s.p[1];
    if (s.degree == 3) {
        const auto is_zero = [](point d) noexcept { return !(dot(d, d) > 1.0); };
        const point first = is_zero(s.p[1]) ? s.p[2] : s.p[1], last = end - (is_zero(end - s.p[2]) ? s.p[1] : s.p[2]);
        const double turn = cross(first, last);
        const double along = cross(end, last), back = cross(first, end);
        // The legs meet in front of the start and behind the end, and not too far away.
        if (same(turn, 0.0) || !(along / turn > 0.0) || !(back / turn > 0.0)) return {};
        control = (along / turn) * first;
        if (!(dot(control, control) <= 64.0 * dot(end, end))) return {};
        control = balanced(s, control);
    }
    const double x = control.x + static_cast<double>(start.x), y = control.y + static_cast<double>(start.y);
    if (!(std::abs(x) < grid::reach && std::abs(y) < grid::reach)) return {};
    fitted_conic fitted{grid{.cells = 1.0}.snap({x, y}), 1.0f};
    const point rounded = curve_section::exact(fitted.control) - curve_section::exact(start);
    if (same(cross(rounded, end), 0.0)) return {};
    if (s.degree == 2) return fitted;

    conic_arc arc{rounded, end};
    const auto middle = arc.at(s.at(0.5));
    if (!(middle.a > 0.0 && middle.b > 0.0 && middle.c > 0.0)) return {};
    arc.square = middle.b * middle.b / (4.0 * middle.a * middle.c);
    double least = 0.0, most = 1e300;  // the squares that keep the error at every place
    for (int i = 1; i < 8; ++i) {
        const auto place = arc.at(s.at(0.125 * i));
        const double product = 4.0 * place.a * place.c, slack = conic_error * place.slope, square = place.b * place.b;
        if (!(product > 0.0 && place.b > 0.0)) return {};
        least = (square - slack) / product > least ? (square - slack) / product : least;
        most = (square + slack) / product < most ? (square + slack) / product : most;
    }
    const double best = 0.5 * (least + most);
    if (!(least <= most) || !(best > 0x1p-12) || !(best < 0x1p12)) return {};
    // 20 bits: the last bits of a quotient may differ between machines that fuse products and sums.
    float weight = static_cast<float>(std::sqrt(best));
    std::uint32_t bits = 0;
    std::memcpy(&bits, &weight, sizeof bits);
    bits = (bits + 8u) & ~15u;
    std::memcpy(&weight, &bits, sizeof weight);
    fitted.weight = weight;
    return fitted;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
