// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/class_set.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a character fills a square, like Han, kana, Bopomofo and their punctuation. It is wide, and it is not Hangul
/// (which has spaces between words), not an emoji and not a space.
[[nodiscard]] inline bool is_ideographic(char32_t value) noexcept
{
    using enum line_class;
    const character c = character_of(value);
    if (!c.wide || c.grapheme == grapheme_class::pictographic || c.bidi == bidi_class::ws) return false;
    return !class_set<line_class>{h2, h3, jl, jv, jt, eb, em, ri, picto, cm, zw}.holds(c.line);
}

}  // namespace typemesh::inline TYPEMESH_ABI
