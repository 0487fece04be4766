// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/core/sweep_order.hpp>

#include <cstdint>

namespace typemesh {

/// An edge as it leaves or reaches a point through which closed polylines come more than once.
struct spoke {
    std::int32_t x, y;    // from the point to the edge's other end: not both 0, each at most 2^29 in size
    std::uint32_t visit;  // of the point
    bool goes_out;

    [[nodiscard]] static spoke to(grid_point other_end, grid_point p, std::uint32_t visit, bool goes_out) noexcept
    {
        return {other_end.x - p.x, other_end.y - p.y, visit, goes_out};
    }

    /// Right half, upward vertical included, before left half.
    [[nodiscard]] bool is_left() const noexcept { return x < 0 || (x == 0 && y < 0); }
    /// Exact: products of at most 2^58.
    [[nodiscard]] std::int64_t cross(const spoke& other) const noexcept
    {
        return std::int64_t{x} * other.y - std::int64_t{y} * other.x;
    }
    [[nodiscard]] bool before(const spoke& other) const noexcept
    {
        return is_left() != other.is_left() ? other.is_left() : cross(other) > 0;
    }
};

/// Puts all spokes of a point in counter-clockwise order, so that spokes[2 i], which goes out, and spokes[2 i + 1],
/// which comes in, have a wedge of interior between them.
///
///            3 in
///             |  ::: 2 out        False where edges do not bound wedges, with the interior on the left of all: two
///     --------p--------- 0 out    run in one direction, or in and out do not take turns. O(count log count)
///      ::::  / :::::::: ...
///           1 in
[[nodiscard]] inline bool sort_into_wedges(spoke* spokes, std::size_t count) noexcept
{
    if (count <= 16)
        detail::insertion_sort(spokes, count);
    else
        detail::heap_sort(spokes, count);
    if (!spokes[0].goes_out) {
        const spoke first = spokes[0];
        for (std::size_t i = 1; i < count; ++i) spokes[i - 1] = spokes[i];
        spokes[count - 1] = first;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const spoke &here = spokes[i], &next = spokes[i + 1 < count ? i + 1 : 0];
        if (here.goes_out != (i % 2 == 0)) return false;
        if (!here.before(next) && !next.before(here)) return false;
    }
    return true;
}

}  // namespace typemesh
