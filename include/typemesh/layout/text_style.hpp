// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/column_options.hpp>
#include <typemesh/layout/feature.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// Bars drawn with a text: a set, joined by |. Each bar is a separate solid, as deep as the letters.
enum class decoration : std::uint8_t {
    none = 0,
    underline = 1u << 0,
    strike_through = 1u << 1,
    overline = 1u << 2,
};

[[nodiscard]] constexpr decoration operator|(decoration a, decoration b) noexcept
{
    return static_cast<decoration>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// Whether a set contains a decoration. With several decorations: whether it contains any of them.
[[nodiscard]] constexpr bool has(decoration set, decoration one) noexcept
{
    return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

/// Small letters above or below the others. If the font has letters of its own ("sups", "subs") for the whole range,
/// they are used; otherwise smaller letters, with the size and height that the font suggests.
enum class script_position : std::uint8_t { normal, superscript, subscript };

/// The style of a range of a text. Lengths are in em of the whole text, whatever `size` is here.
///
///     shaping    face, size, letter_spacing, features, language, position, column: where one of them changes, the text
///                is divided for shaping, so neither kerning nor ligatures cross the change
///     painting   all other members: they do not change the letters. A ligature, or any other text that a font keeps
///                together, is painted like its first character.
struct text_style {
    std::uint16_t face = 0;  ///< the number of the face among the shaper's faces
    double size = 1.0;       ///< multiplies the text's size; greater than 0. It changes neither the depth of solids nor
                             ///< the width of bevels
    double letter_spacing = 0.0;             ///< the letter spacing, in addition to the whole text's
    std::span<const feature> features = {};  ///< features, applied after the features of the whole text
    std::string_view language = {};          ///< the language; empty: the whole text's language
    script_position position = script_position::normal;
    column_style column = column_style::automatic;  ///< the orientation in columns; combined text takes one em

    double word_spacing = 0.0;  ///< the width added to every space
    double rise = 0.0;          ///< the rise of the baseline
    double slant = 0.0;         ///< the slant to the right, for each em upwards
    decoration decorations = decoration::none;
    style_id style = {};  ///< the caller's number for a material or colour
};

/// The style of text[first, last), in the text's units.
struct style_span {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    text_style style = {};
};

/// Whether text of both styles is shaped together.
[[nodiscard]] inline bool shaped_alike(const text_style& a, const text_style& b) noexcept
{
    if (a.face != b.face || !same(a.size, b.size) || !same(a.letter_spacing, b.letter_spacing)) return false;
    if (a.position != b.position || a.column != b.column) return false;
    if (a.language != b.language || a.features.size() != b.features.size()) return false;
    for (std::size_t i = 0; i < a.features.size(); ++i) {
        const feature &f = a.features[i], &g = b.features[i];
        if (std::string_view{f.tag, 4} != std::string_view{g.tag, 4} || f.value != g.value) return false;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
