// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/extrude/placement.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The position of a layered solid in the output.
struct layered_placement {
    placement at;           ///< maps the grid's cells to the plane of the output; heights are in output units
    bool mirrored = false;  ///< x is replaced by -x before `at` is applied, and the triangles stay outward

    /// The point of the plane where a point of the solid lies.
    [[nodiscard]] grid_point place(grid_point p) const noexcept { return {mirrored ? -p.x : p.x, p.y}; }
    /// The direction, in the text's own axes, of one in the solid's plane.
    [[nodiscard]] vec2 turn(vec2 v) const noexcept { return {mirrored ? -v.x : v.x, v.y}; }
    /// Whether triangles are written the other way round, so that they stay outward.
    [[nodiscard]] bool turns_triangles() const noexcept { return at.frame.turns_triangles() != mirrored; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
