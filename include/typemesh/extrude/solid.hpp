// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// One planned shape, as an extruder gets it back to write it.
///
///     points, starts    the region's (region.hpp)
///     triangles         its cap, indices into points
///     sides             what the extruder's own plan() appended for it
struct solid {
    std::span<const grid_point> points;
    std::span<const std::uint32_t> starts;
    std::span<const triangle> triangles;
    std::span<const side_point> sides;
};

/// A solid and what its extruder's plan() said of it.
struct planned_solid {
    const solid& form;
    const part_sizes& sizes;
};

/// The index of a shape's first vertex in each part of the whole mesh.
using first_vertices = part_counts;

}  // namespace typemesh::inline TYPEMESH_ABI
