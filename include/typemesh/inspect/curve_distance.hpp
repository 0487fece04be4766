// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The distance of a region's boundary from its curves, in cells (region::grid().cells per font unit).
struct curve_distance {
    std::size_t places = 0;  ///< the number of tested places: every point, and the midpoint of every edge
    std::size_t strays = 0;  ///< the number of places that are farther than allowed from all curves
    double farthest = 0.0;   ///< the largest distance to the curve that the edge names, or, where this is more than
                             ///< allowed, to the nearest curve
};

/// Measures the distance of every boundary point, and of every edge's midpoint, from the curves.
///
///     allowed    in cells: the tolerance of the region, plus 1 % of it for the chords that stand for the curves, plus
///                1.5 cells if contours cross (see docs/guarantees.md)
///
/// Cost   O(n) if edges lie near the curves that they name, O(n * chords) if they do not
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

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
