// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that makes caps of its own and can have them refined (refinable_caps), such as bevelled:
///
///     e.uprights(filled)                   the faces that will stand upright on a region's edges
///     e.plan(filled, data, caps)           calls caps.divide(swept, heights), if there is such a function, between the
///                                          sweep for its slopes and the cap: see bevel_bisection
template <class E>
concept bendable_caps = refinable_caps<E> && requires(const E& e, const region& filled) {
    { e.uprights(filled) } noexcept -> std::same_as<upright_faces>;
};

/// An extruder whose solids can be bent.
template <class E>
concept bendable = refinable_extruder<E> || bendable_caps<E>;

}  // namespace typemesh::inline TYPEMESH_ABI
