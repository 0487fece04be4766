// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/unicode/text_range.hpp>
#include <typemesh/vertex/affine3.hpp>
#include <typemesh/vertex/bounds3.hpp>
#include <typemesh/vertex/frame.hpp>

#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// Why a letter moves as a whole although it is more than one glyph of one grapheme: a set, joined by |.
enum class letter_bond : std::uint8_t {
    none = 0,
    several_glyphs = 1u << 0,  ///< several glyphs show it, for example a base and its marks
    ligature = 1u << 1,        ///< one glyph or cluster shows several graphemes
    merged = 1u << 2,          ///< text_options::merge has made one solid of several letters
    joined = 1u << 3,          ///< letters of a script such as Arabic, which are written together
    bar = 1u << 4,             ///< no letter: an underline, a background or another bar
    inline_box = 1u << 5,      ///< an inline box stands here: the letter has no glyph of its own
};

[[nodiscard]] constexpr letter_bond operator|(letter_bond a, letter_bond b) noexcept
{
    return static_cast<letter_bond>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether a set contains a bond. With several bonds: whether it contains any of them.
[[nodiscard]] constexpr bool has(letter_bond set, letter_bond one) noexcept
{
    return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

/// The place about which a letter, word or line turns: its middle along the line, and across the line one of these. In
/// a text whose letters are bent, warped or turned by a path, it is always the centre.
enum class letter_pivot : std::uint8_t {
    baseline,  ///< on the baseline, or on the axis of a column, at the height of the front; see text_line::origin
    centre,    ///< the centre of its box in space
    line,      ///< the middle of the line's box, at the height of the front
};

/// The options of text_plan::find_letters().
struct letter_options {
    letter_pivot pivot = letter_pivot::baseline;
    bool keep_joins = true;          ///< whether letters that are written together, as in Arabic, are one letter
    bool attach_punctuation = true;  ///< whether punctuation belongs to the word that it touches; if false, words are
                                     ///< the segments of UAX #29
    bool down = false;               ///< whether the text was set in columns
};

/// The box of a letter, word or line. Directions follow the frame: width along `right`, height along `up`, depth
/// along `toward`.
struct letter_box {
    vec3 pivot = {};    ///< see letter_pivot; in the output's unit and frame, like the next two
    vec3 centre = {};   ///< the centre of the box in space
    vec3 extent = {};   ///< its width, height and depth
    box ink = {};       ///< the box in font units of the run, x along the text, y up
    float back = 0.0f;  ///< the heights between which it lies, along `toward`, in the output's unit
    float front = 0.0f;
};

/// A letter of a planned text: the smallest part of it that can move alone. Usually this is one grapheme that has an
/// outline. `bonds` says why it is more.
///
///     text         The [fi]sh e'     the ligature [fi] is one letter of two graphemes; e' is one, of two glyphs
///     letters      012   3 45 6      in reading order; spaces have no outline, so they are no letters
///     graphemes    012   4 67 9      in the text, spaces included
///
/// An inline box is a letter, too, as deep as the whole text. A bar goes with the letters of its line that stand over
/// or under it, from the first one to the last one in reading order.
struct text_letter : letter_box {
    text_range text = {};               ///< in units of the text; for a bar, the letters that it goes with
    std::uint32_t grapheme = 0;         ///< the number of its first grapheme, counted in the whole text
    std::uint32_t graphemes = 0;        ///< the number of its graphemes
    std::uint32_t grapheme_end = 0;     ///< one past the number of its last one; merged letters may have gaps
    std::uint32_t first_letter = 0;     ///< its own number; for a bar, of the first letter that it goes with
    std::uint32_t letters = 0;          ///< 1; for a bar, the number of letters that it goes with
    std::uint32_t word = not_a_letter;  ///< the number of its word: only words with letters count; not_a_letter for a
                                        ///< bar that goes with several words, or with none
    std::uint32_t line = 0;             ///< the number of its line in the run
    std::uint32_t paragraph = 0;        ///< the number of its paragraph in the text
    style_id style = {};                ///< of its first glyph
    letter_bond bonds = letter_bond::none;
    bounds3 bounds = {};  ///< of its vertices, like text_plan::bounds(); of an inline box, the box
};

/// A word, line or paragraph of letters, or all of them: letters [first, first + count) in reading order. Lines and
/// paragraphs without letters are empty. The pivot of several lines is on the baseline of the first one.
struct letter_group : letter_box {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The letters of a planned text: views of what its mesher keeps, valid as long as the plan is.
struct letter_rows {
    array_view<const text_letter> letters;  ///< in reading order
    array_view<const text_letter> bars;     ///< underlines and the like: attribute::letter is not_a_letter there
    array_view<const letter_group> words;
    array_view<const letter_group> lines;       ///< as many as the run has
    array_view<const letter_group> paragraphs;  ///< as many as the text has
    letter_group whole;                         ///< all letters
    std::uint32_t graphemes = 0;                ///< the number of graphemes in the text, spaces included
};

/// The argument of a motion: one letter, and where it stands in the text.
///
///     l.index, l.whole.count                      the number of the letter in the text, and of how many
///     l.index - l.word.first, l.word.count        in its word; likewise in its line and paragraph
///     l.letter.word, l.words                      the number of its word, and of how many
///
/// A motion that depends on l.line alone moves bars with their lines, and one that depends on l.word moves bars that go
/// with one word. What a motion of letters does to a bar over several letters is for the motion to decide.
struct letter_place {
    const text_letter& letter;
    const letter_group& word;  ///< empty for a bar that goes with several words, or with none
    const letter_group& line;
    const letter_group& paragraph;  ///< empty for a bar that goes with no letter
    const letter_group& whole;
    std::uint32_t index = not_a_letter;  ///< not_a_letter for a bar
    std::uint32_t words = 0;
    std::uint32_t lines = 0;
    std::uint32_t paragraphs = 0;
    std::uint32_t graphemes = 0;
    typemesh::frame frame = {};  ///< the output's: frame.up is the direction of the text's height

    /// Whether it is an underline, a background or another bar.
    [[nodiscard]] constexpr bool is_bar() const noexcept { return index == not_a_letter; }
};

/// Moves letters: gives each letter_place an affine3. It is called once for each letter in reading order, then once for
/// each bar; it must be noexcept, and the numbers of the map must be finite.
template <class M>
concept letter_motion = std::is_nothrow_invocable_r_v<affine3, M&, const letter_place&>;

}  // namespace typemesh::inline TYPEMESH_ABI
