// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Two edges of the contours, and the grid point where they cross or where one of them ends on the other.
///
///     a.from ---.__                        The edges are the contours' own, not the pieces that they are cut into.
///     b.from ____  '--.__                  Where edges only share an end there is no intersection to tell of: that point
///                '-----x-------- b.to      lies on the curves of both.
///                        '---.__ a.to
struct intersection {
    struct edge {
        grid_point from, to;
        contour_edge source;
        [[nodiscard]] bool ends_in(grid_point p) const noexcept { return from == p || to == p; }
    };
    edge a, b;
    grid_point at;
};

/// Told of intersections: filter(m) is whether this one may stand. It is asked of all that the boundary of the filled area
/// comes through, also when one does not.
template <class J>
concept intersection_filter = requires(J& filter, const intersection& m) {
    { filter(m) } noexcept -> std::same_as<bool>;
};

/// The filter that lets all pass.
struct every_intersection_stands {
    constexpr bool operator()(const intersection&) const noexcept { return true; }
};

namespace detail {

[[nodiscard]] inline intersection::edge edge_of(const arrangement& a, const segment& s) noexcept
{
    const auto [from, to] = a.home(s);
    return {from, to, a.loops->edges[s.origin]};
}

/// Where edges only share an end there is nothing to filter.
template <intersection_filter Filter>
[[nodiscard]] bool may_intersect(const arrangement& a, const segment& s, const segment& t, grid_point at,
                            Filter& filter) noexcept
{
    const intersection m{edge_of(a, s), edge_of(a, t), at};
    return (m.a.ends_in(at) && m.b.ends_in(at)) || filter(m);
}

/// Judges the intersection where the boundary changes from one segment to another, if it is one.
template <intersection_filter Filter>
[[nodiscard]] bool filter_change(const arrangement& a, const segment& s, const segment& t, grid_point at,
                                Filter& filter) noexcept
{
    if (s.origin == t.origin) return true;
    if (s.target == t.origin && a.loops->points[t.origin] == at) return true;  // the contour's next edge: nearly always
    return may_intersect(a, s, t, at, filter);
}

/// Judges the intersections of all edges that bound the filled area in one point; false when there is no memory.
///
/// Where more than 16 edges come through one point all stand: nothing there is made by chance, and the pairs would be
/// many.
template <intersection_filter Filter>
[[nodiscard]] bool filter_touches(const arrangement& a, workspace& space, Filter& filter, bool& all_stand) noexcept
{
    constexpr std::uint32_t most = 16;
    struct visit {
        std::uint32_t segment, before;  // before: the visit before in the same point
    };
    workspace::scope scratch{space};
    auto* const last = scratch.take<std::uint32_t>(a.point_count);
    auto* const visits = scratch.take<visit>(2 * std::size_t{a.count});
    if (last == nullptr || visits == nullptr) return false;
    for (std::uint32_t i = 0; i < a.point_count; ++i) last[i] = no_number;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const segment& s = a.segments[i];
        if (s.interior == 0) continue;
        for (const std::uint32_t place : {s.start, s.end}) {
            visits[count] = {i, last[place]};
            last[place] = count++;
        }
    }
    for (std::uint32_t place = 0; place < a.point_count; ++place) {
        const segment* edges[most + 1] = {};
        std::uint32_t size = 0;
        for (std::uint32_t v = last[place]; v != no_number; v = visits[v].before) {
            const segment& s = a.segments[visits[v].segment];
            std::uint32_t k = 0;
            while (k < size && edges[k]->origin != s.origin) ++k;
            if (k == size && size <= most) edges[size++] = &s;
        }
        if (size > most) continue;
        for (std::uint32_t i = 1; i < size; ++i)
            for (std::uint32_t k = 0; k < i; ++k)
                if (!may_intersect(a, *edges[i], *edges[k], a.points[place], filter)) all_stand = false;
    }
    return true;
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
