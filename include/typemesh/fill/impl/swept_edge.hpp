// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/fill/impl/arrangement.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An edge while the sweep line crosses it.
struct alignas(32) swept_edge {
    grid_point from, to;
    std::uint32_t segment = no_number;
    std::int32_t above = 0;  ///< the winding number right above it

    bool is_bent = false;  ///< in this sweep; bending it again requires another sweep

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

    /// Whether p lies in the edge's box.
    [[nodiscard]] bool holds(grid_point p) const noexcept
    {
        if (p.x < from.x || p.x > to.x) return false;
        return from.y < to.y ? p.y >= from.y && p.y <= to.y : p.y <= from.y && p.y >= to.y;
    }
};

/// The distance at which the one of two neighbours that ends first does so from the other.
struct clearance {
    std::int64_t side;   ///< orientation(): positive on its own side
    std::int64_t reach;  ///< of the other edge
};
[[nodiscard]] inline clearance clearance_of(const swept_edge& low, const swept_edge& high) noexcept
{
    const bool low_first = sweep_place(low.to) < sweep_place(high.to);
    const swept_edge* const both[2] = {&high, &low};  // a branch would often be mispredicted
    const swept_edge &shorter = *both[low_first], &longer = *both[!low_first];
    const std::int64_t turn = orientation(longer.from, longer.to, shorter.to);
    return {(turn ^ -std::int64_t{low_first}) + low_first, longer.reach()};  // low_first ? -turn : turn
}
/// Whether this distance exceeds a cell.
[[nodiscard]] inline bool is_far(const swept_edge& low, const swept_edge& high) noexcept
{
    const auto [side, reach] = clearance_of(low, high);
    return side > reach;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
