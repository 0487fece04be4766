// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <cstdint>
#include <limits>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The places where a line may end, in addition to the text's line breaks.
enum class wrap_mode : std::uint8_t {
    none,
    word,              ///< where Unicode allows it; a word that is too long sticks out
    word_or_grapheme,  ///< where Unicode allows it; a word that is too long is broken
    grapheme,          ///< after every grapheme
};

/// The side to which lines are aligned within the width. `start` is the left side in paragraphs that read to the right,
/// and the right side in all others.
enum class alignment : std::uint8_t {
    start,
    end,
    left,
    centre,
    right,
    justify,  ///< all lines except a paragraph's last get the full width if possible; others are aligned to the start
};

/// The way in which justified lines become wider. If this way is not possible, spaces become wider.
enum class justification : std::uint8_t {
    automatic,  ///< in lines with Chinese or Japanese, gaps beside ideographs and spaces grow equally; in all others,
                ///< spaces grow
    spaces,
    letters,  ///< all gaps between letters and all spaces grow equally; joined letters have no gaps
    kashida,  ///< strokes between joined letters of Arabic and related scripts grow, if the font allows it; then spaces
};

/// The part of the text at y = 0, or the text's position in a box that extends from y = 0 down by its height.
enum class vertical_anchor : std::uint8_t {
    first_baseline,
    last_baseline,
    top,     ///< the first line's ascender
    middle,  ///< halfway between the first line's ascender and the last line's descender
    bottom,
};

/// The part of a line that an ellipsis replaces.
enum class ellipsis_place : std::uint8_t { end, middle, start };

/// The height of lines.
enum class line_box : std::uint8_t {
    content,  ///< each line according to its content: large letters, and faces with other metrics, increase the
              ///< distance
    uniform,  ///< all lines are equally high: the first face's height for letters of size 1
};

/// The options for laying out a shaped text. Lengths are in em.
///
///     x = 0          x = width       With a width the text is in a box from x = 0 to x = width. Without a width, lines
///       |In the       |              lie at x = 0: to the right of it, around it, or to the left. A text can thus be
///       |beginning    |              placed by its anchor.
///
/// Plain text (layout(), text_mesher::plan(text)) ends lines only at the text's line breaks. A width with a wrap mode,
/// and an ellipsis, need a paragraph; plain text refuses them with error::needs_paragraph.
struct layout_options {
    double width = std::numeric_limits<double>::infinity();  ///< the width of a line, or the height of a column;
                                                             ///< greater than 0
    wrap_mode wrap = wrap_mode::word_or_grapheme;
    alignment align = alignment::start;
    justification justify = justification::automatic;  ///< how lines grow with alignment::justify
    vertical_anchor anchor = vertical_anchor::first_baseline;
    double height = 0.0;                     ///< the height of the box that top, middle and bottom refer to
    std::uint32_t max_lines = 0xFFFF'FFFFu;  ///< the greatest number of lines; further lines are dropped; 0 is refused
    text_view ellipsis = {};  ///< shown in place of text that is dropped or too wide; "..." if the font lacks one of
                              ///< its glyphs; empty: no ellipsis
    ellipsis_place elide = ellipsis_place::end;
    line_box boxes = line_box::content;
    double line_spacing = 1.0;               ///< multiplies the distance between lines that their boxes require
    double indent = 0.0;                     ///< the indent at the start of a paragraph's first line; a negative indent
                                             ///< hangs
    double tab_width = 4.0;                  ///< the distance between tab stops, in spaces; 0: no tab stops. See
                                             ///< tab_stop.hpp
    std::span<const double> tab_stops = {};  ///< the stops before the regular ones: ascending distances from a line's
                                             ///< start
};

/// The error for an option that is out of range; error::none if all are valid.
[[nodiscard]] inline error refused_option(const layout_options& options) noexcept
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
