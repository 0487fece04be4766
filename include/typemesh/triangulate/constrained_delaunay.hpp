// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/triangulate/chain_cutter.hpp>
#include <typemesh/triangulate/coarse_loops.hpp>
#include <typemesh/triangulate/delaunay_flips.hpp>
#include <typemesh/triangulate/half_edges.hpp>
#include <typemesh/triangulate/monotone_sweep.hpp>
#include <typemesh/triangulate/triangulator.hpp>

namespace typemesh {

/// The triangulator for good triangles: the constrained Delaunay triangulation of the region, exact and unique.
///
/// Of all triangulations over the region's own points it has the largest smallest angle. An edge that is not the region's own is
/// there exactly when some circle through its ends holds no point that is seen from it. Where four or more points that see each
/// other lie on one circle, all free diagonals between them leave the lexicographically smallest (by x, then y): so the set of
/// triangles depends on nothing but the region, neither on where contours begin nor on their order nor on the machine.
///
/// How: points that only smooth the outline are left out at first (coarse_loops); what remains is swept (monotone_sweep), made
/// Delaunay by exchanging diagonals (delaunay_flips), and then takes the points left out back on its boundary, each between its
/// neighbours and from coarse to fine, staying Delaunay: no searching, two exchanges a point. Whether the coarse outline crosses
/// itself does not matter: it is proven like any other, and where it does, no point is left out. Nor does it matter whether outlines
/// cross on the way from coarse to fine: all triangles turn counter-clockwise throughout, and triangles that do so and have a
/// simple boundary cover what is inside once.
///
/// Cost   O(n log n) on all that is drawn; quadratic in the worst case
/// Space  about 220 bytes a point from `space`, nothing else after `out` has room
/// Exact  orientation in 64 bits, in-circle in 128 (core/in_circle.hpp)
struct constrained_delaunay {
    /// Relies on the region's promise. Fails with error::out_of_memory, `out` being as it was.
    [[nodiscard]] error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        if (r.points().empty()) return error::none;
        const std::size_t before = out.size();
        triangle* const write = out.append(r.triangle_count());
        if (write == nullptr) return error::out_of_memory;
        error e = error::crossing_contours;
        for (const std::int64_t straightness : {2, 8})  // 27 and 7 degrees
            if (e == error::crossing_contours) e = from_coarse_loops(r, space, write, straightness);
        if (e == error::crossing_contours) e = from_all_points(r, space, write);
        if (e) out.truncate(before);
        return e;
    }

    /// The region that `loops` bound, its triangles appended to `out`. Fails as monotone{}.prove() does.
    [[nodiscard]] result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        detail::monotone_sweep<true, detail::no_cutter> sweep{loops.points.view(), loops.starts.view(), {}};
        if (const error e = sweep.run(space)) return e;
        const region r = region::proven(loops, sweep.holes(), sweep.outers());
        if (const error e = (*this)(r, space, out)) return e;
        return r;
    }

private:
    /// error::crossing_contours: not this way.
    [[nodiscard]] static error from_coarse_loops(const region& r, workspace& space, triangle* write, std::int64_t straightness) noexcept
    {
        workspace::scope scratch{space};
        detail::coarse_loops coarse;
        if (!coarse.take(scratch, r.points(), r.starts(), straightness)) return error::out_of_memory;
        if (coarse.points().size() * 8 > r.points().size() * 7) return error::crossing_contours;
        detail::half_edges mesh{r.points()};
        if (!mesh.open(scratch, room_for(r))) return error::out_of_memory;
        detail::monotone_sweep<true, cutter> sweep{coarse.points(), coarse.starts(), cutter{detail::half_edges::output{mesh, coarse.names()}}};
        if (const error e = sweep.run(space)) return e;
        if (sweep.holes() != r.holes() || sweep.outers() != r.outers()) return error::crossing_contours;
        mesh.finish(sweep.cutter().output());
        return make_delaunay(r, mesh, &coarse, scratch, write);
    }

    [[nodiscard]] static error from_all_points(const region& r, workspace& space, triangle* write) noexcept
    {
        workspace::scope scratch{space};
        detail::half_edges mesh{r.points()};
        if (!mesh.open(scratch, room_for(r))) return error::out_of_memory;
        detail::monotone_sweep<false, cutter> sweep{r.points(), r.starts(), cutter{detail::half_edges::output{mesh, nullptr}}};
        if (const error e = sweep.run(space)) return e;
        mesh.finish(sweep.cutter().output());
        return make_delaunay(r, mesh, nullptr, scratch, write);
    }

    using cutter = detail::chain_cutter<detail::half_edges::output>;

    /// As many triangles as a sweep can ask for.
    [[nodiscard]] static std::size_t room_for(const region& r) noexcept { return r.points().size() + 2 * std::size_t{r.loop_count()}; }

    [[nodiscard]] static error make_delaunay(const region& r, detail::half_edges& mesh, const detail::coarse_loops* coarse,
                                             workspace::scope& scratch, triangle* write) noexcept
    {
        detail::delaunay_flips flips{mesh, r.points()};
        if (!flips.open(scratch, r.triangle_count())) return error::out_of_memory;
        flips.everywhere();
        if (coarse != nullptr && !coarse->bring_back([&](std::uint32_t previous, std::uint32_t p) noexcept { return flips.insert(previous, p); }))
            return error::crossing_contours;
        mesh.write(write);
        return error::none;
    }
};

static_assert(proving_triangulator<constrained_delaunay>);

}  // namespace typemesh
