// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// A font's line metrics, in font units, y up.
///
///     ascender  ----------------   positive            horizontal: the distance between baselines is
///     baseline  --A-g----------   0                    ascender - descender + gap
///     descender ----------------   negative            vertical: x to the right; columns are that far apart, or
///                                                      further: see line_reach_of()
struct line_metrics {
    double ascender = 0.0;
    double descender = 0.0;
    double gap = 0.0;
};

/// Turns items of a text into glyphs with advances: HarfBuzz, or your own shaper. layout() and paragraph divide the
/// text into items and position the glyphs.
///
///     s.units_per_em()                    as in outline_source
///     s.metrics(direction)                the font's line metrics, for horizontal or vertical lines
///     s.shape(text, item, o, glyphs)      appends the glyphs of text[item.first, item.last) in drawing order: to the
///                                         right, or down. Clusters are offsets from the start of `text`, in its units.
///                                         They ascend, or descend if the item is read from right to left. A cluster is
///                                         at least a base and its marks. Invisible characters may have no glyph. A
///                                         glyph that the font lacks is flagged as missing. The item's level decides
///                                         the direction, whatever its letters are. The script is item.script unless
///                                         o.script names another. The text around the item is context: letters join
///                                         across the item's ends. A later call may shape any part of an item again, so
///                                         a shaper keeps no state between two calls. Only upright items are shaped as
///                                         in a column; sideways and combined items are shaped as in a line,
///                                         and the library turns and moves their glyphs.
///     s.has_vertical_form(c)              only for columns: whether the font has a special glyph of a character for
///                                         columns; without this function, no character has one
///     s.column_middle()                   only for columns: the height above the baseline that is in the middle of a
///                                         column if letters lie on their side. By default it is halfway between
///                                         ascender and descender.
///
/// Fails  error::needs_shaping: the shaper does not support this script or this direction. It never draws in the wrong
///                              order.
///        error::out_of_memory, and any other error of the shaper; `glyphs` may then have some of the item's glyphs
template <class S>
concept shaper =
    requires(S& s, text_view text, const text_item& item, const shape_options& o, buffer<shaped_glyph>& glyphs) {
        { s.units_per_em() } noexcept -> std::convertible_to<double>;
        { s.metrics(o.direction) } noexcept -> std::same_as<line_metrics>;
        { s.shape(text, item, o, glyphs) } noexcept -> std::same_as<error>;
    };

/// s.has_vertical_form(c), or false if the shaper does not know.
template <class S>
[[nodiscard]] bool vertical_form_of(S& s, char32_t c) noexcept
{
    if constexpr (requires {
                      { s.has_vertical_form(c) } noexcept -> std::same_as<bool>;
                  })
        return s.has_vertical_form(c);
    else
        return static_cast<void>(s), static_cast<void>(c), false;
}

/// s.column_middle(), or its default.
template <class S>
[[nodiscard]] double column_middle_of(S& s) noexcept
{
    if constexpr (requires {
                      { s.column_middle() } noexcept -> std::same_as<double>;
                  })
        return s.column_middle();
    else {
        const line_metrics of_lines = s.metrics(direction::left_to_right);
        return (of_lines.ascender + of_lines.descender) / 2;
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
