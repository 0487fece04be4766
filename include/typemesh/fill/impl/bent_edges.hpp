// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/crossing.hpp>
#include <typemesh/fill/impl/swept_edge.hpp>

#include <cstdint>

// Tests with which a sweep that bends edges detects a possible deviation from snap rounding: see resolving_sweep.

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Whether s is the rest of a bent edge, and p is not an end of its contour edge.
[[nodiscard]] inline bool goes_through(const arrangement& a, const segment& s, grid_point p) noexcept
{
    return s.bent != 0 && !(a.loops->points[s.origin] == p) && !(a.loops->points[s.target] == p);
}

/// If a bent edge passes through p, only one other edge may do so: with more, two of them could also cross nearby,
/// undetected.
[[nodiscard]] inline bool is_rough(const arrangement& a, const std::uint32_t* ends, std::uint32_t ending_count,
                                   const std::uint32_t* starts, std::uint32_t starting_count, grid_point p) noexcept
{
    const segment* const all = a.segments;
    bool bends = false;
    for (std::uint32_t i = 0; i < starting_count; ++i) bends |= goes_through(a, all[starts[i]], p);
    if (!bends) return false;
    if (ending_count != 2 || starting_count != 2) return true;
    const std::uint32_t e = all[ends[0]].origin, f = all[ends[1]].origin, g = all[starts[0]].origin,
                        h = all[starts[1]].origin;
    return !((e == g && f == h) || (e == h && f == g));
}

/// Bent edges cross in x, slightly off the contours' crossing. Moves x to the contours' crossing. False if there is
/// none, or if the edges cannot be cut there: they have left the course of snap rounding.
[[nodiscard]] inline bool lead_home(const arrangement& a, const swept_edge& low, const swept_edge& high,
                                    grid_point& x) noexcept
{
    const auto l = a.home(a.segments[low.segment]), h = a.home(a.segments[high.segment]);
    grid_point better;
    if (!crossing_of(l.from, l.to, h.from, h.to, better) || !low.holds(better) || !high.holds(better)) return false;
    x = better;
    return true;
}

/// For two points of one column: an edge that ends or starts in the upper point may come within a cell of the lower
/// point (or the reverse) without the two becoming neighbours on the sweep line.
[[nodiscard]] inline bool is_close_in_column(const arrangement& a, std::uint32_t last_ended, std::uint32_t starting,
                                             grid_point before, grid_point p) noexcept
{
    const auto comes_near = [&](const segment& s, grid_point q) noexcept {
        if (s.to.y >= s.from.y) return false;
        const std::int64_t dx = std::int64_t{s.to.x} - s.from.x, dy = std::int64_t{s.from.y} - s.to.y;
        const std::int64_t side = orientation(s.from, s.to, q);
        return (side < 0 ? -side : side) <= dx + dy;
    };
    if (last_ended != no_number && comes_near(a.segments[last_ended], p)) return true;
    for (std::uint32_t i = starting; i != no_number; i = a.segments[i].next)
        if (comes_near(a.segments[i], before)) return true;
    return false;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
