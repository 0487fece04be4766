// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <concepts>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// How the walls of an extruded shape are lit, and so which contour points need a vertex pair for each of their two
/// walls.
///
///     S::shares_caps     true: walls stand on the caps' own vertices and have none themselves; `doubled` then means
///                        nothing
///     S::leaves_caps_alone   true, beside shares_caps: the caps' vertices keep the caps' normals, and the walls take
///                        them as they are; the sides are not asked for then. Need not be there
///     s(shape, sides)    fills before, after and doubled of sides[i] for every point i of shape.points();
///                        there are as many of one as of the other. Everything else has its default value.
///
/// Ready ones: cap_normals, shared_normals, averaged_normals, creased_normals, curve_normals. Options out of range are
/// error::bad_option, for an empty region as well.
template <class S>
concept side_normals = requires(const S& s, const region& shape, std::span<side_point> sides) {
    { S::shares_caps } -> std::convertible_to<bool>;
    { s(shape, sides) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
