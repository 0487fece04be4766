// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/layout/alignment.hpp>
#include <typemesh/layout/line_break.hpp>
#include <typemesh/layout/shaper.hpp>

namespace typemesh {

/// How shaped lines are put together.
struct layout_options {
    alignment align = alignment::left;
    double line_spacing = 1.0;  ///< times the font's own distance between lines; any finite number
};

/// Sets a text: cuts it at its line breaks (line_break_at; they leave no glyph), has every line shaped and puts it in
/// its place.
///
///         x = 0, left-aligned                        columns go from right to left,
///     y = 0  |Hello                  <- baseline     the first is centred on x = 0    |   |
///            |                                                                        界  こ
///     y = -d |world!                                                                  !  ん
///
/// The distance d is ascender - descender + gap of the shaper's metrics (one em where they give nothing positive),
/// times line_spacing. A text has one line more than it has breaks: an empty text is one empty line. Spaces at a
/// line's ends count as a part of it.
///
///     run   emptied first; then glyphs, lines, units_per_em, and what was missing or invalid
///
/// Fails  error::bad_option: line_spacing is NaN or infinite
///        error::too_large: the text has more than 2^32 - 1 units
///        error::out_of_memory, and whatever the shaper says; `run` is then empty
/// Cost   O(n) beside the shaper's
template <shaper Shaper>
error layout(Shaper& shaper, text_view text, const shape_options& how, const layout_options& options,
             glyph_run& run) noexcept
{
    run.clear();
    if (!is_finite(options.line_spacing)) return error::bad("line_spacing");
    if (static_cast<std::uint64_t>(text.size()) > 0xFFFF'FFFFu) return error::too_large;

    const auto fail = [&run](error e) noexcept {
        run.clear();
        return e;
    };
    const bool vertical = how.direction == direction::top_to_bottom;
    run.units_per_em = shaper.units_per_em();
    const line_metrics metrics = shaper.metrics(how.direction);
    const double measured = metrics.ascender - metrics.descender + metrics.gap;
    const double distance = (measured > 0.0 ? measured : run.units_per_em) * options.line_spacing;

    std::size_t begin = 0;
    for (bool more = true; more;) {
        std::size_t end = begin, broken = 0;
        while (end < text.size() && (broken = line_break_at(text, end)) == 0) ++end;
        more = end < text.size();

        text_line line;
        line.first_glyph = static_cast<std::uint32_t>(run.glyphs.size());
        if (begin < end) {
            const auto way = shaper.shape(text, begin, end, how, run);
            if (!way) return fail(way.error());
            const double advance = vertical ? -(*way).y : (*way).x;
            line.advance = advance > 0.0 ? advance : 0.0;
        }
        if (run.glyphs.size() > 0xFFFF'FFFFu) return fail(error::too_large);
        line.glyph_count = static_cast<std::uint32_t>(run.glyphs.size()) - line.first_glyph;

        const double back = options.align == alignment::left     ? 0.0
                            : options.align == alignment::centre ? line.advance / 2
                                                                 : line.advance;
        const double across = 0.0 - distance * static_cast<double>(run.lines.size());
        line.origin = vertical ? point{across, back} : point{0.0 - back, across};
        if (!(line.origin == point{}))
            for (placed_glyph& g : run.glyphs.view().subspan(line.first_glyph)) g.origin = g.origin + line.origin;
        if (!run.lines.push_back(line)) return fail(error::out_of_memory);
        begin = end + broken;
    }
    return {};
}

}  // namespace typemesh
