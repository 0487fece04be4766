// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Turns a glyph id into an outline: a font, or your own set of drawings.
///
///     s.units_per_em()      font units per em; positive
///     s.fill()              the fill rule of the outline drawn last; it is called after outline(). Fonts use non_zero
///     s.outline(id, sink)   draws a glyph by calls of the sink (any outline_sink). For a blank glyph it makes no calls
///                           and returns no error. If the glyph does not exist or cannot be loaded, it returns
///                           error::unknown_glyph.
///     s.variation_key()     optional: a number of 64 bits for the state in which the source draws (the axes of a
///                           variable font, a transformation). A glyph_cache keeps the glyphs of different states apart
template <class S>
concept outline_source = requires(S& s, glyph_id id, ignore_outline& sink) {
    { s.units_per_em() } noexcept -> std::convertible_to<double>;
    { s.fill() } noexcept -> std::same_as<fill_rule>;
    { s.outline(id, sink) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
