// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/impl/shaped_text.hpp>
#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/class_set.hpp>
#include <typemesh/unicode/utf.hpp>

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

/// Whether a line of Chinese or Japanese grows after a cluster: at a space, and beside an ideograph.
///
///     |han|han|comma|abc def|han|      grows at each | inside the line and at the space
[[nodiscard]] inline bool has_ideograph_gap(const shaped_text& shaped, const text_cluster& c) noexcept
{
    if (has(c.flags, cluster_flags::stretches)) return true;
    if (c.glyph_count == 0 || has(c.flags, cluster_flags::unshown | cluster_flags::foreign)) return false;
    const text_view text = shaped.text();
    if (c.last >= text.size() || has(shaped.analysis.marks[c.last], text_mark::space)) return false;
    return is_ideographic(decode(text, c.first).value) || is_ideographic(decode(text, c.last).value);
}

}  // namespace typemesh::inline TYPEMESH_ABI
