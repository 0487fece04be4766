// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The facts about a loop that outer_of() needs.
struct loop_extent {
    grid_point low, high;     // its box
    std::uint32_t leftmost;   // its lexicographically smallest point
    std::int64_t twice_area;  // negative for a hole
};

[[nodiscard]] inline loop_extent extent_of(const region& r, std::uint32_t loop) noexcept
{
    const auto points = r.points();
    const std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1];
    loop_extent made{points[first], points[first], first, 0};
    std::uint64_t area = 0;  // partial sums may wrap; the total, below 2^59, cannot
    grid_point before = points[end - 1];
    for (std::uint32_t i = first; i < end; ++i) {
        const grid_point p = points[i];
        const grid_point least = points[made.leftmost];
        if (p.x < least.x || (p.x == least.x && p.y < least.y)) made.leftmost = i;
        made.low = {p.x < made.low.x ? p.x : made.low.x, p.y < made.low.y ? p.y : made.low.y};
        made.high = {p.x > made.high.x ? p.x : made.high.x, p.y > made.high.y ? p.y : made.high.y};
        area += static_cast<std::uint64_t>(std::int64_t{before.x} * p.y - std::int64_t{before.y} * p.x);
        before = p;
    }
    made.twice_area = static_cast<std::int64_t>(area);
    return made;
}

/// Whether the loop winds around the points just left of p. Counts the edges that the ray from there to the left
/// crosses; the lower end of an edge counts as part of the edge, the upper end does not.
[[nodiscard]] inline bool winds_left_of(const region& r, std::uint32_t loop, grid_point p) noexcept
{
    const auto points = r.points();
    const std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1];
    bool inside = false;
    grid_point a = points[end - 1];
    for (std::uint32_t i = first; i < end; ++i) {
        const grid_point b = points[i];
        if ((a.y <= p.y) != (b.y <= p.y)) {
            const auto side = orientation(a, b, p);
            inside ^= a.y < b.y ? side < 0 : side > 0;  // p lies right of the edge
        }
        a = b;
    }
    return inside;
}

}  // namespace detail

/// The outer loop of each loop in a region: out[k] is the number of the outer loop that bounds the same component of
/// the interior as loop k. The result for an outer loop is its own number.
///
///     +----0----------------+
///     |  +--1--+  +--2--+   |      out = 0, 0, 0, 3: loop 3 is an island in the hole 2
///     |  |     |  | [3] |   |
///     |  +-----+  +-----+   |
///     +---------------------+
///
///     out    r.loop_count() numbers
///
/// The interior around a hole lies just left of the hole's leftmost point, even if the hole touches other loops there.
/// The hole belongs to the smallest of all outer loops around this place.
///
/// Fails  error::out_of_memory
/// Cost   O(n). Each hole is also tested against all boxes, and against the points of the outer loops whose boxes
///        contain the hole; if there is only one outer loop, neither test is needed
/// Space  32 bytes per loop from `space`
/// Exact  in 64 bits
[[nodiscard]] inline result<void> outer_of(const region& r, workspace& space, array_view<std::uint32_t> out) noexcept
{
    const std::uint32_t count = r.loop_count();
    TYPEMESH_ASSERT(out.size() == count, "outer_of() needs room for one number for each loop");
    workspace::scope scratch{space};
    auto* const extents = scratch.take<detail::loop_extent>(count);
    if (extents == nullptr) return error::out_of_memory;
    std::uint32_t last_outer = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        extents[k] = detail::extent_of(r, k);
        if (extents[k].twice_area > 0) last_outer = k;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        const detail::loop_extent& mine = extents[k];
        out[k] = mine.twice_area > 0 ? k : last_outer;
        if (mine.twice_area > 0 || r.outers() == 1) continue;
        const grid_point p = r.points()[mine.leftmost];
        std::int64_t smallest = 0;
        for (std::uint32_t o = 0; o < count; ++o) {
            const detail::loop_extent& other = extents[o];
            const bool smaller = other.twice_area > 0 && (smallest == 0 || other.twice_area < smallest);
            const bool around = other.low.x < p.x && other.low.y <= p.y && other.high.x >= p.x && other.high.y >= p.y;
            if (!smaller || !around || !detail::winds_left_of(r, o, p)) continue;
            smallest = other.twice_area;
            out[k] = o;
        }
    }
    return error::none;
}

}  // namespace typemesh::inline TYPEMESH_ABI
