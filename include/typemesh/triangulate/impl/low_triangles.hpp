// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/triangulate/impl/triangle_heights.hpp>
#include <typemesh/triangulate/impl/triangle_neighbours.hpp>
#include <typemesh/triangulate/impl/triangle_patch.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Flips edges until no avoidable low triangle remains (see triangle_heights.hpp).
///
///     a ------------ c ------------ b     c lies barely below the edge ab: the triangle is lower than a float's step,
///       '-._       low          _.-'      so rounding flips it over or flattens it. A cut along cd avoids it.
///            '-._           _.-'
///                 '-. d .-'
///
/// A low triangle is treated together with its neighbours: a polygon of 4 corners, then 6, 8, 11 and so on to 32,
/// always extended across the longest edge. Each polygon is retriangulated in the best way, until none of its triangles
/// is low. So a low triangle remains only if every triangulation of the 32 corners around it has one as low, or if the
/// budget is spent: 64 triangles examined per point and 2^15 more, including each pass over all of them. Counts, points
/// and the region's own edges do not change.
///
///     points, starts    as in contours
///     triangles         any triangulation of the region that they bound, counter-clockwise
///
/// Fails with error::out_of_memory; even then the triangles are a valid triangulation.
/// Cost    about 20 instructions per triangle if none is low, and little more if few are
/// Space   from `space`: none, or 32 bytes per triangle if very many are low
[[nodiscard]] inline error raise_low_triangles(array_view<const grid_point> points,
                                               array_view<const std::uint32_t> starts, const triangle_heights& heights,
                                               array_view<triangle> triangles, workspace& space) noexcept
{
    if (heights.doubled_area_of_low() == 0) return {};
    workspace::scope scratch{space};
    detail::triangle_neighbours neighbours{points.size(), starts, triangles};
    detail::triangle_patch patch{points, triangles, heights, neighbours};
    std::int64_t looks = 64 * static_cast<std::int64_t>(points.size()) + (1 << 15);
    for (bool again = true; again;) {
        again = false;
        looks -= static_cast<std::int64_t>(triangles.size());
        for (std::size_t t = 0; t < triangles.size() && looks > 0; ++t) {
            const triangle& at = triangles[t];
            if (!heights.is_low(points[at.a], points[at.b], points[at.c])) continue;
            if (!neighbours.prepare(scratch, space)) return error::out_of_memory;
            const auto [improved, clear] = patch.raise(static_cast<std::uint32_t>(t), looks);
            again |= improved && !clear;  // triangles that are still low may now be stored elsewhere
        }
    }
    return {};
}

/// The same for a triangulated region.
[[nodiscard]] inline error raise_low_triangles(const region& r, array_view<triangle> triangles,
                                               workspace& space) noexcept
{
    return raise_low_triangles(r.points(), r.starts(), triangle_heights{r.grid()}, triangles, space);
}

}  // namespace typemesh::inline TYPEMESH_ABI
