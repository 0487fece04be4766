// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/bidi_class.hpp>
#include <typemesh/unicode/impl/character_table.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A character's class for line breaks: Line_Break of UAX #14 by its short names. Rule LB1 is applied as far as it
/// needs no language: AI, SG and XX are al. Some classes are split where a rule needs more details.
enum class line_class : std::uint8_t {
    al,        ///< letters and most symbols
    circle,    ///< the dotted circle: al that represents any letter of a Brahmic script
    al_picto,  ///< al, pictographic, not yet assigned
    bk,        ///< mandatory breaks; cr, lf, nl
    cr,
    lf,
    nl,
    sp,  ///< space
    zw,  ///< zero-width space
    cm,  ///< marks
    zwj,
    wj,  ///< word joiner
    gl,  ///< no-break space
    ba,  ///< break after
    bb,  ///< break before
    b2,  ///< em dash
    hy,  ///< hyphen-minus
    hh,  ///< other hyphens
    cb,  ///< an object in the text
    cl,  ///< closing punctuation
    cp,  ///< closing brackets
    ex,  ///< ! ?
    in,  ///< ellipses
    ns,  ///< not at the start of a line
    cj,  ///< small kana: ns in strict typesetting, id in loose typesetting
    op,  ///< opening brackets
    op_wide,
    qu,     ///< quotation marks that may open or close: " and '
    qu_pi,  ///< quotation marks that open, by their general category
    qu_pf,  ///< quotation marks that close
    is,     ///< . , : ;
    nu,     ///< digits
    po,     ///< % and similar characters, after numbers
    pr,     ///< $ and similar characters, before numbers
    sy,     ///< /
    hl,     ///< Hebrew letters
    id,     ///< ideographs
    eb,     ///< emoji that take a modifier
    em,     ///< emoji modifiers
    picto,  ///< id, pictographic, not yet assigned
    h2,     ///< Hangul syllables and jamo
    h3,
    jl,
    jv,
    jt,
    ak,       ///< letters of Brahmic scripts whose lines break between syllables: Balinese, Javanese, Cham and others
    as,       ///< such letters that take no stacking sign
    ap,       ///< letters before a syllable's first letter
    vf,       ///< signs that end a syllable
    vi,       ///< signs that stack the next letter
    ri,       ///< regional indicators
    sa,       ///< letters of scripts whose words need a dictionary: Thai, Lao, Khmer, Burmese, ...
    sa_mark,  ///< marks of these scripts
};

/// How a character joins its neighbours in a grapheme: Grapheme_Cluster_Break of UAX #29, with Indic_Conjunct_Break
/// (which splits the marks and the other characters) and Extended_Pictographic.
enum class grapheme_class : std::uint8_t {
    other,
    cr,
    lf,
    control,
    extend,      ///< marks
    linker,      ///< marks that join two consonants in a conjunct, such as viramas
    non_joiner,  ///< U+200C, a mark that separates them
    consonant,   ///< letters that form conjuncts
    zwj,
    regional_indicator,
    prepend,
    spacing_mark,
    l,  ///< leading jamo; v, t: vowels, trailing; lv, lvt: Hangul syllables
    v,
    t,
    lv,
    lvt,
    pictographic,
};

/// A character's orientation in a vertical line: Vertical_Orientation of UAX #50.
enum class vertical_orientation : std::uint8_t {
    rotated,              ///< turned clockwise by a quarter, like Latin
    upright,              ///< like ideographs
    transformed_rotated,  ///< by a vertical glyph, otherwise rotated
    transformed_upright,  ///< by a vertical glyph, otherwise upright
};

/// The Unicode properties of one code point, except its script (script.hpp).
struct character {
    bidi_class bidi;
    bracket_kind bracket;
    line_class line;
    grapheme_class grapheme;
    vertical_orientation orientation;
    bool wide;  ///< East_Asian_Width is wide, fullwidth or halfwidth
};

/// The properties of a code point, by three reads of a table of 21 kB. Beyond U+10FFFF, U+FFFD stands in.
[[nodiscard]] inline character character_of(char32_t c) noexcept
{
    using namespace detail;
    if (c > 0x10FFFF) c = 0xFFFD;
    const auto byte_of = [](const std::uint64_t* table, std::size_t i) noexcept {
        return static_cast<std::uint32_t>(table[i / 8] >> (i % 8 * 8) & 0xFF);
    };
    const std::uint32_t middle = byte_of(character_top, c >> 9) << 5 | (c >> 4 & 31);
    const auto leaf = static_cast<std::uint32_t>(character_middles[middle / 4] >> (middle % 4 * 16) & 0xFFFF);
    const std::uint32_t record = character_records[byte_of(character_leaves, leaf << 4 | (c & 15))];
    return {static_cast<bidi_class>(record & 0x3F),          static_cast<bracket_kind>(record >> 6 & 3),
            static_cast<line_class>(record >> 8 & 0x7F),     static_cast<grapheme_class>(record >> 16 & 0xFF),
            static_cast<vertical_orientation>(record >> 24), (record >> 15 & 1) != 0};
}

}  // namespace typemesh::inline TYPEMESH_ABI
