// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inspect {

/// Places that were tried, and whether the right ones are filled.
struct fill_check {
    std::size_t places = 0;  ///< that were compared
    std::size_t skipped = 0; ///< that lie on what was given, or too near to it to tell
    std::size_t wrong = 0;   ///< filled and should not be, or the other way round
};

/// Compares what contours fill under a rule with the region that was made of them, at grid points in rows: by brute force,
/// from the winding numbers.
///
///     given     contours, which may cross as they like
///     kept      the region's loops: filled where they run round a place once, not filled where they do not
///     rows      so many rows of so many places, over the box of `given`; where that is small, all its grid points
///     margin    how far from all edges of `given` a place must be to be compared, in cells: 1.5 where crossings are
///               rounded to the grid. Places on an edge are never compared
///
/// Cost   O(rows^2 * n) for n points
[[nodiscard]] inline fill_check check_fill(const std::vector<loop>& given, fill_rule rule, const std::vector<loop>& kept,
                                           std::int32_t rows = 12, double margin = 1.5)
{
    std::int32_t left = 1 << 29, right = -left, bottom = left, top = -left;
    for (const loop l : given) {
        for (const grid_point p : l) {
            left = (std::min)(left, p.x);
            right = (std::max)(right, p.x);
            bottom = (std::min)(bottom, p.y);
            top = (std::max)(top, p.y);
        }
    }
    fill_check found;
    if (right < left || rows < 1) return found;
    const auto steps = [rows](std::int32_t low, std::int32_t high) { return (std::min)(rows, high - low + 1); };
    const auto at = [rows](std::int32_t low, std::int32_t high, std::int32_t i) {
        return high - low < rows ? low + i : low + static_cast<std::int32_t>(std::int64_t{high - low} * i / rows);
    };
    const std::int32_t columns = steps(left, right), lines = steps(bottom, top);
    for (std::int32_t i = 0; i < columns; ++i) {
        for (std::int32_t k = 0; k < lines; ++k) {
            const grid_point p{at(left, right, i), at(bottom, top, k)};
            const double away = distance(given, p);
            if (!(away > 0.0) || away < margin) {
                ++found.skipped;
                continue;
            }
            ++found.places;
            if (winding(kept, p) != (is_filled(rule, winding(given, p)) ? 1 : 0)) ++found.wrong;
        }
    }
    return found;
}

}  // namespace typemesh::inspect
