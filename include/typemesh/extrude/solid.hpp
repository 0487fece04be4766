// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/part_sizes.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One planned solid, which is passed back to its extruder for writing.
///
///     points, starts    the region's (region.hpp)
///     triangles         its cap, indices into points
struct solid {
    array_view<const grid_point> points;
    array_view<const std::uint32_t> starts;
    array_view<const triangle> triangles;
};

/// A solid with the plan data that the extruder's own plan() left: see plan_arrays.hpp.
template <class Data>
struct solid_with : solid {
    typename Data::view data;
};

/// The result of an extruder's plan() for a solid: its exact sizes, its extent in the plane, and the counts for a
/// text_report.
///
/// The box `around` bounds everything that will be written, in cells. If it is empty, the box of the region's points is
/// used.
struct solid_plan {
    part_sizes sizes;
    box around = {};
    box textured = {};                 ///< the box that textures span, in cells, if it is not that box
    bool narrowed = false;             ///< whether its edges moved less than wanted, because at the full distance they
                                       ///< were not proven simple, or less than half as far in order to fit
    bool touching = false;             ///< whether corners touch that should have been separated or joined, or front
                                       ///< and back meet inside the outline
    std::uint32_t corners_moved = 0;   ///< the number of corners that were separated or joined; see contours::corners
    std::uint32_t lost_caps = 0;       ///< the number of components smaller than a tolerance that have no cap in spite
                                       ///< of bevel_mode::fit
    std::uint32_t kept_triangles = 0;  ///< the number of triangles of its caps that miss a refiner's aim: see
                                       ///< refined_cap::kept; those that front and back share count once
};

/// A solid with the result of its extruder's plan().
template <class Data>
struct planned_solid {
    solid_with<Data> form;
    const solid_plan& plan;
};

/// The index of a solid's first vertex in each part of the whole mesh.
using first_vertices = part_counts;

}  // namespace typemesh::inline TYPEMESH_ABI
