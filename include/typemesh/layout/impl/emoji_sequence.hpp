// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether an emoji of several code points is drawn in parts: the font has no glyph for the whole, and its parts are
/// drawn one by one.
///
///     family     man, ZWJ, woman, ZWJ, girl     drawn as three people
///     flag       two regional indicators        drawn as two letters
///     skin tone  hand, modifier                 drawn as a hand and a swatch of colour
///     flag       black flag, tags               drawn as a black flag
///
///     text[first, last)   one grapheme; the result is false if it is not such an emoji
///     is_drawn(c)         whether the grapheme's glyphs include the font's glyph for the single character c
///
/// Cost: O(last - first)
template <class IsDrawn>
[[nodiscard]] bool has_fallen_apart(text_view text, std::size_t first, std::size_t last,
                                    const IsDrawn& is_drawn) noexcept
{
    using enum grapheme_class;
    char32_t base = 0;  // the picture or regional indicator before the others
    bool joined = false;
    for (std::size_t i = first; i < last;) {
        const code_point c = decode(text, i, last);
        i = c.next;
        const grapheme_class kind = character_of(c.value).grapheme;
        const bool modifier = c.value >= 0x1F3FB && c.value <= 0x1F3FF, tag = c.value >= 0xE0020 && c.value <= 0xE007F;
        const bool part = kind == regional_indicator || (kind == pictographic && !modifier);
        if (base != 0 && tag) return is_drawn(base);
        if (base != 0 && (modifier || (part && (joined || kind == regional_indicator))) && is_drawn(c.value))
            return true;
        if (part) base = c.value;
        joined = kind == zwj;
    }
    return false;
}

}  // namespace typemesh::inline TYPEMESH_ABI
