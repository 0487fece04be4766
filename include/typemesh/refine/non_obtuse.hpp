// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/non_obtuse_refinement.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The refiner for triangles without obtuse angles: adds points until no angle is above 90 degrees, except
/// for what rounding adds.
///
///           c                 Each triangle of a coarse Delaunay mesh is divided into six right triangles: at a point
///         / | \               inside, and at the feet of the perpendiculars from it to the edges. Two triangles that
///       f2--o--f1             share an edge have the same foot on it.
///       /   |   \             If the coarse mesh has no obtuse angle, it is not divided.
///      a----f3---b
///
/// Solvers of heat or Poisson equations do not need it: they need cotangent weights that are not negative, and
/// delaunay_refined has these on all inner edges, with a fifth of the triangles. Here the edge from a corner to a point
/// o inside lies opposite two right angles: its weight is 0, or by rounding a little less. There is no least angle.
///
/// Points are rounded to the grid, so right angles become larger or smaller. At each corner, with the vectors p and q
/// to the other corners, in cells:
///
///     2 (p.x q.x + p.y q.y)  >=  -3 (|p.x| + |p.y| + |q.x| + |q.y|) - 9
///
/// which is what moving each coordinate of p and q by 3/2 explains. refined_cap::kept counts the triangles that miss
/// this, because features of a few cells leave no room; it is usually 0. Points that are added to a curve's edge by the
/// coarse mesh lie on the curve, as in delaunay_refined; feet lie on the edges between these.
///
/// Fails  error::bad_option: max_edge is negative or not finite, or below 32 cells on a glyph, or max_points is above
///        2^29 - 1 ("max_edge", "max_points"), or
///        the grid has no em ("units_per_em")
///        error::too_many_points: the glyph needs more than max_points
///        error::out_of_memory
/// Cost   O(1) on average for each point that is added
/// From   Bern, Mitchell & Ruppert: see impl/radical_weights.hpp
struct non_obtuse {
    float max_edge = 0.0f;                          ///< the length of the longest edge, in em; 0: any length
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one cap, 2^29 - 1 at most

    using scratch = detail::non_obtuse_refinement;  ///< keeps its memory for the next cap

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {max_edge, max_points}; }

    /// The error for options that are out of range on every glyph, or none.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(as_double(max_edge)) || max_edge < 0.0f) return error::bad("max_edge");
        if (max_points > max_refined_points) return error::bad("max_points");
        return {};
    }

    [[nodiscard]] error operator()(const region& r, array_view<const triangle> cap, scratch& space,
                                   const refined_cap& out) const noexcept
    {
        if (error e = refused_options()) return e;
        detail::refinement_limits limits;  // of the coarse mesh: 20 degrees make the fewest triangles in the end
        limits.tangent = 0.364;            // of 20 degrees
        limits.off_centre = 2.694;         // as refinement_limits::from() has it for 20 degrees
        limits.max_points = max_points;
        if (max_edge > 0.0f) {
            const double em = r.grid().cells * r.grid().units_per_em, longest = as_double(max_edge) * em;
            if (!(em > 0.0)) return error::bad("units_per_em");
            if (longest < 32.0) return error::bad("max_edge");
            const double coarse = longest - 4.0;  // rounding may lengthen the parts of its edges
            limits.max_square = longest < grid::reach ? static_cast<std::int64_t>(coarse * coarse) : 0;
        }
        if (error e = space.run(r, cap, limits)) return e;
        out.kept = space.kept();
        return space.write(out);
    }
};
static_assert(refiner<non_obtuse>);

}  // namespace typemesh::inline TYPEMESH_ABI
