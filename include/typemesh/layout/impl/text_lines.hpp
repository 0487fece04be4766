// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/impl/bar_writer.hpp>
#include <typemesh/layout/impl/column_progress.hpp>
#include <typemesh/layout/impl/line_extent.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/layout/impl/line_writer.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>
#include <typemesh/layout/impl/stack_lines.hpp>
#include <typemesh/layout/laid_line.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/line_room.hpp>
#include <typemesh/unicode/text_analyser.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The part of shape_options that an analyser needs.
[[nodiscard]] inline analysis_options analysis_of(const shape_options& how) noexcept
{
    analysis_options reading{.language = how.language};
    const bool downwards = how.direction == direction::top_to_bottom && how.columns.latin == column_latin::upright;
    if (how.direction == direction::left_to_right || downwards) reading.direction = paragraph_direction::left_to_right;
    if (how.direction == direction::right_to_left) reading.direction = paragraph_direction::right_to_left;
    return reading;
}

/// A shaped text and its lines. Plain text (layout()) and paragraph share it; they differ only in where lines end.
///
///     read() -> shape() -> begin() -> for each line: fill `slices`, then add() -> stack() -> write()
///
/// Lengths are in font units. Memory is kept for the next text. Functions fail with error::out_of_memory, and as the
/// shaper does.
class text_lines {
public:
    explicit text_lines(memory source = heap()) noexcept
        : shaped{source}, slices{source}, lines_{source}, placed_{source}
    {
    }

    shaped_text shaped;
    line_slices slices;  ///< the content of the line that is being made

    void clear() noexcept
    {
        shaped.clear();
        forget();
    }

    /// Forgets the lines, but not the text.
    void forget() noexcept
    {
        lines_.clear();
        placed_.clear();
    }

    /// Analyses a text and cuts it into items; then shaped.shape() shapes them.
    ///
    /// Fails  also with error::bad_option and error::too_large, and as the analyser and style_spans::read() do
    template <shaper Font, text_analyser Analyser>
    error read(Font& font, Analyser& analyser, text_view text, const shape_options& how) noexcept
    {
        if (error e = refused_option(how)) return e;
        if (const std::uint64_t length = text.size(); length >= 0xFFFF'FFFFu) return error::too_large;
        if (error e = analyser.analyse(text, analysis_of(how), shaped.analysis)) return e;
        stack_ = how.direction != direction::top_to_bottom ? line_stack::downwards
                 : columns_go_right(text, how)             ? line_stack::rightwards
                                                           : line_stack::leftwards;
        return shaped.read(font, shaper_faces(font), text, how);
    }

    /// Measures a space, which is the unit of tab stops, and a digit. A text without tabs needs neither.
    template <shaper Font>
    error measure_tabs(Font& font) noexcept
    {
        space_ = digit_ = 0.0;
        bool tabs = false;
        for (const text_item& item : shaped.items()) tabs = tabs || shaped.text().unit(item.first) == 0x09;
        if (!tabs) return {};
        const auto space = shaped.advance_of(font, ' '), digit = shaped.advance_of(font, '0');
        if (!space || !digit) return space ? digit.error() : space.error();
        space_ = *space;
        digit_ = *digit;
        return {};
    }

    /// Begins a layout of the text: there are no lines yet.
    void begin(const layout_options& options) noexcept
    {
        forget();
        const double em = shaped.units_per_em();
        room_ = {.width = options.width * em,
                 .indent = options.indent * em,
                 .shrink = options.align == alignment::justify ? 0.25 : 0.0,
                 .tab = options.tab_width * space_,
                 .least_tab = least_tab(digit_),
                 .stops = options.tab_stops,
                 .stop_unit = em,
                 .max_lines = options.max_lines};
        longest_ = 0.0;
    }
    [[nodiscard]] const line_room& room() const noexcept { return room_; }

    /// The level of the paragraph that contains a unit of the text.
    [[nodiscard]] std::uint8_t level_at(std::uint32_t unit) const noexcept
    {
        if (shaped.analysis.paragraphs.empty()) return 0;
        return shaped.analysis.paragraph_of(unit).level;
    }

    /// Ends the line whose finished content is in `slices`: aligns it, and orders it from left to right.
    ///
    ///     text     its part of the text
    ///     level    the level of its paragraph
    ///     pen      the start of its pen, an indent
    ///     width    the width of its visible part
    error add(text_range text, std::uint8_t level, double pen, double width, alignment align) noexcept
    {
        if (pen + width > longest_) longest_ = pen + width;
        laid_line laid{.first = text.first,
                       .last = text.last,
                       .first_slice = static_cast<std::uint32_t>(placed_.size()),
                       .slices = static_cast<std::uint32_t>(slices.slices().size()),
                       .level = level,
                       .left = start_of(align, level % 2 != 0, pen, width),
                       .width = width > 0.0 ? width : 0.0};
        for (const line_slice& s : slices.slices().subspan(slices.visible())) laid.hanging += s.width;
        double at = laid.left;
        if (level % 2 != 0)
            for (const line_slice& s : slices.slices().subspan(slices.visible())) at -= s.width;
        slices.find_glyphs(shaped);
        order_visually(slices.slices());
        for (line_slice& s : slices.slices()) {
            s.at = at;
            at += s.width;
        }
        return lines_.push_back(laid) && placed_.append(slices.slices()) ? error{} : error::out_of_memory;
    }

    /// Puts the lines one below the other, or the columns beside each other.
    template <shaper Font>
    void stack(Font& font, const layout_options& options) noexcept
    {
        const line_metrics metrics = line_reach_of(font, shaped.options().direction);
        for (laid_line& line : lines_) {
            line.metrics = metrics;
            if (options.boxes == line_box::content) line.metrics = extent_of(font, shaped, slices_of(line), metrics);
        }
        height_ = stack_lines(lines_.view(), shaped.units_per_em(), options, stack_);
    }

    /// Writes the glyphs and bars of all lines to a run, which is empty.
    ///
    /// Fails  also with error::too_large; the run may then have some of them
    template <shaper Font>
    error write(Font& font, glyph_run& run) const noexcept
    {
        run.units_per_em = shaped.units_per_em();
        if (shaped.analysis.invalid_units != 0 && !lines_.empty())
            run.note_invalid_units(shaped.analysis.first_invalid_unit, shaped.analysis.invalid_units);
        line_writer writer{shaped, run};
        bar_writer<Font> bars{font, shaped, run};
        for (const laid_line& line : lines_) {
            const auto first = static_cast<std::uint32_t>(run.glyphs.size());
            for (const line_slice& s : slices_of(line))
                if (error e = writer.write(s, line.origin, s.at)) return e;
            if (error e = bars.write(line, slices_of(line))) return e;
            if (run.glyphs.size() > 0xFFFF'FFFFu) return error::too_large;
            const point along = shaped.in_columns() ? point{0.0, 0.0 - line.left} : point{line.left, 0.0};
            const auto count = static_cast<std::uint32_t>(run.glyphs.size()) - first;
            if (!run.lines.push_back({first, count, line.origin + along, line.width, line.hanging}))
                return error::out_of_memory;
        }
        return {};
    }

    [[nodiscard]] array_view<const laid_line> lines() const noexcept { return lines_.view(); }
    /// The slices of all lines, each line's from left to right.
    [[nodiscard]] array_view<const line_slice> placed() const noexcept { return placed_.view(); }
    /// The length of the longest line, and the extent of all lines together; see paragraph_size.
    [[nodiscard]] double longest() const noexcept { return longest_; }
    [[nodiscard]] double height() const noexcept { return height_; }

private:
    [[nodiscard]] array_view<const line_slice> slices_of(const laid_line& line) const noexcept
    {
        return placed_.view().subspan(line.first_slice, line.slices);
    }

    /// The start of a line, from its width. The line's pen starts at `pen`.
    [[nodiscard]] double start_of(alignment align, bool back, double pen, double width) const noexcept
    {
        if (align == alignment::start || align == alignment::justify) align = back ? alignment::right : alignment::left;
        if (align == alignment::end) align = back ? alignment::left : alignment::right;
        const double indent = back ? 0.0 : pen;
        if (align == alignment::left) return indent;
        const bool boxed = is_finite(room_.width);
        const double spare = boxed ? room_.width - pen - width : 0.0 - width - (back ? pen : 0.0);
        if (align == alignment::right) return (boxed ? indent : 0.0) + spare;
        return boxed ? indent + spare / 2 : 0.0 - width / 2;
    }

    buffer<laid_line> lines_;
    buffer<line_slice> placed_;
    line_room room_;
    double space_ = 0.0, digit_ = 0.0;  // their advances
    double longest_ = 0.0, height_ = 0.0;
    line_stack stack_ = line_stack::downwards;
};

}  // namespace typemesh::inline TYPEMESH_ABI
