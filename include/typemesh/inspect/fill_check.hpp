// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The number of compared places, and how many of them are filled wrongly.
struct fill_check {
    std::size_t places = 0;   ///< the number of compared places
    std::size_t skipped = 0;  ///< the number of places on the given contours or curves, or too near to them to decide
    std::size_t wrong = 0;    ///< the number of places filled or left unfilled by mistake
};

/// Compares the area that contours fill under a rule with the region made from them, at grid points in rows: by brute
/// force, from winding numbers.
///
///     given     contours, which may cross in any way
///     kept      the region's loops: filled where their winding number is 1, not filled where it is 0
///     rows      the number of rows, and of places per row, over the box of `given`; all grid points of a small box
///     margin    the least distance of a compared place from all edges of `given`, in cells: 1.5 if crossings are
///               rounded to the grid. Places on an edge are never compared
///
/// Cost   O(rows^2 * n) for n points
[[nodiscard]] inline fill_check check_fill(const std::vector<loop>& given, fill_rule rule,
                                           const std::vector<loop>& kept, std::int32_t rows = 12, double margin = 1.5)
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

/// Compares the area that a region fills with the area that the curves fill, by winding numbers, at random places in
/// the outline's box.
///
///     given      the curves
///     kept       the region's loops
///     allowed    in cells, as for check_distance(); places nearer to a curve are skipped: both answers are right there
///     tries      the number of places
///     seed       equal seeds give equal places
///
/// Cost   O(tries * (n + chords))
[[nodiscard]] inline fill_check check_fill(const curve_chords& given, fill_rule rule, const std::vector<loop>& kept,
                                           double allowed, std::size_t tries = 100, std::uint64_t seed = 1)
{
    fill_check found;
    std::uint64_t state = seed * 0x9E37'79B9'7F4A'7C15u | 1;  // never 0: it would stay 0
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

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
