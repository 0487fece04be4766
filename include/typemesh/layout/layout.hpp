// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/shared_shaping.hpp>
#include <typemesh/layout/impl/text_lines.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/unicode/bidi_analyser.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The error for options that are out of range, or that only a paragraph supports; error::none if there are no such
/// options.
[[nodiscard]] inline error refused_in_plain_text(const layout_options& options) noexcept
{
    if (error e = refused_option(options)) return e;
    error e = error::needs_paragraph;
    e.option = is_finite(options.width) && options.wrap != wrap_mode::none ? "width" : "ellipsis";
    return e.option[0] == 'w' || !options.ellipsis.empty() ? e : error{};
}

/// Lays out plain text: a text whose lines end only at its line breaks (line feeds, U+2028 and the like; they have no
/// glyphs). With these options, a paragraph of sufficient width gives an identical run.
///
///         x = 0, aligned to the start                columns go from right to left;
///     y = 0  |Hello                  <- baseline     the first is centred on x = 0    |   |
///            |                                                                        C   A
///     y = -d |world!                                                                  D   B
///
/// Columns of Mongolian go from left to right. Lines that are read from right to left also start at x = 0, and extend
/// to the left. The distance d is ascender - descender + gap of the fonts in the lines (one em if that is not
/// positive), times line_spacing. A text has one line more than it has breaks: an empty text is one empty line. Spaces
/// at a line's end hang: they do not count for the line's alignment. A tab moves the pen to the next tab stop and has
/// no glyph.
///
/// It keeps its memory for the next text.
class plain_layout {
public:
    explicit plain_layout(memory source = heap()) noexcept : analyser_{source}, text_{source}, shared_{source} {}

    ///     run     emptied first; it gets glyphs, lines, units_per_em, and counts of missing glyphs and invalid units
    ///     team    null, or workers that shape the items of the text, each with its own shaper: see shaping_team. The
    ///             result is the same.
    ///
    /// Fails  error::bad_option; error::needs_paragraph: an option is only for paragraphs
    ///        error::too_large: the text has more than 2^32 - 2 units
    ///        error::out_of_memory, and any error of the shaper; `run` is then empty
    /// Cost   O(n) plus the shaper's cost
    template <shaper Shaper, shaping_team Team = no_team>
    result<void> operator()(Shaper& shaper, text_view text, const shape_options& how, const layout_options& options,
                            glyph_run& run, Team* team = nullptr) noexcept
    {
        run.clear();
        error e = refused_in_plain_text(options);
        if (!e) e = text_.read(shaper, analyser_, text, how);
        if (!e && team != nullptr) e = team->shape(shared_, text_.shaped);
        if (!e) e = text_.shaped.shape(shaper, team != nullptr ? shared_.items() : array_view<const shaped_item>{});
        if (!e) e = text_.measure_tabs(shaper);
        if (!e) e = lay_out(shaper, options, run);
        if (e) run.clear();
        return e;
    }

private:
    template <shaper Shaper>
    error lay_out(Shaper& shaper, const layout_options& options, glyph_run& run) noexcept
    {
        text_.begin(options);
        if (error e = find_lines(options.align)) return e;
        text_.stack(shaper, options);
        return text_.write(shaper, run);
    }

    /// Makes the lines, which end at items that are line breaks.
    error find_lines(alignment align) noexcept
    {
        const shaped_text& shaped = text_.shaped;
        const array_view<const text_item> items = shaped.items();
        const text_view text = shaped.text();
        const line_room& room = text_.room();
        bool begins = true;  // a paragraph
        std::size_t first = 0;
        for (std::uint32_t lines = 0; lines < room.max_lines; ++lines) {
            std::size_t last = first;
            while (last < items.size() && line_end_at(text, items[last].first) == 0) ++last;
            const bool more = last < items.size();
            if (more) ++last;
            const auto size = static_cast<std::uint32_t>(text.size());
            const text_range units{first < items.size() ? items[first].first : size,
                                   more ? items[last - 1].last : size};
            const std::uint32_t from = first < items.size() ? shaped.first_cluster(first) : shaped.cluster_count();
            const std::uint32_t to = last > first ? shaped.end_cluster(last - 1) : from;
            const std::uint8_t level = text_.level_at(units.first);
            const double pen = room.start(begins);
            text_.slices.clear();
            if (error e = text_.slices.append_text(shaped, from, to)) return e;
            const auto width = text_.slices.finish(shaped, level, pen, room);
            if (!width) return width.error();
            if (error e = text_.add(units, level, pen, *width, align)) return e;
            if (!more) return {};
            begins = ends_paragraph(decode(text, items[last - 1].first).value);
            first = last;
        }
        return {};
    }

    bidi_analyser analyser_;
    text_lines text_;
    shared_shaping shared_;
};

/// Lays out one plain text: see plain_layout, which keeps its memory for the next text.
template <shaper Shaper>
result<void> layout(Shaper& shaper, text_view text, const shape_options& how, const layout_options& options,
                    glyph_run& run) noexcept
{
    plain_layout once{run.glyphs.source()};
    return once(shaper, text, how, options, run);
}

}  // namespace typemesh::inline TYPEMESH_ABI
