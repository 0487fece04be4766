// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// The normals of walls. They decide which contour points need separate vertices for each of their two walls.
///
///     S::shares_caps     true: walls share the caps' vertices and have none of their own; `doubled` is then
///                        meaningless
///     S::leaves_caps_alone   optional, only with shares_caps: the caps' vertices keep the caps' normals, and the
///                        walls use them unchanged; the sides are then not requested
///     s(filled, sides)   sets before, after and doubled of sides[i] for every point i of filled.points(); both arrays
///                        are equally long. All other members have their default values.
///
/// The library has cap_normals, shared_normals, averaged_normals, creased_normals and curve_normals. Options out of
/// range give error::bad_option, also for an empty region.
template <class S>
concept side_normals = requires(const S& s, const region& filled, array_view<side_point> sides) {
    { S::shares_caps } -> std::convertible_to<bool>;
    { s(filled, sides) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
