// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An edge at a point that closed polylines pass through more than once, seen from that point.
struct outgoing_edge {
    std::int32_t x, y;    // from the point to the edge's other end: not both 0, each at most 2^29 in size
    std::uint32_t visit;  // the visit of the point that the edge belongs to
    bool goes_out;

    [[nodiscard]] static outgoing_edge to(grid_point other_end, grid_point p, std::uint32_t visit,
                                          bool goes_out) noexcept
    {
        return {other_end.x - p.x, other_end.y - p.y, visit, goes_out};
    }

    /// The right half-plane, upward vertical included, comes before the left one.
    [[nodiscard]] bool is_left() const noexcept { return x < 0 || (x == 0 && y < 0); }
    /// Exact: products of at most 2^58.
    [[nodiscard]] std::int64_t cross(const outgoing_edge& other) const noexcept
    {
        return std::int64_t{x} * other.y - std::int64_t{y} * other.x;
    }
    [[nodiscard]] bool before(const outgoing_edge& other) const noexcept
    {
        return is_left() != other.is_left() ? other.is_left() : cross(other) > 0;
    }
};

/// Sorts all edges at a point counter-clockwise: edges[2 i] goes out, edges[2 i + 1] comes in, and a sector of interior
/// lies between them.
///
///            3 in
///             |  ::: 2 out        False if the edges do not bound sectors with the interior on the left of each edge:
///     --------p--------- 0 out    two edges have one direction, or out and in do not alternate. O(count log count)
///      ::::  / :::::::: ...
///           1 in
[[nodiscard]] inline bool sort_into_sectors(outgoing_edge* edges, std::size_t count) noexcept
{
    if (count <= 16)
        detail::insertion_sort(edges, count);
    else
        detail::heap_sort(edges, count);
    if (!edges[0].goes_out) {
        const outgoing_edge first = edges[0];
        for (std::size_t i = 1; i < count; ++i) edges[i - 1] = edges[i];
        edges[count - 1] = first;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const outgoing_edge &here = edges[i], &next = edges[i + 1 < count ? i + 1 : 0];
        if (here.goes_out != (i % 2 == 0)) return false;
        if (!here.before(next) && !next.before(here)) return false;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
