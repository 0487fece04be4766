// SPDX-License-Identifier: MIT
#pragma once

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
/// Space  about 140 bytes a point from `space`, nothing else after `out` has room
/// Exact  orientation in 64 bits, in-circle in 128 (core/in_circle.hpp)
struct constrained_delaunay {
    /// Relies on the region's promise. Fails with error::out_of_memory, `out` being as it was.
    [[nodiscard]] error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        if (r.points().empty()) return error::none;
        if (!out.reserve(out.size() + r.points().size() + 2 * std::size_t{r.loop_count()})) return error::out_of_memory;
        const error e = from_coarse_loops(r, space, out);
        return e == error::crossing_contours ? from_all_points(r, space, out) : e;
    }

    /// The region that `loops` bound, its triangles appended to `out`. Fails as monotone{}.prove() does.
    [[nodiscard]] result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        const std::size_t before = out.size();
        detail::monotone_sweep<true> sweep{loops.points.view(), loops.starts.view()};
        if (const error e = sweep.run(space, out)) return e;
        out.truncate(before);
        const region r = region::proven(loops, sweep.holes(), sweep.outers());
        if (const error e = (*this)(r, space, out)) return e;
        return r;
    }

private:
    /// error::crossing_contours: not this way. `out` has room.
    [[nodiscard]] static error from_coarse_loops(const region& r, workspace& space, triangle_list& out) noexcept
    {
        workspace::scope scratch{space};
        detail::coarse_loops coarse;
        if (!coarse.take(scratch, r.points(), r.starts())) return error::out_of_memory;
        if (coarse.points().size() * 8 > r.points().size() * 7) return error::crossing_contours;
        const std::size_t before = out.size();
        detail::monotone_sweep<true> sweep{coarse.points(), coarse.starts()};
        if (const error e = sweep.run(space, out)) return e;
        if (sweep.holes() != r.holes() || sweep.outers() != r.outers()) {
            out.truncate(before);
            return error::crossing_contours;
        }
        return make_delaunay(r, &coarse, scratch, space, out, before);
    }

    [[nodiscard]] static error from_all_points(const region& r, workspace& space, triangle_list& out) noexcept
    {
        workspace::scope scratch{space};
        const std::size_t before = out.size();
        detail::monotone_sweep<false> sweep{r.points(), r.starts()};
        if (const error e = sweep.run(space, out)) return e;
        return make_delaunay(r, nullptr, scratch, space, out, before);
    }

    /// Replaces the triangles of `out` from `before` on by the region's, which those are of all points or of some.
    [[nodiscard]] static error make_delaunay(const region& r, const detail::coarse_loops* coarse, workspace::scope& scratch, workspace& space,
                                             triangle_list& out, std::size_t before) noexcept
    {
        detail::half_edges mesh{r.points()};
        detail::delaunay_flips flips{mesh, r.points()};
        const bool fits = mesh.open(scratch, r.triangle_count()) &&
                          mesh.link(out.view().subspan(before), coarse != nullptr ? coarse->names() : nullptr, space) &&
                          flips.open(scratch, r.triangle_count());
        out.truncate(before);
        if (!fits) return error::out_of_memory;
        flips.everywhere();
        if (coarse != nullptr && !coarse->bring_back([&](std::uint32_t previous, std::uint32_t p) noexcept { return flips.insert(previous, p); }))
            return error::crossing_contours;
        mesh.write(out.append(r.triangle_count()));
        return error::none;
    }
};

static_assert(proving_triangulator<constrained_delaunay>);

}  // namespace typemesh
