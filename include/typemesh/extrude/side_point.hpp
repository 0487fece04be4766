// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The results of an extruder's plan() for one contour point, stored so that writing need not compute them again.
///
///        wall before        both normals lie in the plane, are of unit length and point away from the interior.
///     --------------o       A point that is not doubled has one normal: `before` and `after` are equal
///       interior    |       (except with shared_normals, which adds the caps' own when it writes).
///                   | wall after
struct side_point {
    vec2 before;
    vec2 after;
    float along = 0.0f;    ///< the length of the contour from its seam to this point, in cells or in the texture
                           ///< mapping's measure; at the seam, the value for the wall before
    bool doubled = false;  ///< whether the point has a vertex pair for each of its two walls
    bool seam = false;     ///< whether `along` restarts for the wall after, as the mapping says; the point is then
                           ///< doubled
};

}  // namespace typemesh::inline TYPEMESH_ABI
