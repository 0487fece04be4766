// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_normals.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Normals that a cap and its walls share: the normalised sum of the unit normals of the cap and the two walls that
/// meet there; parts that are switched off do not count. Walls share the caps' vertices, 2N in all. The mesh is as
/// small as with cap_normals, but caps look like cushions, and walls fade from front to back. Texture coordinates are
/// the caps', planar, also on the walls.
struct shared_normals {
    static constexpr bool shares_caps = true;

    error operator()(const region& filled, array_view<side_point> sides) const noexcept
    {
        const auto points = filled.points();
        for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
            const std::uint32_t first = filled.starts()[loop], last = filled.starts()[loop + 1] - 1;
            vec2 before = rounded(wall_normal(points[last], points[first]));
            for (std::uint32_t i = first; i <= last; ++i) {
                const vec2 after = rounded(wall_normal(points[i], points[i == last ? first : i + 1]));
                sides[i].before = before;
                sides[i].after = after;
                before = after;
            }
        }
        return {};
    }
};
static_assert(side_normals<shared_normals>);

}  // namespace typemesh::inline TYPEMESH_ABI
