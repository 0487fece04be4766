// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A point's position in sweep order, by x and then by y, as one number.
[[nodiscard]] constexpr std::int64_t sweep_place(grid_point p) noexcept
{
    return std::int64_t{p.x} * (std::int64_t{1} << 32) + p.y;
}
[[nodiscard]] constexpr grid_point point_at(std::int64_t sweep_place) noexcept
{
    const auto y = static_cast<std::int32_t>(static_cast<std::uint32_t>(sweep_place));
    return {static_cast<std::int32_t>((sweep_place - y) >> 32), y};
}

[[nodiscard]] constexpr bool is_between(grid_point a, grid_point p, grid_point b) noexcept
{
    return sweep_place(a) < sweep_place(p) && sweep_place(p) < sweep_place(b);
}

inline constexpr std::uint32_t no_number = 0xFFFF'FFFFu;

/// A straight piece of the contours, from left to right, with the winding numbers that it separates.
///
/// Edges that lie upon each other are one segment. If they cancel, its winding delta is 0, and it does not count. It
/// fills one cache line.
struct alignas(64) segment {
    grid_point from, to;           // `from` precedes `to` in sweep order, but see resolving_sweep::cut
    std::uint32_t start, end;      // the numbers of these two points
    std::int32_t winding_delta;    // the winding number right above it minus the one right below
    std::int32_t below;            // the winding number right below, once the sweep has reached it
    contour_edge source;           // t0 belongs to `from`, t1 to `to`
    std::uint32_t origin, target;  // the contour points joined by the edge that it was cut from
    std::uint32_t next;     // before the sweep: the next one that starts in this point; after it: see boundary_cycles
    std::uint32_t bent;     // 1: it may lie beside that contour edge, by about a cell
    std::int32_t interior;  // once the sweep has reached it, 1: the filled area lies right above it only, -1: right
                            // below it only, 0: it bounds nothing

    void flip() noexcept
    {
        const grid_point p = from;
        from = to;
        to = p;
        const std::uint32_t number = start;
        start = end;
        end = number;
        const float t = source.t0;
        source.t0 = source.t1;
        source.t1 = t;
        winding_delta = -winding_delta;
    }

    /// The curve's parameter at the cut in p. It is rounded, but its only use is the direction of the two halves along
    /// their curve. If any float lies between t0 and t1, the result is such a float, even if p lies right beside an
    /// end.
    [[nodiscard]] float t_at(grid_point p) const noexcept
    {
        const double dx = static_cast<double>(to.x) - from.x, dy = static_cast<double>(to.y) - from.y;
        const bool by_x = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy);
        const double share = by_x ? (static_cast<double>(p.x) - from.x) / dx : (static_cast<double>(p.y) - from.y) / dy;
        const double length = as_double(source.t1) - as_double(source.t0);
        const float t = static_cast<float>(as_double(source.t0) + length * share);
        const bool up = source.t0 < source.t1;
        const float low = up ? source.t0 : source.t1, high = up ? source.t1 : source.t0;
        if ((low < t && t < high) || p == from || p == to) return t;
        const float beside = t <= low ? low + (high - low) / 64.0f : high - (high - low) / 64.0f;
        return low < beside && beside < high ? beside : std::nextafter(low, high);
    }
};

/// Contours as segments between numbered points. They are cut until no two segments cross.
///
/// Cuts, flips and joins keep the segments closed contours: in every point, equally many come in and go out.
struct arrangement {
    segment* segments = nullptr;
    std::uint32_t count = 0;
    std::uint32_t capacity = 0;
    grid_point* points = nullptr;    // distinct, in sweep order; capacity for as many as there may be segments
    grid_point* spare = nullptr;     // with the same capacity
    std::uint32_t* first = nullptr;  // for each point: the first segment that starts there; the others follow by `next`
    std::uint32_t point_count = 0;
    const contours* loops = nullptr;       // the source of the segments
    bool is_bent = false;                  // some segment does not lie on its contour edge
    std::uint32_t max_active = no_number;  // the largest number of segments on the sweep line
    bool is_rounded = false;               // made by snap_rounding: nothing needs bending any more
    bool is_touching = false;              // the boundary of the filled area passes through some point more than once

    struct edge {
        grid_point from, to;
    };

    /// The contour edge that a segment was cut from.
    [[nodiscard]] edge home(const segment& s) const noexcept
    {
        return {loops->points[s.origin], loops->points[s.target]};
    }

    /// Takes memory for `most` segments and keeps the existing ones. False if out of memory.
    [[nodiscard]] bool reserve(workspace::scope& scratch, std::uint32_t most) noexcept
    {
        auto* const larger = scratch.take<segment>(most);
        points = scratch.take<grid_point>(most);
        spare = scratch.take<grid_point>(most);
        first = scratch.take<std::uint32_t>(most);
        if (larger == nullptr || points == nullptr || spare == nullptr || first == nullptr) return false;
        if (count != 0) std::memcpy(static_cast<void*>(larger), segments, count * sizeof(segment));
        segments = larger;
        capacity = most;
        return true;
    }

    /// The same for segments between numbered points that already lie in `scratch`: the first `piece_count` and
    /// `given_points` of two arrays of one size. False if out of memory.
    [[nodiscard]] bool adopt(workspace::scope& scratch, array_view<segment> pieces, std::uint32_t piece_count,
                             array_view<grid_point> places, std::uint32_t given_points) noexcept
    {
        is_rounded = true;
        segments = pieces.data();
        count = piece_count;
        capacity = static_cast<std::uint32_t>(pieces.size());
        points = places.data();
        point_count = given_points;
        spare = scratch.take<grid_point>(capacity);
        first = scratch.take<std::uint32_t>(capacity);
        if (spare == nullptr || first == nullptr) return false;
        list();
        return true;
    }

    /// Makes segments from the edges of contours; edges without length vanish. Precondition: capacity >=
    /// given.points.size(), and the points are sorted (see sort_points()). `given` must outlive the cutting.
    [[nodiscard]] bool from_contours(const contours& given, workspace& space) noexcept
    {
        loops = &given;
        const auto n = static_cast<std::uint32_t>(given.points.size());
        workspace::scope scratch{space};
        auto* const number = scratch.take<std::uint32_t>(n);
        if (number == nullptr) return false;
        const array_view<const std::uint32_t> order = given.order();
        TYPEMESH_ASSERT(order.size() == n, "the points of contours are not sorted: call sort_points() first");
        const grid_point* const place = given.points.data();
        std::uint32_t different = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const grid_point p = place[order[i]];
            if (different == 0 || !(points[different - 1] == p)) {
                first[different] = no_number;
                points[different++] = p;
            }
            number[order[i]] = different - 1;
        }
        point_count = different;
        std::uint32_t made = 0;
        segment* const all = segments;
        const contour_edge* const edges = given.edges.data();
        for (std::uint32_t c = 0; c < given.contour_count(); ++c) {
            const std::uint32_t begin = given.starts[c], end = given.starts[c + 1];
            for (std::uint32_t v = begin; v < end; ++v) {
                const std::uint32_t w = v + 1 < end ? v + 1 : begin;
                const std::uint32_t i = number[v], k = number[w];
                if (i == k) continue;
                const contour_edge e = edges[v];
                void* const here = all + made;  // constructed in place: a copy of fresh data would stall
                if (i < k)
                    ::new (here) segment{place[v], place[w], i, k, 1, 0, e, v, w, first[i], 0, 0};
                else
                    ::new (here) segment{place[w], place[v], k, i, -1, 0, {e.curve, e.t1, e.t0}, v, w, first[k], 0, 0};
                first[i < k ? i : k] = made++;
            }
        }
        count = made;
        return true;
    }

    /// Renumbers the points and lists the segments by their start points. Drops segments that do not count.
    [[nodiscard]] bool put_in_order(workspace& space) noexcept
    {
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (segments[i].winding_delta == 0) continue;
            segments[kept] = segments[i];
            if (sweep_place(segments[kept].to) < sweep_place(segments[kept].from)) segments[kept].flip();
            ++kept;
        }
        count = kept;
        workspace::scope scratch{space};
        const std::size_t ends = 2 * std::size_t{count};
        auto* const order = scratch.take<std::uint32_t>(ends);
        auto* const both = scratch.take<grid_point>(ends);
        if (order == nullptr || both == nullptr) return false;
        for (std::uint32_t i = 0; i < count; ++i) {
            both[2 * i] = segments[i].from;
            both[2 * i + 1] = segments[i].to;
        }
        if (!sweep_order({both, ends}, space, order)) return false;
        point_count = 0;
        for (std::size_t i = 0; i < ends; ++i) {
            const grid_point p = both[order[i]];
            if (point_count == 0 || !(points[point_count - 1] == p)) points[point_count++] = p;
            segment& s = segments[order[i] / 2];
            (order[i] % 2 == 0 ? s.start : s.end) = point_count - 1;
        }
        list();
        return true;
    }

    void list() noexcept
    {
        for (std::uint32_t i = 0; i < point_count; ++i) first[i] = no_number;
        for (std::uint32_t i = 0; i < count; ++i) {
            segment& s = segments[i];
            if (s.winding_delta == 0) continue;
            s.next = first[s.start];
            first[s.start] = i;
        }
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
