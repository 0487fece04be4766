// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A glyph's number in its font; 0 is the font's own "missing glyph" (.notdef).
using glyph_id = std::uint32_t;

/// Where in the caller's text a glyph comes from: an offset in the caller's own units
/// (bytes of UTF-8, 16-bit units of UTF-16).
using cluster_id = std::uint32_t;

/// The caller's own number for how a glyph is painted: a material, a colour. The library sorts by it and hands it on,
/// no more.
enum class style_id : std::uint32_t {};

inline constexpr glyph_id no_glyph = 0xFFFF'FFFFu;      ///< no glyph has this number
inline constexpr cluster_id no_cluster = 0xFFFF'FFFFu;  ///< no place in a text
inline constexpr style_id no_style{0xFFFF'FFFFu};       ///< no style

}  // namespace typemesh::inline TYPEMESH_ABI
