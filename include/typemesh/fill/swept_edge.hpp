// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <cstdint>

namespace typemesh::detail {

/// An edge while the sweep line crosses it.
struct swept_edge {
    grid_point from, to;
    std::uint32_t stretch = no_number;  ///< no_number: the slot is free
    std::int32_t above = 0;             ///< the winding number right above it
    std::uint32_t margin = 0;           ///< orientation(from, to, p) of a point p two cells away, at least; up to 2^31
    bool tight = false;                 ///< a point came nearer than that
    bool bent = false;

    swept_edge() noexcept = default;
    swept_edge(grid_point a, grid_point b, std::uint32_t s, std::int32_t winding) noexcept
        : from{a}, to{b}, stretch{s}, above{winding}
    {
        const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
        margin = 2 * (static_cast<std::uint32_t>(dx) + static_cast<std::uint32_t>(dy < 0 ? -dy : dy));
    }

    /// Takes note of a point that lies beside it.
    void come_near(grid_point p) noexcept
    {
        const std::int64_t side = orientation(from, to, p);
        tight |= (side < 0 ? -side : side) <= margin;
    }

    /// Whether p lies in its box.
    [[nodiscard]] bool holds(grid_point p) const noexcept
    {
        if (p.x < from.x || p.x > to.x) return false;
        return from.y < to.y ? p.y >= from.y && p.y <= to.y : p.y <= from.y && p.y >= to.y;
    }

    /// Whether it lies below an edge that ends in the same point.
    [[nodiscard]] bool ends_below(const swept_edge& other) const noexcept
    {
        return lexicographic_less(from, other.from) ? orientation(from, to, other.from) > 0
                                                    : orientation(other.from, other.to, from) < 0;
    }
};

}  // namespace typemesh::detail
