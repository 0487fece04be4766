// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The faults that keep loops from being the boundary cycles of an area (see region.hpp). Loops may touch in points;
/// there each pass must stay in its own sector of interior. Every faulty pair of edges is counted.
struct boundary_check {
    std::size_t short_loops = 0;      ///< the number of loops with fewer than three points
    std::size_t repeated_points = 0;  ///< how often a point occurs twice in a row
    std::size_t spikes = 0;           ///< how often a loop doubles back
    std::size_t crossings = 0;        ///< the number of pairs of edges that cross, or touch outside a common end
    std::size_t overlaps = 0;         ///< the number of pairs of edges that are equal or overlap
    std::size_t strays = 0;           ///< the number of pairs of edges at a common point where a cycle leaves its
                                      ///< sector

    /// A description of the first fault; "" if there is none.
    [[nodiscard]] constexpr const char* broken() const noexcept
    {
        if (short_loops != 0) return "a loop has fewer than three points";
        if (repeated_points != 0) return "a point is repeated";
        if (spikes != 0) return "a spike";
        if (crossings != 0) return "two edges cross, or touch elsewhere than in a common end";
        if (overlaps != 0) return "two edges overlap";
        if (strays != 0) return "a boundary cycle leaves its sector";
        return "";
    }
};

namespace detail {

/// Whether direction d, seen from p, lies strictly between a and b, counter-clockwise from a. If a and b are one
/// direction, every other direction does.
[[nodiscard]] constexpr bool turns_through(grid_point p, grid_point a, grid_point d, grid_point b) noexcept
{
    const auto sector = [&](grid_point q) noexcept {  // 0: along a, 1: left of it, 2: against it, 3: right of it
        const int s = side(p, a, q);
        if (s != 0) return s > 0 ? 1 : 3;
        const std::int64_t x = (std::int64_t{a.x} - p.x) * (std::int64_t{q.x} - p.x);
        const std::int64_t y = (std::int64_t{a.y} - p.y) * (std::int64_t{q.y} - p.y);
        return x + y > 0 ? 0 : 2;
    };
    const int sd = sector(d), sb = sector(b) == 0 ? 4 : sector(b);
    if (sd == 0) return false;
    if (sd != sb) return sd < sb;
    return sd % 2 == 1 && side(p, d, b) > 0;
}

/// An edge a -> b of a loop, with the points before and after it.
struct cycle_edge {
    grid_point before, a, b, after;

    [[nodiscard]] constexpr std::int32_t left() const noexcept { return (std::min)(a.x, b.x); }
    [[nodiscard]] constexpr std::int32_t right() const noexcept { return (std::max)(a.x, b.x); }
};

/// Compares two edges of one loop or of two loops.
constexpr void compare(const cycle_edge& e, const cycle_edge& f, boundary_check& found) noexcept
{
    if (!meet(e.a, e.b, f.a, f.b)) return;
    const bool aa = e.a == f.a, ab = e.a == f.b, ba = e.b == f.a, bb = e.b == f.b;
    if (!(aa || ab || ba || bb)) {
        ++found.crossings;
        return;
    }
    const grid_point p = aa || ab ? e.a : e.b;  // the common end; the other ends follow
    const grid_point other_e = aa || ab ? e.b : e.a, other_f = aa || ba ? f.b : f.a;
    const bool lie_on_each_other =
        side(p, other_e, other_f) == 0 && (lies_on(other_f, p, other_e) || lies_on(other_e, p, other_f));
    if (aa + ab + ba + bb > 1 || lie_on_each_other) {
        ++found.overlaps;
        return;
    }
    const bool strays = (aa && turns_through(p, e.b, f.b, e.before)) || (aa && turns_through(p, f.b, e.b, f.before)) ||
                        (bb && turns_through(p, e.after, f.a, e.a)) || (bb && turns_through(p, f.after, e.a, f.a)) ||
                        (ab && !(e.before == f.a) && turns_through(p, e.b, f.a, e.before)) ||
                        (ba && !(e.after == f.b) && turns_through(p, e.after, f.b, e.a));
    found.strays += strays ? 1u : 0u;
}

}  // namespace detail

/// Compares all pairs of edges whose ranges of x overlap.
[[nodiscard]] inline boundary_check check_boundary(const std::vector<loop>& loops)
{
    using detail::cycle_edge;
    boundary_check found;
    std::vector<cycle_edge> edges;
    for (const loop l : loops) {
        const std::size_t n = l.size();
        if (n < 3) {
            ++found.short_loops;
            continue;
        }
        for (std::size_t i = 0; i < n; ++i) edges.push_back({l[(i + n - 1) % n], l[i], l[(i + 1) % n], l[(i + 2) % n]});
    }
    for (const cycle_edge& e : edges) {
        if (e.a == e.b)
            ++found.repeated_points;
        else if (e.a == e.after || lies_on(e.after, e.a, e.b) || lies_on(e.a, e.b, e.after))
            ++found.spikes;
    }
    if (*found.broken() != '\0') return found;  // the comparison below needs edges with a length and a direction
    std::sort(edges.begin(), edges.end(), [](const cycle_edge& p, const cycle_edge& q) { return p.left() < q.left(); });
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left() <= edges[i].right(); ++j)
            detail::compare(edges[i], edges[j], found);
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
