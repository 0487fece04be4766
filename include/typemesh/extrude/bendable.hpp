// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A stand-in with which the concept bendable_caps is checked; it is never defined.
struct cap_refiner {
    /// Refines the region's own cap.
    error region_cap(std::uint32_t& added) noexcept;
    /// Refines another cap.
    error cap(buffer<grid_point>& points, array_view<const std::uint32_t> starts, buffer<triangle>& triangles,
              std::uint32_t& added) noexcept;
};

}  // namespace detail

/// An extruder that makes caps of its own and can have them refined, such as bevelled:
///
///     e.uprights(filled)                   the faces that will stand upright on a region's edges
///     e.plan(filled, data, caps)           calls caps.divide(swept, heights), if there is such a function, between the
///                                          sweep for its slopes and the cap: see bevel_bisection
///     e.refine_caps(refine, data, made)    after plan(): has each cap that it draws refined, and adds their points and
///                                          triangles to made.sizes. Each inner point adds two triangles
///     refine.region_cap(added)             refines the region's own cap. The points follow the region's points
///     refine.cap(points, starts, triangles, added)     refines another cap. Inner points are appended to its points,
///                                          and its triangles are replaced
template <class E>
concept bendable_caps = extruder<E> && requires(const E& e, detail::cap_refiner& refine, plan_data_of<E>& data,
                                                solid_plan& made, const region& filled) {
    { e.uprights(filled) } noexcept -> std::same_as<upright_faces>;
    { e.refine_caps(refine, data, made) } noexcept -> std::same_as<error>;
};

/// An extruder whose solids can be bent.
template <class E>
concept bendable = refinable_extruder<E> || bendable_caps<E>;

}  // namespace typemesh::inline TYPEMESH_ABI
