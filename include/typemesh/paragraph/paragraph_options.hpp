// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <cstdint>
#include <limits>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Where a line may end, besides where the text demands it.
enum class wrap_mode : std::uint8_t {
    none,
    word,              ///< where Unicode allows it; a word that is too long sticks out
    word_or_grapheme,  ///< likewise, but such a word is broken
    grapheme,          ///< behind every grapheme
};

/// To which side of the width lines are set. Start is left where a paragraph is read to the right, else right.
enum class line_alignment : std::uint8_t {
    start,
    end,
    left,
    centre,
    right,
    justify,  ///< every line but a paragraph's last is made as wide as the width; what cannot be stands at the start
};

/// What makes justified lines wider. Where it cannot, spaces do.
enum class justification : std::uint8_t {
    automatic,  ///< in lines with Chinese or Japanese, distances beside ideographs and spaces alike; in others, spaces
    spaces,
    letters,  ///< all distances between letters and spaces alike, but for letters that are written joined
    kashida,  ///< where the font allows, strokes between joined letters of Arabic and its kin; spaces the rest
};

/// What stands at y = 0, or where the text stands in a box from there down by its height.
enum class vertical_anchor : std::uint8_t {
    first_baseline,
    last_baseline,
    top,     ///< the first line's ascender
    middle,  ///< half-way between the first line's ascender and the last one's descender
    bottom,
};

/// Which part of a line gives way to an ellipsis.
enum class ellipsis_place : std::uint8_t { end, middle, start };

/// How high lines are.
enum class line_box : std::uint8_t {
    content,  ///< each as what stands in it: large letters, and faces with other metrics, move lines apart
    uniform,  ///< all as the first face says for letters of size 1
};

/// How a shaped text is laid out. Lengths are in em.
///
///     x = 0          x = width       With a width the text stands in a box from x = 0 to there. Without one lines
///       |In the       |              stand at x = 0, as with layout(): to its right, round it, or to its left.
///       |beginning    |
struct paragraph_options {
    double width = std::numeric_limits<double>::infinity();  ///< of a line, in columns their height; more than 0
    wrap_mode wrap = wrap_mode::word_or_grapheme;
    line_alignment align = line_alignment::start;
    justification justify = justification::automatic;  ///< for line_alignment::justify
    vertical_anchor anchor = vertical_anchor::first_baseline;
    double height = 0.0;                     ///< of the box that top, middle and bottom refer to
    std::uint32_t max_lines = 0xFFFF'FFFFu;  ///< further ones are dropped, 0 is refused
    text_view ellipsis = {};  ///< for what is dropped or too wide, "..." where a glyph is missing; empty: none
    ellipsis_place elide = ellipsis_place::end;
    line_box boxes = line_box::content;
    double line_spacing = 1.0;               ///< times the distance between lines that their boxes ask for
    double indent = 0.0;                     ///< of a paragraph's first line, at its start; negative ones hang
    double tab_width = 4.0;                  ///< between tab stops, in spaces; 0: none. See tab_stop.hpp
    std::span<const double> tab_stops = {};  ///< before those: ascending, from a line's start
};

/// The error of an option that is out of range, or none.
[[nodiscard]] inline error refused_option(const paragraph_options& options) noexcept
{
    if (!(options.width > 0.0)) return error::bad("width");
    if (!is_finite(options.height) || options.height < 0.0) return error::bad("height");
    if (options.max_lines == 0) return error::bad("max_lines");
    if (!is_finite(options.line_spacing)) return error::bad("line_spacing");
    if (!is_finite(options.indent)) return error::bad("indent");
    if (!is_finite(options.tab_width) || options.tab_width < 0.0) return error::bad("tab_width");
    double before = 0.0;
    for (const double stop : options.tab_stops) {
        if (!is_finite(stop) || !(stop > before)) return error::bad("tab_stops");
        before = stop;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
