// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The bounding box of all vertices, in the caller's frame and unit. Both corners are zero for an empty mesh.
struct bounds3 {
    vec3 low;
    vec3 high;

    /// Extends the box to contain p.
    constexpr void add(vec3 p) noexcept
    {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
    }

    /// Whether a point lies in it; NaN counts as inside.
    [[nodiscard]] constexpr bool holds(vec3 p) const noexcept
    {
        return !(p.x < low.x || p.y < low.y || p.z < low.z || p.x > high.x || p.y > high.y || p.z > high.z);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
