// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/impl/column_progress.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/impl/line_places.hpp>
#include <typemesh/layout/impl/shape_line.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Lays out a text: cuts it at its line breaks (line_break_at; they have no glyphs), shapes and positions every line.
///
///         x = 0, left-aligned                        columns go from right to left;
///     y = 0  |Hello                  <- baseline     the first is centred on x = 0    |   |
///            |                                                                        C   A
///     y = -d |world!                                                                  D   B
///
/// Columns of Mongolian go from left to right (column_progress).
///
/// The distance d is ascender - descender + gap of the shaper's first face by line_reach_of() (one em if that is not
/// positive), times line_spacing. A text has one line more than it has breaks: an empty text is one empty line. Spaces
/// at a line's ends belong to the line. So do tabs, which move the pen to the next tab stop and have no glyphs (see
/// shape_line()). letter_spacing adds to the shaper's advances, see letter_spacing.hpp.
///
///     run   emptied first; it gets glyphs, lines, units_per_em, and counts of missing glyphs and invalid units
///
/// Fails  error::bad_option: line_spacing, tab_width or letter_spacing is NaN or infinite, or tab_width negative
///        error::too_large: the text has more than 2^32 - 1 units
///        error::out_of_memory, and any error of the shaper; `run` is then empty
/// Cost   O(n) plus the shaper's cost
template <shaper Shaper>
result<void> layout(Shaper& shaper, text_view text, const shape_options& how, const layout_options& options,
                    glyph_run& run) noexcept
{
    run.clear();
    if (error e = refused_option(options)) return e;
    if (const std::uint64_t length = text.size(); length > 0xFFFF'FFFFu) return error::too_large;

    const auto fail = [&run](error e) noexcept {
        run.clear();
        return e;
    };
    run.units_per_em = shaper.units_per_em();
    const line_places places{line_reach_of(shaper, how.direction), run.units_per_em, how.direction, options,
                             columns_go_right(text, how)};

    std::size_t begin = 0;
    for (bool more = true; more;) {
        std::size_t end = begin, broken = 0;
        while (end < text.size() && (broken = line_break_at(text, end)) == 0) ++end;
        more = end < text.size();

        text_line line;
        line.first_glyph = static_cast<std::uint32_t>(run.glyphs.size());
        if (begin < end) {
            const auto advance = shape_line(shaper, text, begin, end, how, options, run);
            if (!advance) return fail(advance.error());
            line.advance = places.advance(*advance);
        }
        if (run.glyphs.size() > 0xFFFF'FFFFu) return fail(error::too_large);
        line.glyph_count = static_cast<std::uint32_t>(run.glyphs.size()) - line.first_glyph;

        line.origin = places.origin(run.lines.size(), line.advance);
        if (!(line.origin == point{}))
            for (placed_glyph& g : run.glyphs.view().subspan(line.first_glyph)) g.origin = g.origin + line.origin;
        if (!run.lines.push_back(line)) return fail(error::out_of_memory);
        begin = end + broken;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
