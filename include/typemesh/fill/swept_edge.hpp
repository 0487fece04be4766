// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An edge while the sweep line crosses it.
struct alignas(32) swept_edge {
    grid_point from, to;
    std::uint32_t segment = no_number;
    std::int32_t above = 0;  ///< the winding number right above it

    bool is_bent = false;  ///< in this sweep: bending it again takes another one

    void begin(grid_point a, grid_point b, std::uint32_t s, std::int32_t winding) noexcept
    {
        from = a;
        to = b;
        segment = s;
        above = winding;
        is_bent = false;
    }

    /// |orientation(from, to, p)| of a point one cell away in x and y. Below 2^31; from is left of to.
    [[nodiscard]] std::int64_t reach() const noexcept
    {
        const std::int64_t dy = std::int64_t{to.y} - from.y;
        return std::int64_t{to.x} - from.x + (dy < 0 ? -dy : dy);
    }

    /// Whether p lies in its box.
    [[nodiscard]] bool holds(grid_point p) const noexcept
    {
        if (p.x < from.x || p.x > to.x) return false;
        return from.y < to.y ? p.y >= from.y && p.y <= to.y : p.y <= from.y && p.y >= to.y;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
