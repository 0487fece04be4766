// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/layout/text_item.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Turns items of a text into glyphs with advances, for whoever breaks lines: a paragraph.
///
///     s.units_per_em(), s.metrics(direction)   as in shaper
///     s.shape_item(text, item, o, glyphs)      appends the glyphs of text[item.first, item.last) in drawing order: to
///                                              the right, or down. Clusters ascend, from right to left they descend;
///                                              none is less than a base and its marks. What is not drawn may have no
///                                              glyph. The item's level decides the direction, whatever the letters
///                                              say, and o.direction is not read; its script is item.script unless
///                                              o.script names another. The text round the item is context: letters
///                                              join across its ends. The item may be any part of another, so a shaper
///                                              keeps nothing between two calls.
///                                              Only upright items are shaped as in a column, sideways and combined
///                                              ones as in a line: see column_glyphs.hpp.
///     s.has_vertical_form(c)                   only for columns: whether the font has another glyph of a character
///                                              for them; if a shaper cannot tell, none
///     s.column_middle()                        likewise: what height above the baseline stands in a column's middle
///                                              where letters lie on their side; by default half-way between ascender
///                                              and descender
///
/// Fails  error::needs_shaping: the shaper is not made for this script
///        error::out_of_memory, and whatever else it finds; `glyphs` may then hold some of the item's
template <class S>
concept item_shaper =
    requires(S& s, text_view text, const text_item& item, const shape_options& o, buffer<shaped_glyph>& glyphs) {
        { s.units_per_em() } noexcept -> std::convertible_to<double>;
        { s.metrics(o.direction) } noexcept -> std::same_as<line_metrics>;
        { s.shape_item(text, item, o, glyphs) } noexcept -> std::same_as<error>;
    };

/// s.has_vertical_form(c); false of a shaper that does not know.
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
