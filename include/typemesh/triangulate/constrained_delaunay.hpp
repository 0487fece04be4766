// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/triangulate/impl/chain_cutter.hpp>
#include <typemesh/triangulate/impl/coarse_loops.hpp>
#include <typemesh/triangulate/impl/delaunay_flips.hpp>
#include <typemesh/triangulate/impl/delaunay_slabs.hpp>
#include <typemesh/triangulate/impl/half_edges.hpp>
#include <typemesh/triangulate/impl/monotone_sweep.hpp>
#include <typemesh/triangulate/triangulator.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The triangulator for well-shaped triangles: the constrained Delaunay triangulation of the region, exact and unique.
///
/// It has the largest smallest angle of all triangulations over the region's own points. An edge that is not the
/// region's own belongs to the triangulation exactly if some circle through the edge's ends contains no point that is
/// visible from the edge. If four or more points that see each other are cocircular, all free diagonals between them
/// end at the lexicographically smallest point (by x, then y). So the set of triangles depends only on the region: not
/// on the starts or the order of contours, and not on the machine.
///
/// Method: points that only smooth the outline are left out at first. The remaining polygon is swept and made Delaunay
/// by flipping edges. Then the points left out are inserted into the boundary, each between its neighbours, coarse to
/// fine. The triangulation stays Delaunay, without point location and with few flips per point. The coarse outline may
/// cross itself: the sweep checks it like any other. Outlines may also cross while points are inserted: all triangles
/// stay counter-clockwise throughout, and counter-clockwise triangles with a simple boundary cover the inside once. A
/// short outline that is not smooth is swept with all its points. Divide and conquer triangulates all points if the
/// outline has too many points for that, if too many flips are needed, or if outlines touch themselves: it makes the
/// same triangles in another order. docs/triangulation.md measures each method: leaving points out at first saves a
/// fifth of the instructions at 1/800 em; flipping from a sweep of all points saves 4 to 6 % of the mispredicted
/// branches there; divide and conquer keeps the worst case from being quadratic.
///
/// Cost   O(n log n)
/// Space  at most 220 bytes per point and 128 per loop from `space`; no other memory once `out` has the capacity
/// Exact  orientation in 64 bits, in-circle in 128
struct constrained_delaunay {
    // Its functions are templates, so that translation units that do not call them do not compile the sweep.

    static constexpr bool has_final_diagonals = true;  ///< thin triangles stay, if there are any

    /// The maximum number of flips per triangle before divide and conquer takes over; 1 to 3 are usual, and 0 always
    /// uses divide and conquer. The option affects only the time, never the triangles.
    std::uint32_t max_flips = 4;

    /// See option_bits: the triangles do not depend on the option.
    [[nodiscard]] static option_bits cache_key() noexcept { return {}; }

    /// Relies on the guarantees of a region. Fails with error::out_of_memory; `out` is then unchanged.
    template <class = void>
    [[nodiscard]] error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        return cut(r, r.order(), space, out);
    }

    /// The region that `loops` bound; appends its triangles to `out`. Fails as monotone{}.prove() does.
    template <class = void>
    [[nodiscard]] result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        return proven_by<false>(loops, space, out);
    }

    /// Like prove(), for loops that touch in points. Fails as monotone{}.prove_touching() does.
    template <class = void>
    [[nodiscard]] result<region> prove_touching(const contours& loops, workspace& space,
                                                triangle_list& out) const noexcept
    {
        return proven_by<true>(loops, space, out);
    }

private:
    template <bool Touching>
    [[nodiscard]] result<region> proven_by(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        const std::size_t n = loops.points.size();
        workspace::scope scratch{space};
        array_view<const std::uint32_t> order = loops.order();
        if (order.empty() && n != 0) {
            auto* const sorted = scratch.take<std::uint32_t>(n);
            if (sorted == nullptr || !sweep_order(loops.points.view(), space, sorted)) return error::out_of_memory;
            order = {sorted, n};
        }
        detail::monotone_sweep<true, Touching, detail::no_cutter> sweep{loops.points.view(), loops.starts.view(), {}};
        if (const error e = sweep.run(space, order)) return e;
        const region r = region::proven(loops, sweep.holes(), sweep.outers(), sweep.has_equal_points());
        if (const error e = cut(r, order, space, out)) return e;
        return r;
    }

    /// The state that one attempt to triangulate by flips leaves for the next.
    struct attempts {
        double kept = 0;       // share of the points that the last attempt kept
        std::uint64_t budget;  // flips
    };

    /// `order` is the order of the points, or empty. A template, so that it is compiled only where it is called.
    template <class = void>
    [[nodiscard]] error cut(const region& r, array_view<const std::uint32_t> order, workspace& space,
                            triangle_list& out) const noexcept
    {
        if (r.points().empty()) return error::none;
        const std::size_t before = out.size();
        triangle* const write = out.append(r.triangle_count());
        if (write == nullptr) return error::out_of_memory;
        error e = error::crossing_contours;
        attempts left{0, r.is_touching() ? 0 : std::uint64_t{max_flips} * r.triangle_count()};
        for (const std::int64_t straightness : {2, 8})  // within 27 degrees, within 7
            if (e == error::crossing_contours && left.budget != 0 && left.kept <= worth_it)
                e = by_flips<true>(r, {}, space, write, straightness, left);
        if (e == error::crossing_contours && left.budget != 0 && r.points().size() < slabs_from)
            e = by_flips<false>(r, order, space, write, detail::coarse_loops::keep_all, left);
        if (e == error::crossing_contours) e = detail::delaunay_slabs{}.run(r, space, write);
        if (e) out.truncate(before);
        return e;
    }

    using cutter = detail::chain_cutter<detail::half_edges::output>;

    /// Regular patterns of many holes put whole columns of points on one vertical line; a sweep makes needles there.
    static constexpr std::size_t sheared_from = 1000;
    static constexpr std::size_t slabs_from = 400;  ///< below this, flips from a sweep of all points are faster
    static constexpr double worth_it = 0.875;       ///< keeping a larger share of the points saves nothing

    /// Fails with error::crossing_contours if this method does not work. Once flips have begun, no budget is left for
    /// another attempt. If all points are kept, no proof is needed. `order`: the order of the kept points, or empty.
    template <bool Proving>
    [[nodiscard]] static error by_flips(const region& r, array_view<const std::uint32_t> order, workspace& space,
                                        triangle* write, std::int64_t straightness, attempts& left) noexcept
    {
        const std::size_t n = r.points().size();
        workspace::scope scratch{space};
        detail::coarse_loops coarse;
        if (!coarse.take(scratch, r.points(), r.starts(), straightness, n >= sheared_from)) return error::out_of_memory;
        left.kept = static_cast<double>(coarse.points().size()) / static_cast<double>(n);
        if (Proving && left.kept > worth_it) return error::crossing_contours;
        detail::half_edges mesh{r.points()};
        if (!mesh.open(scratch, n + 2 * std::size_t{r.loop_count()}))
            return error::out_of_memory;  // the maximum that a sweep can make
        detail::monotone_sweep<Proving, false, cutter> sweep{coarse.points(), coarse.starts(),
                                                             cutter{detail::half_edges::output{mesh, coarse.names()}}};
        if (const error e = sweep.run(space, order)) return e;
        if (Proving && (sweep.holes() != r.holes() || sweep.outers() != r.outers())) return error::crossing_contours;
        mesh.finish(sweep.cutter().output());

        detail::delaunay_flips flips{mesh, r.points(), taken(left.budget)};
        if (!flips.open(scratch, r.triangle_count())) return error::out_of_memory;
        if (!flips.everywhere()) return error::crossing_contours;
        if constexpr (Proving) {
            if (!coarse.bring_back(
                    [&](std::uint32_t previous, std::uint32_t p) noexcept { return flips.insert(previous, p); }))
                return error::crossing_contours;
        }
        mesh.write(write);
        return error::none;
    }
};

static_assert(touching_triangulator<constrained_delaunay>);

}  // namespace typemesh::inline TYPEMESH_ABI
