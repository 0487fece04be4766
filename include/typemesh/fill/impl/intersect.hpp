// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The loops of a region on a grid shared with other regions: a point p lies at p + (x, y), an offset of up to 2^60.
struct placed_loops {
    array_view<const grid_point> points;
    array_view<const std::uint32_t> starts;
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint32_t kind = 0;  ///< regions of different kinds are never grouped: see group_intersection()
};

namespace detail {

/// A position on a shared grid, in 64 bits.
struct placed_point {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

struct placed_box {
    placed_point low, high;

    [[nodiscard]] bool meets(const placed_box& o) const noexcept
    {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
    }
    [[nodiscard]] static placed_box around(placed_point a, placed_point b) noexcept
    {
        return {{a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y}, {a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y}};
    }
};

struct placed_segment {
    placed_point from, to;
    placed_box around;
};

/// Twice the signed area of a, b, c. Budget: points of overlapping boxes, each at most 2^29 wide, differ by at most
/// 2^30; products stay within 2^60, their difference within 2^61.
[[nodiscard]] inline std::int64_t turn(placed_point a, placed_point b, placed_point c) noexcept
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two closed segments share a point.
[[nodiscard]] inline bool meet(const placed_segment& s, const placed_segment& t) noexcept
{
    if (!s.around.meets(t.around)) return false;
    const auto apart = [](std::int64_t a, std::int64_t b) noexcept { return (a > 0 && b > 0) || (a < 0 && b < 0); };
    return !apart(turn(s.from, s.to, t.from), turn(s.from, s.to, t.to)) &&
           !apart(turn(t.from, t.to, s.from), turn(t.from, t.to, s.to));
}

[[nodiscard]] inline placed_point place(const placed_loops& l, std::size_t i) noexcept
{
    return {l.points[i].x + l.x, l.points[i].y + l.y};
}

[[nodiscard]] inline placed_box box_around(const placed_loops& l) noexcept
{
    placed_box all{place(l, 0), place(l, 0)};
    for (std::size_t i = 1; i < l.points.size(); ++i) {
        const placed_point p = place(l, i);
        all.low = {p.x < all.low.x ? p.x : all.low.x, p.y < all.low.y ? p.y : all.low.y};
        all.high = {p.x > all.high.x ? p.x : all.high.x, p.y > all.high.y ? p.y : all.high.y};
    }
    return all;
}

/// Calls use(segment) for every edge, until it returns true.
template <class Use>
bool any_edge(const placed_loops& l, Use&& use) noexcept
{
    for (std::size_t loop = 0; loop + 1 < l.starts.size(); ++loop) {
        const std::uint32_t first = l.starts[loop], end = l.starts[loop + 1];
        placed_point from = place(l, end - 1);
        for (std::uint32_t i = first; i < end; ++i) {
            const placed_point to = place(l, i);
            if (use(placed_segment{from, to, placed_box::around(from, to)})) return true;
            from = to;
        }
    }
    return false;
}

/// Whether p is inside; p lies in the loops' box but on no edge. An upward ray from inside crosses the loops an odd
/// number of times.
[[nodiscard]] inline bool holds(const placed_loops& l, placed_point p) noexcept
{
    bool inside = false;
    any_edge(l, [&](const placed_segment& s) noexcept {
        if ((s.from.x <= p.x) != (s.to.x <= p.x)) {
            const std::int64_t side = turn(s.from, s.to, p);
            if (s.from.x < s.to.x ? side < 0 : side > 0) inside = !inside;
        }
        return false;
    });
    return inside;
}

/// Whether a loop of `inner` begins inside `outer`; their edges do not meet.
[[nodiscard]] inline bool any_loop_inside(const placed_loops& inner, const placed_loops& outer,
                                          const placed_box& outer_box) noexcept
{
    for (std::size_t loop = 0; loop + 1 < inner.starts.size(); ++loop) {
        const placed_point p = place(inner, inner.starts[loop]);
        if (outer_box.meets({p, p}) && holds(outer, p)) return true;
    }
    return false;
}

}  // namespace detail

/// Whether two regions share a point, even if only one of their boundaries:
///
///     +---+              +---------+            +---------+
///     | +-+-+   +--+--+  |  +--+   |    not:    |  +---+  |    A hole is outside, so a region that stands in it
///     | +-+-+   +--+--+  |  +--+   |            |  |+-+|  |    without touching its boundary does not meet
///     +---+              +---------+            |  |+-+|  |    the region around it.
///                                               +--+---+--+
///
/// Fails  error::out_of_memory
/// Cost   O(a + b), plus the product of the numbers of edges that reach into the other region's box
/// Exact  in 64 bits: see detail::turn
[[nodiscard]] inline result<bool> meet(const placed_loops& a, const placed_loops& b, workspace& space) noexcept
{
    if (a.points.empty() || b.points.empty()) return false;
    const detail::placed_box box_a = detail::box_around(a), box_b = detail::box_around(b);
    if (!box_a.meets(box_b)) return false;

    workspace::scope scratch{space};
    auto* within_b = scratch.take<detail::placed_segment>(a.points.size());
    if (within_b == nullptr) return error::out_of_memory;
    std::size_t count = 0;
    detail::any_edge(a, [&](const detail::placed_segment& s) noexcept {
        if (s.around.meets(box_b)) within_b[count++] = s;
        return false;
    });
    const bool cross = detail::any_edge(b, [&](const detail::placed_segment& t) noexcept {
        if (!t.around.meets(box_a)) return false;
        for (std::size_t i = 0; i < count; ++i)
            if (detail::meet(within_b[i], t)) return true;
        return false;
    });
    return cross || detail::any_loop_inside(a, b, box_b) || detail::any_loop_inside(b, a, box_a);
}

}  // namespace typemesh::inline TYPEMESH_ABI
