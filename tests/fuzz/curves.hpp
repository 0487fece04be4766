// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/segments.hpp"

#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/thesis_quality.hpp>
#include <typemesh/discretise/two_lines.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A curve -> each discretiser.
namespace fuzz {

namespace curve_laws {

using namespace typemesh;

using test::emitted;
using test::points_of;

/// The size of the numbers that a curve is computed from.
inline double size_of(const curve& c)
{
    double size = 0.0;
    for (std::uint32_t i = 0; i <= c.degree; ++i) size = (std::max)({size, std::fabs(c.p[i].x), std::fabs(c.p[i].y)});
    return size;
}

/// Laws of every discretiser: t ascends, the curve's end comes last, and the points lie on the curve.
inline broken_law of_points(const std::vector<emitted>& points, const curve& c)
{
    if (points.empty()) return "no point";
    if (points.back().t < 1.0 || !(points.back().p == c.end())) return "the last point is not the curve's end";
    double t = 0.0;
    for (const emitted& e : points) {
        if (!(e.t > t) || e.t > 1.0) return "t does not ascend";
        if (!(length(e.p - c.at(e.t)) <= 1e-12 * size_of(c))) return "a point is off the curve";
        t = e.t;
    }
    return {};
}

/// Samples between two points are within the tolerance of their chord.
inline broken_law of_chords(const std::vector<emitted>& points, const curve& c, double tolerance)
{
    emitted before{c.start(), 0.0};
    const int samples = points.size() > 200 ? 8 : 48;
    for (const emitted& e : points) {
        for (int i = 1; i < samples; ++i) {
            const double t = before.t + (e.t - before.t) * i / samples;
            const double off = test::distance_to_segment(c.at(t), before.p, e.p);
            if (!(off <= tolerance)) return "a chord is off by " + std::to_string(off / tolerance) + " tolerances";
        }
        before = e;
    }
    return {};
}

/// Wang's bound, from below: no curve needs more equal steps of t.
inline double steps_by_wang(const curve& c, double tolerance)
{
    double bend = 0.0;
    for (std::uint32_t k = 0; k + 2 <= c.degree; ++k)
        bend = (std::max)(bend, length(c.p[k] - 2.0 * c.p[k + 1] + c.p[k + 2]));
    return std::ceil(std::sqrt(c.degree * (c.degree - 1) * bend / (8.0 * tolerance)));
}

/// On a grid of 16, of 256, of whole numbers, or with fractions; points may coincide or lie on a line.
inline curve read_curve(values& in)
{
    curve c;
    const std::uint32_t bits = in.byte();
    c.degree = 2 + (bits & 1);
    const auto coordinate = [&]() -> double {
        switch ((bits >> 1) & 3) {
        case 0: return double(in.byte() & 15) - 8.0;
        case 1: return double(in.byte()) - 128.0;
        case 2: return double(in.bits(2)) - 32768.0;
        default: return (double(in.bits(4)) - 0x1p31) * 0x1p-19;
        }
    };
    for (std::uint32_t i = 0; i <= c.degree; ++i) {
        c.p[i].x = coordinate();
        c.p[i].y = coordinate();
        if (i > 0 && (bits & 8) != 0) c.p[i] = c.p[i - 1] + (1.0 / 4096) * c.p[i];  // next to the one before
    }
    const double scale = (bits & 16) != 0 ? std::ldexp(1.0, static_cast<int>(in.byte() % 80) - 40) : 1.0;
    for (point& p : c.p) p = scale * p;
    return c;
}

}  // namespace curve_laws

inline broken_law curves(values in)
{
    using namespace typemesh;
    using namespace curve_laws;
    const curve c = read_curve(in);
    const double size = size_of(c);
    if (!(size > 0.0)) return {};
    const double tolerance = size * std::ldexp(in.between(0.5, 1.0), -static_cast<int>(in.byte() % 24));
    const auto points = points_of(certified{}, c, tolerance);
    if (broken_law broken = of_points(points, c); !broken.empty()) return "certified: " + broken;
    if (broken_law broken = of_chords(points, c, tolerance); !broken.empty()) return "certified: " + broken;
    constexpr double max_corners = 4.0;
    if (double(points.size()) > (std::max)(1.0, steps_by_wang(c, 0.999 * tolerance)) + max_corners)
        return "certified: more points than Wang's bound";

    if (broken_law broken = of_points(points_of(two_lines{}, c, tolerance), c); !broken.empty())
        return "two_lines: " + broken;
    const adaptive_subdivision halved{in.below(9), size * in.between(1e-4, 0.5), in.between(0.001, 0.5)};
    const auto halvings = points_of(halved, c, tolerance);
    if (broken_law broken = of_points(halvings, c); !broken.empty()) return "adaptive_subdivision: " + broken;
    if (halvings.size() > std::size_t{1} << (std::max)(1u, halved.levels))
        return "adaptive_subdivision: too many points";
    const thesis_quality thesis{static_cast<thesis_quality::preset>(in.below(4)), size};
    if (broken_law broken = of_points(points_of(thesis, c, tolerance), c); !broken.empty())
        return "thesis_quality: " + broken;
    return {};
}

}  // namespace fuzz
