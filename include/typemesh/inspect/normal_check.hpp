// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/mesh_view.hpp>

#include <cmath>
#include <cstddef>
#include <functional>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The faults of a mesh's normals.
struct normal_check {
    std::size_t vertices = 0;         ///< the number of tested vertices: all vertices of the mesh
    std::size_t not_unit = 0;         ///< the number of normals that are not finite, or whose length differs too much
                                      ///< from 1
    double worst_length = 0.0;        ///< the largest difference of a finite normal's length from 1
    std::size_t triangles = 0;        ///< the number of triangles with an area: all drawable triangles should have one
    std::size_t against_winding = 0;  ///< the number of these triangles that face away from the sum of their corners'
                                      ///< normals
    std::size_t inward_corners = 0;   ///< the number of their corners whose normal does not point out of the triangle's
                                      ///< plane

    /// Whether all normals have unit length and point out of every wall and cap.
    [[nodiscard]] constexpr bool is_right() const noexcept
    {
        return not_unit == 0 && against_winding == 0 && inward_corners == 0;
    }
};

/// Compares normals with the winding of triangles.
///
///     normal     gets a vertex's normal: a member or a function, as for positions
///     winding    the frame's winding: +1 if dot(cross(b - a, c - a), n) is positive on the outside, -1 if it is
///                negative
///     allowed    the greatest difference of a length from 1: 1e-5 for 32-bit floats, more for packed formats
///
/// With shared_normals, a corner's normal may point into a wall by design, where three faces meet at a needle.
/// Cost   O(vertices + triangles)
template <class Vertex, class Index, class Position, class Normal>
[[nodiscard]] normal_check check_normals(const mesh_view<Vertex, Index, Position>& mesh, const Normal& normal,
                                         int winding = 1, double allowed = 1e-5) noexcept
{
    const auto normal_of = [&](std::size_t v) noexcept { return to_place(std::invoke(normal, mesh.vertex(v))); };
    normal_check found;
    found.vertices = mesh.vertex_count();
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const place n = normal_of(v);
        const double off = std::abs(std::sqrt(dot(n, n)) - 1.0);
        const bool finite = is_finite(n.x) && is_finite(n.y) && is_finite(n.z);
        if (!finite || off > allowed) ++found.not_unit;
        if (finite && off > found.worst_length) found.worst_length = off;
    }
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        if (!mesh.is_drawable(corners)) continue;
        const place a = mesh.position(corners[0]);
        const place face = cross(mesh.position(corners[1]) - a, mesh.position(corners[2]) - a);
        if (!(dot(face, face) > 0.0)) continue;
        ++found.triangles;
        double outward = 0.0;
        for (const std::size_t v : corners) {
            const double here = winding * dot(face, normal_of(v));
            if (!(here > 0.0)) ++found.inward_corners;
            outward += here;
        }
        if (!(outward > 0.0)) ++found.against_winding;
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
