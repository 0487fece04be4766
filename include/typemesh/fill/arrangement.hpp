// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/sweep_order.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A point's place in the sweep order, by x and then by y, as one number.
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

/// A straight piece of the contours, from left to right, and what it separates.
///
/// Several edges that lie upon each other are one segment; when they cancel, its winding delta is 0 and it is none at all. It
/// fills one cache line.
struct alignas(64) segment {
    grid_point from, to;       // from before to in the sweep order, but see resolving_sweep::cut
    std::uint32_t start, end;  // the numbers of these two points
    std::int32_t winding_delta;         // the winding number right above it less the one right below
    std::int32_t below;        // the winding number right below, once the sweep has met it
    contour_edge source;       // t0 belongs to `from`, t1 to `to`
    std::uint32_t origin, target;  // the contour points that the edge it was cut from joins
    std::uint32_t next;    // before the sweep: the next that starts in the same point; behind it: see boundary_cycles
    std::uint32_t bent;    // 1: it may lie beside that contour edge, by a cell or so
    std::int32_t interior;  // once the sweep has met it, 1: the filled area lies right above it only, -1: right below
                            // it only, 0: it bounds nothing

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

    /// The curve's parameter where the segment is cut in p. Rounded, and nothing is decided by it but which way the two
    /// parts run along their curve: it is neither t0 nor t1, though p may lie right beside an end, as long as there is
    /// a float between them.
    [[nodiscard]] float t_at(grid_point p) const noexcept
    {
        const double dx = static_cast<double>(to.x) - from.x, dy = static_cast<double>(to.y) - from.y;
        const bool by_x = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy);
        const double share = by_x ? (static_cast<double>(p.x) - from.x) / dx : (static_cast<double>(p.y) - from.y) / dy;
        const float t = static_cast<float>(as_double(source.t0) + (as_double(source.t1) - as_double(source.t0)) * share);
        const bool up = source.t0 < source.t1;
        const float low = up ? source.t0 : source.t1, high = up ? source.t1 : source.t0;
        if ((low < t && t < high) || p == from || p == to) return t;
        const float beside = t <= low ? low + (high - low) / 64.0f : high - (high - low) / 64.0f;
        return low < beside && beside < high ? beside : std::nextafter(low, high);
    }
};

/// Contours taken apart into segments between numbered points: the material that is cut until no two segments cross.
///
/// Whatever is cut, flipped or joined, the turns add up to closed contours: in every point as much comes in as goes
/// out.
struct arrangement {
    segment* segments = nullptr;
    std::uint32_t count = 0;
    std::uint32_t capacity = 0;
    grid_point* points = nullptr;  // all different, in the sweep order; room for as many as there may be segments
    grid_point* spare = nullptr;   // of the same size
    std::uint32_t* first =
        nullptr;  // of the segments that start in each point: the first, the others follow by `next`
    std::uint32_t point_count = 0;
    const contours* loops = nullptr;  // what was taken apart
    bool is_bent = false;             // some segment does not lie on its contour edge
    std::uint32_t most_active = no_number;  // how many segments are on the sweep line at a time
    bool is_rounded = false;          // it was made by snap_rounding: nothing is to be bent
    bool is_touching = false;         // the boundary of the filled area comes through some point more than once

    struct edge {
        grid_point from, to;
    };

    /// The contour edge that a segment was cut from.
    [[nodiscard]] edge home(const segment& s) const noexcept
    {
        return {loops->points[s.origin], loops->points[s.target]};
    }

    /// Room for `most` segments. What is there already is kept. False when there is no memory.
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

    /// The same for pieces between numbered points that are given in `scratch`: the first `piece_count` and
    /// `given_points` of two arrays of one size. False when there is no memory.
    [[nodiscard]] bool adopt(workspace::scope& scratch, std::span<segment> pieces, std::uint32_t piece_count,
                             std::span<grid_point> places, std::uint32_t given_points) noexcept
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

    /// Takes contours apart; edges without length vanish. Needs capacity >= given.points.size(),
    /// its points sorted (see sort_points()), and `given` to stay while the arrangement is cut.
    [[nodiscard]] bool from_contours(const contours& given, workspace& space) noexcept
    {
        loops = &given;
        const auto n = static_cast<std::uint32_t>(given.points.size());
        workspace::scope scratch{space};
        auto* const number = scratch.take<std::uint32_t>(n);
        if (number == nullptr) return false;
        const std::span<const std::uint32_t> order = given.order();
        TYPEMESH_ASSERT(order.size() == n, "contours are sorted before they are taken apart: see sort_points()");
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
                void* const here = all + made;  // made in place: a copy of what has just been written stalls
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

    /// Numbers the points anew and lists the segments by where they start; drops those that are none.
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
