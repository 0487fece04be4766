// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/triangulate/impl/chain_cutter.hpp>
#include <typemesh/triangulate/impl/low_triangles.hpp>
#include <typemesh/triangulate/impl/monotone_sweep.hpp>
#include <typemesh/triangulate/triangulator.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The fast triangulator: one sweep from left to right, which also proves that the loops bound a region.
///
///     points   [ outer | hole | hole | outer | ... ]   on the grid, |coordinate| <= 2^28
///     out      three indices into `points` per triangle, counter-clockwise, no zero area
///
/// Loops come in any order, holes need no mark, collinear points and vertical edges are no special cases. No point is
/// dropped or added: every edge of the loops is an edge of exactly one triangle. The triangles are as slender as the
/// sweep makes them. Only triangles that are too thin for 32-bit floats (lower than 2^-20 em) are changed: their edges
/// are flipped afterwards. If triangle quality matters (lighting per vertex, bending), use another triangulator.
///
/// Cost   O(n log n); one pass. Only points that open a span need a search; all other points find their span by their
///        edges.
/// Space  at most 130 bytes per point from `space`; no other memory once `out` has the capacity
/// Exact  orientation in 64 bits (see core/orientation.hpp) is the only predicate of the sweep; heights take 128 bits
/// From   de Berg et al., Computational Geometry, 3rd ed. (2008), 3.2 and 3.3; Shamos & Hoey, Geometric intersection
///        problems (1976)
struct monotone {
    // Its functions are templates, so that translation units that do not call them do not compile the sweep.

    static constexpr bool has_final_diagonals = true;  ///< edges of thin triangles are already flipped here

    /// Relies on the guarantees of a region. Fails with error::out_of_memory; `out` is then unchanged.
    template <class = void>
    [[nodiscard]] error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        const auto nothing = [](const auto&) noexcept {};
        const loops_view loops{r.points(), r.starts(), r.order(), r.grid()};
        return r.is_touching() ? cut<false, true>(loops, space, out, nothing)
                               : cut<false, false>(loops, space, out, nothing);
    }

    /// The region that `loops` bound; appends its triangles to `out`.
    ///
    /// Fails  error::crossing_contours: exactly if two edges cross, touch or overlap (neighbours in a loop may share
    ///        only their common point), or if some edge does not have the interior only on its left: a single clockwise
    ///        loop, or a loop inside another loop of the same direction
    ///        error::out_of_memory
    /// In both cases `out` is unchanged. See triangulator.hpp for the error's count.
    template <class = void>
    [[nodiscard]] result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        region r = region::proven(loops, 0, 0);
        const error e = cut<true, false>(view_of(loops), space, out, [&](const auto& sweep) noexcept {
            r = region::proven(loops, sweep.holes(), sweep.outers());
        });
        if (e) return e;
        return r;
    }

    /// Like prove(), for loops that may pass through a point more than once, each time along a separate sector of
    /// interior. Fails as prove() does, and also if a visit leaves its sector. Takes about 40 more bytes per point from
    /// `space`.
    template <class = void>
    [[nodiscard]] result<region> prove_touching(const contours& loops, workspace& space,
                                                triangle_list& out) const noexcept
    {
        region r = region::proven(loops, 0, 0);
        const error e = cut<true, true>(view_of(loops), space, out, [&](const auto& sweep) noexcept {
            r = region::proven(loops, sweep.holes(), sweep.outers(), sweep.has_equal_points());
        });
        if (e) return e;
        return r;
    }

private:
    /// The parts of contours or of a region that the sweep reads.
    struct loops_view {
        array_view<const grid_point> points;
        array_view<const std::uint32_t> starts, order;
        grid cells;
    };
    [[nodiscard]] static loops_view view_of(const contours& loops) noexcept
    {
        return {loops.points.view(), loops.starts.view(), loops.order(), loops.grid};
    }

    template <bool Proving, bool Touching, class Then>
    [[nodiscard]] static error cut(const loops_view& loops, workspace& space, triangle_list& out, Then&& then) noexcept
    {
        const auto [points, starts, order, cells] = loops;
        if (points.empty()) return error::none;
        const std::size_t before = out.size();
        triangle* const first = out.append(points.size() + 2 * (starts.size() - 1));
        if (first == nullptr) return error::out_of_memory;
        using cutter = detail::chain_cutter<detail::triangle_output>;
        detail::monotone_sweep<Proving, Touching, cutter> sweep{points, starts, cutter{detail::triangle_output{first}}};
        error e = sweep.run(space, order);
        const detail::triangle_output& output = sweep.cutter().output();
        const std::size_t made = e ? 0 : static_cast<std::size_t>(output.end() - first);
        const triangle_heights heights{cells};
        if (made != 0 && output.smallest() < heights.doubled_area_of_low())
            e = raise_low_triangles(points, starts, heights, {first, made}, space);
        out.truncate(before + (e ? 0 : made));
        if (!e) then(sweep);
        return e;
    }
};

static_assert(touching_triangulator<monotone>);

}  // namespace typemesh::inline TYPEMESH_ABI
