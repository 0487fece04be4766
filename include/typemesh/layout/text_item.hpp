// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The orientation of an item's glyphs relative to the line.
enum class glyph_orientation : std::uint8_t {
    horizontal,  ///< in a line that runs to the right or to the left
    upright,     ///< in a column, one below the other
    sideways,    ///< in a column, but shaped as in a line and turned clockwise: Latin between kanji
    combined,    ///< in a column, but shaped as in a line and put into the space of one character
};

/// A range of a text that is shaped at once. It has one level, one script and one style, no line breaks and no tabs. It
/// consists of whole graphemes.
struct text_item {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t script = 0;  ///< ISO 15924, its first letter in the highest byte ('Latn'); 0: none
    std::uint32_t style = 0;   ///< the index of its style in a table of the item's creator; 0: plain
    std::uint16_t face = 0;    ///< the face that shapes it first, if the shaper has several faces
    std::uint8_t level = 0;    ///< its level by UAX #9: odd levels are set from right to left
    glyph_orientation orientation = glyph_orientation::horizontal;
    double squeeze = 1.0;  ///< the factor that makes combined glyphs narrower, a result of shaping

    /// Whether the item is read from right to left.
    [[nodiscard]] constexpr bool to_the_left() const noexcept { return (level & 1u) != 0; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
