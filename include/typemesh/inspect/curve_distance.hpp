// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/inspect/curve_chords.hpp>
#include <typemesh/inspect/fill_check.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inspect {

/// How far a region's boundary is from the curves that it stands for, in cells (region::grid().cells a font unit).
struct curve_distance {
    std::size_t places = 0;  ///< that were looked at: every point, and the middle of every edge
    std::size_t strays = 0;  ///< those farther than was allowed from all curves
    double farthest = 0.0;   ///< of what is allowed: from the curve that the edge says it comes from, where that is near
                             ///< enough, else from the nearest. Of strays: from the nearest
};

/// Holds every point of the boundary, and every edge's middle, against the curves.
///
///     allowed    in cells. The tolerance that the region was made with, and 1 % of it for the chords that stand for the
///                curves, and 1.5 cells where contours cross (see docs/guarantees.md)
///
/// Cost   O(n) where edges lie by the curves that they name, O(n * chords) where they do not
[[nodiscard]] inline curve_distance check_distance(const region& r, const curve_chords& curves, double allowed)
{
    curve_distance found;
    for (std::uint32_t l = 0; l < r.loop_count(); ++l) {
        const std::uint32_t begin = r.starts()[l], end = r.starts()[l + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const grid_point p = r.points()[i], q = r.points()[i + 1 < end ? i + 1 : begin];
            for (const double share : {0.0, 0.5}) {
                const point at{p.x + share * (double(q.x) - p.x), p.y + share * (double(q.y) - p.y)};
                double squared = curve_chords::squared_distance(at, curves.of_curve(r.edges()[i].curve));
                if (squared > allowed * allowed) squared = curve_chords::squared_distance(at, curves.all());
                ++found.places;
                if (squared > allowed * allowed) ++found.strays;
                found.farthest = (std::max)(found.farthest, std::sqrt(squared));
            }
        }
    }
    return found;
}

/// Compares what a region fills with what the curves themselves do, by their winding numbers, at places at random in the
/// outline's box.
///
///     given      the curves
///     kept       the region's loops
///     allowed    in cells, as above: what lies nearer to a curve is skipped, for either answer is right there
///     tries      how many places
///     seed       the same seed gives the same places
///
/// Cost   O(tries * (n + chords))
[[nodiscard]] inline fill_check check_fill(const curve_chords& given, fill_rule rule, const std::vector<loop>& kept,
                                           double allowed, std::size_t tries = 100, std::uint64_t seed = 1)
{
    fill_check found;
    std::uint64_t state = seed * 0x9E37'79B9'7F4A'7C15u + 1;
    const auto fraction = [&] {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    const box& around = given.bounds();
    if (around.empty()) return found;
    for (std::size_t i = 0; i < tries; ++i) {
        const double x = around.low.x + fraction() * around.width(), y = around.low.y + fraction() * around.height();
        const grid_point p{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
        const point at{double(p.x), double(p.y)};
        if (!(curve_chords::squared_distance(at, given.all()) > allowed * allowed)) {
            ++found.skipped;
            continue;
        }
        ++found.places;
        if (winding(kept, p) != (is_filled(rule, given.winding(at)) ? 1 : 0)) ++found.wrong;
    }
    return found;
}

}  // namespace typemesh::inspect
