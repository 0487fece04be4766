// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/mesh_view.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The size of a mesh, in its own unit.
struct mesh_measure {
    double area = 0.0;    ///< the area of all triangles together
    double volume = 0.0;  ///< the volume that a closed mesh encloses; negative if the mesh is inside out. Meaningless
                          ///< for an open mesh
};

/// Measures the area and the volume of a mesh. In a right-handed frame with counter-clockwise triangles the volume is
/// positive; a left-handed frame changes its sign, and so do clockwise triangles (see vertex/frame.hpp). Triangles that
/// are not drawable have no size.
///
/// Cost   O(triangles); rounded like any sum in double precision
template <class Vertex, class Index, class Position>
[[nodiscard]] mesh_measure measure(const mesh_view<Vertex, Index, Position>& mesh) noexcept
{
    mesh_measure sum;
    place origin;  // a corner of the mesh: keeps the terms small far from (0, 0, 0)
    bool begun = false;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        if (!mesh.is_drawable(corners)) continue;
        if (!begun) origin = mesh.position(corners[0]);
        begun = true;
        const place a = mesh.position(corners[0]) - origin, b = mesh.position(corners[1]) - origin,
                    c = mesh.position(corners[2]) - origin;
        const place normal = cross(b - a, c - a);
        sum.area += 0.5 * std::sqrt(dot(normal, normal));
        sum.volume += dot(a, cross(b, c)) / 6.0;
    }
    return sum;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
