// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The shaper's notes on a glyph: a set, joined by |. The first two flags are equal for all glyphs of a cluster; they
/// concern the place in the text where the cluster begins.
enum class glyph_flags : std::uint8_t {
    none = 0,
    unsafe_to_break = 1u << 0,  ///< if a line ends here, both sides must be shaped again
    tatweel = 1u << 1,          ///< U+0640 may be inserted here to fill a line
    missing = 1u << 2,          ///< the font has no glyph for this text: the id is the font's .notdef
    sideways = 1u << 3,         ///< the glyph lies on its side, in a column
    combined = 1u << 4,         ///< the glyph is beside others, in a column
    parted = 1u << 5,           ///< the first glyph of an emoji that is drawn in parts: see glyph_run::parted
    box = 1u << 6,              ///< the place of an inline box, which has no glyph of the font
};

[[nodiscard]] constexpr glyph_flags operator|(glyph_flags a, glyph_flags b) noexcept
{
    return static_cast<glyph_flags>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// The flags that are in both sets.
[[nodiscard]] constexpr glyph_flags operator&(glyph_flags a, glyph_flags b) noexcept
{
    return static_cast<glyph_flags>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}

/// Whether a set contains a flag. With several flags: whether it contains any of them.
[[nodiscard]] constexpr bool has(glyph_flags set, glyph_flags one) noexcept
{
    return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

/// A glyph between shaping and layout: it has an advance but no position yet. Lengths are in the shaper's units, y up.
struct shaped_glyph {
    glyph_id id = 0;
    cluster_id cluster = 0;
    double advance = 0.0;    ///< the pen's move along the line: to the right, in columns down
    point offset = {};       ///< the vector from the pen to the glyph's own (0, 0)
    std::uint16_t face = 0;  ///< the face of the shaper that `id` belongs to
    glyph_flags flags = glyph_flags::none;
};

}  // namespace typemesh::inline TYPEMESH_ABI
