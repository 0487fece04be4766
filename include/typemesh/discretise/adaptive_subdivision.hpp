// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/discretise/discretiser.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The recursive subdivision of the thesis, exactly as published. Use it to reproduce the meshes of the thesis.
///
///          P2 ______ P3         A curve is halved. A half becomes a line if
///           /  ----  \            - its segments P1-P4 and P2-P3 come closer to each other than `distance`, or
///          / /  M   \ \           - the lines P1-M and M-P4 through its midpoint turn by less than `angle`, or
///        P1 ---------- P4         - it is the result of the `levels`-th halving.
///                               Otherwise it is halved again. The whole curve is always halved once.
///
/// Quadratics are raised to cubics first. The tolerance argument is ignored, and no tolerance is kept: an S-shaped half
/// whose segments cross becomes a line at once, and so does a half that looks straight at its midpoint. `best` promises
/// 0.005 of 64 units. On real fonts, the worst chord is off by 37 times that for cubics and by 5 times for quadratics.
/// `certified` keeps its tolerance.
///
/// Values of t are exact (multiples of 2^-levels). A curve gets at most 2^levels points, and degenerate curves get
/// fewer.
///
/// From "Study of mesh generation and optimization techniques applied to parametric forms", J. Vandenbergh, 2020.
struct adaptive_subdivision {
    static constexpr bool keeps_no_tolerance = true;
    static constexpr std::uint32_t max_levels = 20;  ///< larger `levels` are clamped to this

    /// A length without a default, because a value that suits 64 units per em is 32 times too fine for 2048 units per
    /// em.
    struct stated {
        double value;

        constexpr stated(double in_curve_units) noexcept : value{in_curve_units} {}
        constexpr operator double() const noexcept { return value; }
    };

    std::uint32_t levels = 5;  ///< the greatest number of halvings, r in the thesis; 0 counts as 1
    stated distance;           ///< a length in the curve's own unit: font units
    double angle = 0.01;       ///< an angle in radians

    // The presets of the thesis, which uses 64 units per em. Its "low" is two_lines; thesis_quality has all four.
    /// The presets of the thesis, for curves in font units.
    [[nodiscard]] static adaptive_subdivision normal(double units_per_em) noexcept
    {
        return {5, 0.5 / 64.0 * units_per_em, 0.01};
    }
    [[nodiscard]] static adaptive_subdivision high(double units_per_em) noexcept
    {
        return {15, 0.1 / 64.0 * units_per_em, 0.01};
    }
    [[nodiscard]] static adaptive_subdivision best(double units_per_em) noexcept
    {
        return {15, 0.005 / 64.0 * units_per_em, 0.01};
    }

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {levels, distance.value, angle}; }

    template <class Put>
    void operator()(const quadratic& q, double tolerance, Put&& put) const noexcept
    {
        (*this)(raised(q), tolerance, put);
    }

    template <class Put>
    void operator()(const cubic& q, double, Put&& put) const noexcept
    {
        struct piece {
            cubic q;
            std::uint32_t level;  // halvings so far
        };
        const std::uint32_t deepest = levels < 1 ? 1 : levels > max_levels ? max_levels : levels;
        piece waiting[max_levels + 1];  // right halves, the next one last
        std::uint32_t count = 0;
        waiting[count++] = {q, 0};
        double t = 0.0;
        while (count != 0) {
            const piece p = waiting[--count];
            if (p.level != 0 && (p.level == deepest || is_line(p.q))) {
                t += 1.0 / static_cast<double>(1u << p.level);
                put(p.q.p3, t);
                continue;
            }
            const point a = middle(p.q.p0, p.q.p1), b = middle(p.q.p1, p.q.p2), c = middle(p.q.p2, p.q.p3);
            const point ab = middle(a, b), bc = middle(b, c), m = middle(ab, bc);
            waiting[count++] = {{m, bc, c, p.q.p3}, p.level + 1};
            waiting[count++] = {{p.q.p0, a, ab, m}, p.level + 1};
        }
    }

private:
    [[nodiscard]] static point middle(point a, point b) noexcept { return 0.5 * (a + b); }

    [[nodiscard]] bool is_line(const cubic& q) const noexcept
    {
        if (segment_distance(q.p0, q.p3, q.p1, q.p2) < distance) return true;
        const point m = 0.125 * (q.p0 + q.p3) + 0.375 * (q.p1 + q.p2);
        const point in = m - q.p0, out = q.p3 - m;
        return std::atan2(std::abs(cross(in, out)), dot(in, out)) < angle;
    }

    [[nodiscard]] static double point_distance(point p, point a, point b) noexcept
    {
        const point d = b - a;
        const double dd = dot(d, d);
        double s = dd > 0.0 ? dot(p - a, d) / dd : 0.0;
        s = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
        return length(p - a - s * d);
    }

    [[nodiscard]] static double segment_distance(point a, point b, point c, point d) noexcept
    {
        const bool apart_cd = (cross(b - a, c - a) < 0.0) != (cross(b - a, d - a) < 0.0);
        const bool apart_ab = (cross(d - c, a - c) < 0.0) != (cross(d - c, b - c) < 0.0);
        const double ends[4] = {point_distance(c, a, b), point_distance(d, a, b), point_distance(a, c, d),
                                point_distance(b, c, d)};
        if (apart_cd && apart_ab) return 0.0;
        double least = ends[0];
        for (const double e : ends) least = e < least ? e : least;
        return least;
    }
};
static_assert(discretiser<adaptive_subdivision>);

}  // namespace typemesh::inline TYPEMESH_ABI
