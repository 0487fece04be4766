// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A position on a variation axis in normalised coordinates, in units of 1/16384: -16384 to 16384, 0 is the font's
/// default. Fonts store these integers (F2Dot14), and a font can be set to no position between two of them. The font's
/// 'avar' table has been applied.
using axis_coordinate = std::int32_t;

/// One axis of a variable font, such as its weight: a font that can be set to any position of the axis, while its other
/// axes stay as they are. harfbuzz_axis is one.
///
///     a.low(), a.usual(), a.high()   the ends of the axis and its default, in the axis's own unit, for example 100,
///                                    400, 900
///     a.coordinate(value)            the coordinate of such a value, which is clamped to the ends
///     a.append_masters(out)          appends the coordinates where anything may stop changing evenly: outlines,
///                                    advances, kerning; in any order, also more than once. Between two neighbours of
///                                    the list everything that varies is linear
///     a.append_changes(out)          appends the coordinates c where glyphs may be replaced by others between c - 1
///                                    and c, likewise
///     a.move_to(c)                   sets the font to a coordinate
///     a.font()                       the font at the coordinate of the last move_to()
template <class A>
concept variation_axis = requires(A& a, double value, axis_coordinate c, buffer<axis_coordinate>& out) {
    { a.low() } noexcept -> std::same_as<double>;
    { a.usual() } noexcept -> std::same_as<double>;
    { a.high() } noexcept -> std::same_as<double>;
    { a.coordinate(value) } noexcept -> std::same_as<axis_coordinate>;
    { a.append_masters(out) } noexcept -> std::same_as<error>;
    { a.append_changes(out) } noexcept -> std::same_as<error>;
    { a.move_to(c) } noexcept -> std::same_as<error>;
    requires outline_source<std::remove_reference_t<decltype(a.font())>>;
    requires shaper<std::remove_reference_t<decltype(a.font())>>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
