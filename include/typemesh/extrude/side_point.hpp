// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh {

/// What an extruder's plan() learnt about one contour point, kept so that writing need not compute it twice.
///
///        wall before        both normals lie in the plane, are of unit length and point away from the interior;
///     ──────────────●       they are equal where the point is soft.
///       interior    │ wall after
struct side_point {
    vec2 before;
    vec2 after;
    float along = 0.0f;     ///< length of the contour from its seam to this point, in grid cells
    bool doubled = false;   ///< has a vertex pair for each of its two walls
};

}  // namespace typemesh
