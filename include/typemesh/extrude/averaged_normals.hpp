// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_normals.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Smooth normals: a wall vertex's normal is the normalised sum of the unit normals of its two walls. Corners therefore
/// look rounded, and flat walls beside them are shaded unevenly. Caps are flat. 4N vertices, and 2 for each contour's
/// seam (extruded.hpp).
struct averaged_normals {
    static constexpr bool shares_caps = false;

    error operator()(const region& filled, array_view<side_point> sides) const noexcept
    {
        const auto points = filled.points();
        for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
            const std::uint32_t first = filled.starts()[loop], last = filled.starts()[loop + 1] - 1;
            grid_point previous = points[last];
            point before = wall_normal(previous, points[first]);
            for (std::uint32_t i = first; i <= last; ++i) {
                const grid_point here = points[i], next = points[i == last ? first : i + 1];
                const point after = wall_normal(here, next);
                sides[i].before = sides[i].after = rounded(joint_normal(previous, here, next, before, after));
                previous = here;
                before = after;
            }
        }
        return {};
    }
};
static_assert(side_normals<averaged_normals>);

}  // namespace typemesh::inline TYPEMESH_ABI
