// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Separates or joins the corners where the boundary of a region touches itself. Afterwards no two cycles share a
/// point, and no cycle passes through a point twice.
///
///        |::::            |::::            |:::::        A small diamond around each such point is removed from the
///     ---+----    or    --' .--    or    --' .---        region (part) or added to it (join). The result is resolved
///     :::|              ::.'             :::/            like any contours, so it is proven like any region.
///
/// The diamond reaches 4 cells from the point, or 2^-15 em if this is more. If a gap narrows to less than a cell, its
/// sides meet again a little farther along; the next diamond there is twice as large, up to 128 cells or 2^-10 em.
/// Corners that still touch then get the opposite treatment: a slit that cannot be opened is filled.
///
///     corner_parting parting;
///     auto filled = parting(loops, curves, space);     // loops bound a region whose boundary touches itself
///
/// The new edges are straight. Each has its own curve, a line, which is appended to `curves`.
class corner_parting {
public:
    /// Replaces `loops`. As in every region, the loops have the interior on their left; loops.curves are `curves`.
    /// loops.corners selects the treatment; touching::keep changes nothing.
    ///
    /// The region may be empty: specks smaller than a diamond may vanish.
    ///
    /// Fails  as resolve() does; the content of `loops` is then undefined
    /// Cost   one resolve() per round; there is nearly always one round
    template <class = void>  // see resolve()
    [[nodiscard]] result<region> operator()(contours& loops, buffer<curve>& curves, workspace& space,
                                            std::uint32_t max_pieces = default_max_pieces) noexcept;

    /// The reach of the smallest diamonds, in cells.
    [[nodiscard]] static double reach(const grid& g) noexcept { return smallest(g); }

    std::uint32_t corners = 0;    ///< after a call: the number of points through which the boundary passed more than
                                  ///< once
    bool still_touching = false;  ///< after a call: whether some of these points could not be treated

private:
    static constexpr int doublings = 6;
    static constexpr std::int32_t frame = 1 << 28;  // the grid's reach

    /// The size of the first diamonds.
    [[nodiscard]] static std::int32_t smallest(const grid& g) noexcept
    {
        std::int32_t size = 4;
        while (size < 0x1p-15 * g.cells * g.units_per_em && size < 1 << 16) size *= 2;
        return size;
    }

    /// Finds the points through which the loops pass more than once, and lists each point once. Null if out of memory.
    [[nodiscard]] static grid_point* find(contours& loops, workspace::scope& scratch, workspace& space,
                                          std::uint32_t& found) noexcept
    {
        const std::size_t n = loops.points.size();
        auto* const centres = scratch.take<grid_point>(n / 2 + 1);
        if (centres == nullptr || !sort_points(loops, space)) return nullptr;
        const auto order = loops.order();
        found = 0;
        for (std::size_t i = 1; i < n; ++i) {
            const grid_point p = loops.points[order[i]];
            if (p == loops.points[order[i - 1]] && (found == 0 || centres[found - 1] != p)) centres[found++] = p;
        }
        return centres;
    }

    /// Adds a diamond around a point. False if out of memory.
    static bool add_diamond(contours& loops, buffer<curve>& curves, grid_point at, std::int32_t size) noexcept
    {
        const auto room = [](std::int32_t v) noexcept { return frame - (v < 0 ? -v : v); };
        if (room(at.x) <= size || room(at.y) <= size) return true;  // at the end of the grid; nothing is changed
        const grid_point corner[] = {
            {at.x + size, at.y}, {at.x, at.y + size}, {at.x - size, at.y}, {at.x, at.y - size}};
        for (int i = 0; i < 4; ++i) {
            const point from = loops.grid.place(corner[i]), to = loops.grid.place(corner[(i + 1) % 4]);
            const auto number = static_cast<std::uint32_t>(curves.size());
            if (!loops.points.push_back(corner[i]) || !loops.edges.push_back({number, 0.0f, 1.0f}) ||
                !curves.push_back(curve::from(from, to)))
                return false;
        }
        return loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()));
    }

    /// Reverses all loops. Within the square that add_frame() adds, they then bound the outside of the region.
    static void turn(contours& loops) noexcept
    {
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k) {
            const std::size_t begin = loops.starts[k], size = loops.starts[k + 1] - begin;
            reverse_contour(loops.points.view().subspan(begin, size), loops.edges.view().subspan(begin, size));
        }
        loops.forget_order();
    }
    /// Adds a square as large as the grid. False if out of memory.
    static bool add_frame(contours& loops) noexcept
    {
        for (const grid_point p : {grid_point{-frame, -frame}, {frame, -frame}, {frame, frame}, {-frame, frame}})
            if (!loops.points.push_back(p) || !loops.edges.push_back({})) return false;
        return loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()));
    }
    /// Removes this square.
    static void leave_frame(contours& loops) noexcept
    {
        std::uint32_t kept = 0;
        std::size_t end = 0;
        for (std::uint32_t k = 0, begin = 0; k < loops.contour_count(); ++k) {
            const std::uint32_t after = loops.starts[k + 1];
            bool is_frame = false;
            for (std::uint32_t i = begin; i < after; ++i)
                is_frame = is_frame || (loops.points[i].x == -frame && loops.points[i].y == -frame);
            for (std::uint32_t i = begin; i < after && !is_frame; ++i, ++end) {
                loops.points[end] = loops.points[i];
                loops.edges[end] = loops.edges[i];
            }
            if (!is_frame) loops.starts[++kept] = static_cast<std::uint32_t>(end);
            begin = after;
        }
        loops.points.truncate(end);
        loops.edges.truncate(end);
        loops.starts.truncate(kept + 1);
        loops.forget_order();
    }
};

template <class>
result<region> corner_parting::operator()(contours& loops, buffer<curve>& curves, workspace& space,
                                          std::uint32_t max_pieces) noexcept
{
    corners = 0;
    still_touching = false;
    const resolve_options how{.max_pieces = max_pieces};
    const std::int32_t first = smallest(loops.grid);
    if (loops.corners == touching::keep) return resolve(loops, fill_rule::non_zero, space, how);
    bool has_room = true;  // whether the square of add_frame() fits
    for (const grid_point p : loops.points)
        has_room = has_room && p.x > -frame && p.x < frame && p.y > -frame && p.y < frame;
    std::uint32_t holes = 0, outers = 0;
    for (int round = 0;; ++round) {
        const bool opens = (loops.corners == touching::part) == (round < doublings);
        const std::int32_t size = first << (round % doublings);
        workspace::scope scratch{space};
        std::uint32_t found = 0;
        const grid_point* const centres = find(loops, scratch, space, found);
        if (centres == nullptr) return error::out_of_memory;
        if (round == 0) corners = found;
        still_touching = found != 0;
        if (round != 0 && found == 0) return region::proven(loops, holes, outers);
        if (found == 0 || round == 2 * doublings || !has_room) return resolve(loops, fill_rule::non_zero, space, how);
        loops.forget_order();
        if (opens) turn(loops);
        if (opens && !add_frame(loops)) return error::out_of_memory;
        for (std::uint32_t k = 0; k < found; ++k)
            if (!add_diamond(loops, curves, centres[k], size)) return error::out_of_memory;
        loops.curves = curves.view();
        if (!is_zero(loops.grid.span)) loops.grid.span += 2.0 * size;
        const auto made = resolve(loops, fill_rule::non_zero, space, how);
        if (!made) return made.error();
        holes = opens ? made->outers() - 1 : made->holes();
        outers = opens ? made->holes() : made->outers();
        if (!opens) continue;
        leave_frame(loops);
        turn(loops);
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
