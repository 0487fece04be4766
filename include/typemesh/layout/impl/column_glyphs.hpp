// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// The map for a letter that lies on its side in a column: it turns clockwise around the letter's own (0, 0), exactly.
inline constexpr affine quarter_turn{.xx = 0.0, .xy = 1.0, .yx = -1.0, .yy = 0.0};

/// The metrics of a shaper that decide the positions of glyphs in columns, in font units.
struct column_metrics {
    double middle = 0.0;  ///< column_middle_of(shaper)
    double em = 0.0;
    double gap = 0.0;  ///< added between combined letters
};

/// Lays an item's glyphs, shaped as in a line, on their side. The pen moves down, and the height column.middle above
/// the baseline is in the middle of the column. Draw the glyphs with quarter_turn.
inline void turn_glyphs(array_view<shaped_glyph> glyphs, const column_metrics& column) noexcept
{
    for (shaped_glyph& g : glyphs) {
        g.offset = {g.offset.y - column.middle, 0.0 - g.offset.x};
        g.flags = g.flags | glyph_flags::sideways;
    }
}

/// Puts an item's glyphs, shaped as in a line, side by side into the space of one character of a column. This space is
/// an em, and the gaps between the glyphs take at most half of it. The result is one cluster, which begins at `first`.
///
/// Returns the factor along x that makes the glyphs narrower: 1 if they fit.
inline double combine_glyphs(array_view<shaped_glyph> glyphs, const column_metrics& column, cluster_id first) noexcept
{
    double width = 0.0, letters = 0.0;
    for (const shaped_glyph& g : glyphs) {
        width += g.advance;
        if (g.advance > 0.0) letters += 1.0;
    }
    double gap = letters > 1.0 && column.gap > 0.0 ? column.gap : 0.0;
    if (gap * (letters - 1.0) > 0.5 * column.em) gap = 0.5 * column.em / (letters - 1.0);
    const double gaps = gap > 0.0 ? gap * (letters - 1.0) : 0.0;
    const double squeeze = width + gaps > column.em ? (column.em - gaps) / width : 1.0;
    const double baseline = -0.5 * column.em - column.middle;
    double pen = -0.5 * (squeeze * width + gaps);
    for (shaped_glyph& g : glyphs) {
        g.offset = {pen + squeeze * g.offset.x, baseline + g.offset.y};
        pen += squeeze * g.advance + (g.advance > 0.0 ? gap : 0.0);
        g.advance = 0.0;
        g.cluster = first;
        g.flags = g.flags | glyph_flags::combined;
    }
    if (!glyphs.empty()) glyphs.back().advance = column.em;
    return squeeze;
}

/// Moves an item's glyphs to their places in a column, according to its orientation. Other items do not change. Returns
/// the map for drawing the glyphs.
[[nodiscard]] inline affine place_in_column(array_view<shaped_glyph> glyphs, const text_item& item,
                                            const column_metrics& column) noexcept
{
    if (item.orientation == glyph_orientation::combined) return {.xx = combine_glyphs(glyphs, column, item.first)};
    if (item.orientation != glyph_orientation::sideways) return {};
    turn_glyphs(glyphs, column);
    return quarter_turn;
}

/// Appends an item's glyphs to a run, in a line or in a column. They start at the pen, which moves by their advances.
///
/// Fails  error::out_of_memory
inline error place_item(array_view<shaped_glyph> glyphs, const text_item& item, const column_metrics& column,
                        point& pen, glyph_run& run) noexcept
{
    const affine map = place_in_column(glyphs, item, column);
    const bool down = item.orientation != glyph_orientation::horizontal;
    placed_glyph* out = run.glyphs.append(glyphs.size());
    if (out == nullptr && !glyphs.empty()) return error::out_of_memory;
    for (const shaped_glyph& g : glyphs) {
        const bool missing = has(g.flags, glyph_flags::missing);
        *out++ = {g.id, g.cluster, pen + g.offset, missing, 0};
        if (missing) run.note_missing(g.cluster);
        if (has(g.flags, glyph_flags::parted)) run.note_parted(g.cluster);
        pen = pen + (down ? point{0.0, 0.0 - g.advance} : point{g.advance, 0.0});
        const auto glyph_style = run.number_of({.face = g.face, .map = map});
        if (!glyph_style) return glyph_style.error();
        (out - 1)->glyph_style = *glyph_style;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
