// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A glyph's number in its font. Number 0 is the font's "missing glyph" (.notdef).
using glyph_id = std::uint32_t;

/// A glyph's place in the caller's text: an offset in the caller's units (bytes of UTF-8, 16-bit units of UTF-16).
using cluster_id = std::uint32_t;

/// The caller's number for the paint of a glyph: a material, a colour. The library sorts by this number and passes it
/// on; the number has no other meaning.
enum class style_id : std::uint32_t {};

inline constexpr glyph_id no_glyph = 0xFFFF'FFFFu;           ///< no glyph has this number
inline constexpr cluster_id no_cluster = 0xFFFF'FFFFu;       ///< no place in the text has this number
inline constexpr style_id no_style{0xFFFF'FFFFu};            ///< no style has this number
inline constexpr std::uint32_t not_a_letter = 0xFFFF'FFFFu;  ///< no letter, word or line has this number

}  // namespace typemesh::inline TYPEMESH_ABI
