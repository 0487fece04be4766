// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The first and the last of some rows or columns, or the lower and the upper end of an interval. Empty if the last is
/// less than the first.
struct interval {
    std::int64_t first, last;
};

/// Visits the squares of a grid that a segment or a triangle may touch, row by row and from left to right, until
/// visit(column, row) returns false. Returns its last result.
///
///     +-------+-------+-------+       A row's squares lie between the smallest and the largest x that the sides have
///     |       |       |   . ' |       in the row. So there may be squares that only the row's span passes through,
///     |       |   . - ' - . - |       but none of a convex shape is missing.
///     +-------+-'-----+-------+
///     |   . ' |       |       |       in.rows_between(bottom, top)       the rows of these y: an interval
///     | '     |       |       |       in.height_of(row)                  the row's lowest and highest y
///     +-------+-------+-------+       in.columns_between(left, right)    the columns of these x
///
/// Spans are a cell wider than the sides at either end, because divisions round.
///
/// Cost   O(1) for each row and for each square
template <class Squares, std::size_t count, class Visit>
[[nodiscard]] bool walk_rows(const Squares& in, const grid_point (&corners)[count], Visit&& visit) noexcept
{
    constexpr std::int64_t beyond_all = std::int64_t{1} << 40;  // places lie within 2^28
    // x where the segment from p to q has this y, which is clamped to the segment; moved by up to a cell.
    const auto x_at = [](grid_point p, grid_point q, std::int64_t y) noexcept {
        const std::int64_t low = p.y < q.y ? p.y : q.y, high = p.y < q.y ? q.y : p.y;
        y = y < low ? low : y > high ? high : y;
        if (low == high) return std::int64_t{p.x};
        return p.x + (std::int64_t{q.x} - p.x) * (y - p.y) / (std::int64_t{q.y} - p.y);
    };
    std::int64_t bottom = corners[0].y, top = bottom;
    for (const grid_point c : corners) {
        bottom = c.y < bottom ? c.y : bottom;
        top = c.y > top ? c.y : top;
    }
    const interval rows = in.rows_between(bottom, top);
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
        const interval y = in.height_of(row);
        std::int64_t left = beyond_all, right = -beyond_all;
        const auto widen = [&](std::int64_t x) noexcept {
            left = x - 1 < left ? x - 1 : left;
            right = x + 1 > right ? x + 1 : right;
        };
        for (std::size_t i = 0; i < count; ++i) {
            const grid_point p = corners[i], q = corners[i + 1 < count ? i + 1 : 0];
            if ((p.y < q.y ? p.y : q.y) > y.last || (p.y < q.y ? q.y : p.y) < y.first) continue;
            widen(p.y == q.y ? q.x : x_at(p, q, y.first));
            widen(x_at(p, q, y.last));
        }
        const interval columns = in.columns_between(left, right);
        for (std::int64_t column = columns.first; column <= columns.last; ++column)
            if (!visit(column, row)) return false;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
