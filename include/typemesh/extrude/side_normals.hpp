// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// How walls are lit, and so which contour points need a vertex pair for each of their two walls.
///
///     S::shares_caps     true: walls share the caps' vertices and have none of their own; `doubled` is then
///                        meaningless
///     S::leaves_caps_alone   optional, true beside shares_caps: the caps' vertices keep the caps' normals, and the
///                        walls take them as they are; the sides are then not requested
///     s(filled, sides)   fills in before, after and doubled of sides[i] for every point i of filled.points(); there
///                        are as many of one as of the other. Everything else has its default value.
///
/// Ready ones: cap_normals, shared_normals, averaged_normals, creased_normals, curve_normals. Options out of range are
/// error::bad_option, for an empty region as well.
template <class S>
concept side_normals = requires(const S& s, const region& filled, array_view<side_point> sides) {
    { S::shares_caps } -> std::convertible_to<bool>;
    { s(filled, sides) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
