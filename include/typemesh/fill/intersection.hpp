// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Two edges of the contours, and the grid point where the edges cross or where one edge ends on the other.
///
///     a.from ---.__                        These are whole edges of the contours, not pieces between crossings.
///     b.from ____  '--.__                  Two edges that only share an end do not intersect in this sense: the shared
///                '-----x-------- b.to      point lies on the curves of both.
///                        '---.__ a.to
struct intersection {
    /// One of the two edges that meet.
    struct edge {
        grid_point from, to;
        contour_edge source;  ///< the edge is a chord of this curve
        /// Whether p is an end of the edge.
        [[nodiscard]] bool ends_in(grid_point p) const noexcept { return from == p || to == p; }
    };
    edge a, b;
    grid_point at;
};

/// Accepts or rejects intersections: filter(m) is true if m is accepted. It is called for every intersection on the
/// boundary of the filled area, even after a rejection.
template <class J>
concept intersection_filter = requires(J& filter, const intersection& m) {
    { filter(m) } noexcept -> std::same_as<bool>;
};

/// Refers to a filter of any type, which must outlive the reference. A default-constructed reference accepts
/// everything.
class intersection_filter_ref {
public:
    constexpr intersection_filter_ref() noexcept = default;
    template <intersection_filter Filter>
        requires(!std::same_as<Filter, intersection_filter_ref>)
    intersection_filter_ref(Filter& filter) noexcept
        : filter_{&filter},
          accepts_{[](void* f, const intersection& m) noexcept { return (*static_cast<Filter*>(f))(m); }}
    {
    }

    /// Whether it refers to no filter.
    [[nodiscard]] bool accepts_all() const noexcept { return accepts_ == nullptr; }
    [[nodiscard]] bool operator()(const intersection& m) const noexcept
    {
        return accepts_all() || accepts_(filter_, m);
    }

private:
    void* filter_ = nullptr;
    bool (*accepts_)(void* filter, const intersection& m) noexcept = nullptr;
};

namespace detail {

[[nodiscard]] inline intersection::edge edge_of(const arrangement& a, const segment& s) noexcept
{
    const auto [from, to] = a.home(s);
    return {from, to, a.loops->edges[s.origin]};
}

/// Whether the intersection of two edges is accepted. Edges that only share an end need no filter.
[[nodiscard]] inline bool may_intersect(const arrangement& a, const segment& s, const segment& t, grid_point at,
                                        intersection_filter_ref filter) noexcept
{
    const intersection m{edge_of(a, s), edge_of(a, t), at};
    return (m.a.ends_in(at) && m.b.ends_in(at)) || filter(m);
}

/// Passes the point where the boundary goes from one segment to another to the filter, if this point is an
/// intersection.
[[nodiscard]] inline bool filter_change(const arrangement& a, const segment& s, const segment& t, grid_point at,
                                        intersection_filter_ref filter) noexcept
{
    if (s.origin == t.origin) return true;
    if (s.target == t.origin && a.loops->points[t.origin] == at) return true;  // the contour's next edge: usual
    return may_intersect(a, s, t, at, filter);
}

/// Passes to the filter, at each point, the intersections of all edges that bound the filled area. False if out of
/// memory.
///
/// If more than 16 edges pass through one point, all intersections there are accepted: so many edges do not meet by
/// accident, and there would be many pairs.
[[nodiscard]] inline bool filter_touches(const arrangement& a, workspace& space, intersection_filter_ref filter,
                                         bool& all_accepted) noexcept
{
    constexpr std::uint32_t most = 16;
    struct visit {
        std::uint32_t segment, before;  // before: the previous visit of the same point
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
                if (!may_intersect(a, *edges[i], *edges[k], a.points[place], filter)) all_accepted = false;
    }
    return true;
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
