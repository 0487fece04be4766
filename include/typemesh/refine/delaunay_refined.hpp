// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/delaunay_refinement.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The refiner for triangles without small angles: adds points until every angle is at least min_angle and, if
/// max_edge is given, no edge is longer.
///
///     +-----------------+       +-----+-----+-----+      A point that is added to a curve's edge lies on the curve,
///     |   .             |       |\   / \   / \   /|      rounded to the grid. If that would make the mesh invalid, or
///     |      .          |       | \ /   \ /   \ / |      if the edge does not end on its curve, the point lies on
///     |         .       |  -->  |  +-----+-----+  |      the edge itself.
///     |            .    |       | / \   / \   / \ |
///     |               . |       |/   \ /   \ /   \|      All inner edges are Delaunay, so their cotangent weights are
///     +-----------------+       +-----+-----+-----+      not negative, as solvers of heat or Poisson equations need.
///
/// Angles stay smaller than min_angle in two cases. At a corner of the outline that is sharper than 60 degrees, all
/// angles are at least arctan(0.98 sin c / (2 - cos c)), where c is the angle in which the edges meet after refinement.
/// Where a point would come within four cells of another, it is not added; refined_cap::kept counts the triangles that
/// stay so.
///
/// Fails  error::bad_option: min_angle is not 0 to 33 degrees, max_edge is negative or not finite, or below 16 cells
///        on a glyph, or max_points is above 2^29 - 1 ("min_angle", "max_edge", "max_points"), or
///        the grid has no em ("units_per_em")
///        error::too_many_points: the glyph needs more than max_points, for example for a long gap of a few cells
///        error::out_of_memory
/// Cost   O(1) on average for each point that is added
/// From   Ruppert, Ungor, Miller & others: see impl/delaunay_refinement.hpp
struct delaunay_refined {
    float min_angle = 25.0f;  ///< the least angle, in degrees, 0 to 33; above 26.45, it is usual but not proven that
                              ///< all triangles reach it
    float max_edge = 0.0f;    ///< the length of the longest edge, in em; 0: any length
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one cap, 2^29 - 1 at most

    using scratch = detail::delaunay_refinement;  ///< keeps its memory for the next cap

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {min_angle, max_edge, max_points}; }

    /// The error for options that are out of range on every glyph, or none.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(as_double(min_angle)) || min_angle < 0.0f || min_angle > 33.0f) return error::bad("min_angle");
        if (!is_finite(as_double(max_edge)) || max_edge < 0.0f) return error::bad("max_edge");
        if (max_points > max_refined_points) return error::bad("max_points");
        return {};
    }

    [[nodiscard]] error operator()(const region& r, array_view<const triangle> cap, scratch& space,
                                   const refined_cap& out) const noexcept
    {
        if (error e = refused_options()) return e;
        double longest = 0.0;
        if (max_edge > 0.0f) {
            const double em = r.grid().cells * r.grid().units_per_em;
            longest = as_double(max_edge) * em;
            if (!(em > 0.0)) return error::bad("units_per_em");
            if (longest < 16.0) return error::bad("max_edge");
        }
        const auto limits = detail::refinement_limits::from(as_double(min_angle), longest, max_points);
        if (error e = space.run(r, cap, limits)) return e;
        out.kept = space.kept();
        return space.write(out);
    }
};
static_assert(refiner<delaunay_refined>);

}  // namespace typemesh::inline TYPEMESH_ABI
