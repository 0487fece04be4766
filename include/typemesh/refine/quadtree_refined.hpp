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
#include <typemesh/refine/impl/quadtree_refinement.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The refiner for triangles on a grid: adds the corners of squares, so that no edge is longer than max_edge. Use it
/// for meshes that will be displaced, or bent about an axis.
///
///     +-----------------+       +---+---+---+---+-+     The points inside lie on lines parallel to the axes, at
///     |                 |       | \ | / | \ | / |/|     multiples of a width from the glyph's origin. The width is
///     |                 |  -->  +---+---+---+---+-+     3/5 of max_edge, or a half, a quarter and so on of that where
///     |                 |       | / | \ | / | \ |\|     features are small. Two squares that share a side differ at
///     +-----------------+       +---+---+---+---+-+     most by a factor of two.
///
/// All inner edges are Delaunay. Triangles between squares of one width are right and isosceles; those between squares
/// of two widths have no angle below 26.5 degrees. Near the outline angles can be smaller: points that are added to an
/// edge keep two fifths of a square's width from its ends, and points inside keep that from the outline. An edge's
/// point lies on its curve, as in delaunay_refined.
///
/// The widths on all glyphs of a font are equal, unless the grids of the glyphs differ. refined_cap::kept counts the
/// triangles with a longer edge; it is usually 0.
///
/// Fails  error::bad_option: max_edge is not positive and finite, or below 32 cells on a glyph, or max_points is above
///        2^29 - 1 ("max_edge", "max_points"), or
///        the grid has no em ("units_per_em")
///        error::too_many_points: the glyph needs more than max_points
///        error::out_of_memory
/// Cost   O(1) on average for each point that is added
/// From   Bern, Eppstein & Gilbert: see impl/quadtree_refinement.hpp
struct quadtree_refined {
    float max_edge = 0.05f;                         ///< the length of the longest edge, in em
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one cap, 2^29 - 1 at most

    using scratch = detail::quadtree_refinement;  ///< keeps its memory for the next cap

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {max_edge, max_points}; }

    /// The error for options that are out of range on every glyph, or none.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(as_double(max_edge)) || !(max_edge > 0.0f)) return error::bad("max_edge");
        if (max_points > max_refined_points) return error::bad("max_points");
        return {};
    }

    [[nodiscard]] error operator()(const region& r, array_view<const triangle> cap, scratch& space,
                                   const refined_cap& out) const noexcept
    {
        if (error e = refused_options()) return e;
        const double em = r.grid().cells * r.grid().units_per_em, longest = as_double(max_edge) * em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        if (longest < 32.0) return error::bad("max_edge");
        detail::quadtree_limits limits;
        limits.max_points = max_points;
        limits.max_square = longest < grid::reach ? static_cast<std::int64_t>(longest * longest) : 0;
        limits.width = static_cast<std::int32_t>(longest < grid::reach ? 0.6 * longest : grid::reach);
        if (error e = space.run(r, cap, limits)) return e;
        out.kept = space.kept();
        return space.write(out);
    }
};
static_assert(refiner<quadtree_refined>);

}  // namespace typemesh::inline TYPEMESH_ABI
