// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/layout/impl/reading_order.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/letter_spacing.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/layout/tab_stop.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Whether the glyphs of a run from `glyph` on have their clusters in [first, last) of the text. For TYPEMESH_ASSERT.
[[nodiscard]] inline bool come_from(const glyph_run& run, std::size_t glyph, std::size_t first,
                                    std::size_t last) noexcept
{
    for (; glyph < run.glyphs.size(); ++glyph)
        if (run.glyphs[glyph].cluster < first || run.glyphs[glyph].cluster >= last) return false;
    return true;
}

/// The number of glyphs of a run from `glyph` on that are flagged as missing. For TYPEMESH_ASSERT.
[[nodiscard]] inline std::size_t missing_from(const glyph_run& run, std::size_t glyph) noexcept
{
    std::size_t missing = 0;
    for (; glyph < run.glyphs.size(); ++glyph) missing += run.glyphs[glyph].missing ? 1u : 0u;
    return missing;
}

/// Calls shaper.shape(text, first, last, how, run) and checks its guarantees.
template <shaper Shaper>
result<point> shape_segment(Shaper& shaper, text_view text, std::size_t first, std::size_t last,
                            const shape_options& how, glyph_run& run) noexcept
{
    [[maybe_unused]] const std::size_t glyphs = run.glyphs.size(), missing = run.missing;
    const result<point> advance = shaper.shape(text, first, last, how, run);
    TYPEMESH_ASSERT(!advance || come_from(run, glyphs, first, last),
                    "a shaper gave a glyph a cluster outside the range of text that it had to shape");
    TYPEMESH_ASSERT(!advance || missing_from(run, glyphs) == run.missing - missing,
                    "a shaper must flag each missing glyph and count it in the run");
    return advance;
}

/// The advance of an ASCII character along a line. The run stays unchanged.
template <shaper Shaper>
result<double> advance_of(Shaper& shaper, char character, const shape_options& how, glyph_run& run) noexcept
{
    const std::size_t glyphs = run.glyphs.size();
    const auto missing = run.missing;
    const auto first_missing = run.first_missing;
    const result<point> advance = shaper.shape(std::string_view{&character, 1}, 0, 1, how, run);
    run.glyphs.truncate(glyphs);
    run.missing = missing;
    run.first_missing = first_missing;
    if (!advance) return advance.error();
    return how.direction == direction::top_to_bottom ? -advance->y : advance->x;
}

/// The direction of a line, for the parts between its tabs: the requested direction, otherwise the direction of its
/// first letter. A line without letters has none.
[[nodiscard]] inline direction direction_of(direction wanted, const line_reading& line) noexcept
{
    if (wanted != direction::automatic || line.to_the_left == line.to_the_right) return wanted;
    return line.to_the_left < line.to_the_right ? direction::right_to_left : direction::left_to_right;
}

inline void reverse(array_view<placed_glyph> glyphs) noexcept
{
    for (std::size_t i = 0, k = glyphs.size(); i + 1 < k; ++i) swap_values(glyphs[i], glyphs[--k]);
}

}  // namespace detail

namespace detail {

/// Shapes text[first, last) and spaces its letters.
template <shaper Shaper>
result<point> shape_spaced(Shaper& shaper, text_view text, std::size_t first, std::size_t last,
                           const shape_options& how, const layout_options& options, glyph_run& run) noexcept
{
    if (is_zero(options.letter_spacing)) return shape_segment(shaper, text, first, last, how, run);
    shape_options single = how;
    single.ligatures = false;  // the letters of a ligature would be closer to each other than to the rest
    const std::size_t before = run.glyphs.size();
    const result<point> advance = shape_segment(shaper, text, first, last, single, run);
    if (!advance) return advance;
    const bool down = how.direction == direction::top_to_bottom;
    const double longer = space_letters(text, last, options.letter_spacing * shaper.units_per_em(), down,
                                        run.glyphs.view().subspan(before));
    return *advance + (down ? point{0.0, 0.0 - longer} : point{longer, 0.0});
}

}  // namespace detail

/// Shapes a line with its tabs. Each tab moves the pen to the next tab stop (tab_stop_behind()) and has no glyph. Stops
/// are `tab_width` spaces apart, counted from the line's start. A right-to-left line starts on the right. Between tabs,
/// letters are spaced as requested.
///
///     |       |       |       |            The shaper gets the segments between tabs, each as a line of its own. A
///     |name   |weight |price  |            line is read right-to-left if the options say so, or by default if its
///     |ambergris      |12 g   |            first letter is. The segments then follow each other to the left, each
///                                          as a right-to-left line.
///
///     text[first, last)    the line, without line breaks; first < last
///     options              tab_width 0: tabs are ordinary characters, which most fonts lack; letter_spacing
///     run                  glyphs are appended in drawing order, as by a shaper
///
/// Returns the pen's offset. If the font's space has no advance, tabs have none either.
/// Fails  as the shaper does; the run may then have some of the line's glyphs
/// Cost   O(n) plus the shaper's cost; for a line with tabs it also shapes a space and a digit
template <shaper Shaper>
result<point> shape_line(Shaper& shaper, text_view text, std::size_t first, std::size_t last, const shape_options& how,
                         const layout_options& options, glyph_run& run) noexcept
{
    const auto next_tab = [text, last](std::size_t i) noexcept {
        while (i < last && text.unit(i) != 0x09) ++i;
        return i;
    };
    std::size_t end = options.tab_width > 0.0 ? next_tab(first) : last;
    if (end == last) return detail::shape_spaced(shaper, text, first, last, how, options, run);

    const result<double> space = detail::advance_of(shaper, ' ', how, run);
    if (!space) return space.error();
    const result<double> digit = detail::advance_of(shaper, '0', how, run);
    if (!digit) return digit.error();
    const double apart = options.tab_width * *space;
    const bool down = how.direction == direction::top_to_bottom;
    shape_options own = how;
    own.direction = detail::direction_of(how.direction, read_line(text, first, last));
    const bool to_the_left = own.direction == direction::right_to_left;

    const std::size_t first_glyph = run.glyphs.size();
    double pen = 0.0;  // from the line's start, in its reading direction
    for (std::size_t begin = first;;) {
        if (begin < end) {
            const std::size_t before = run.glyphs.size();
            const result<point> advance = detail::shape_spaced(shaper, text, begin, end, own, options, run);
            if (!advance) return advance.error();
            const double length = down ? -advance->y : advance->x;
            const double start = to_the_left ? 0.0 - (pen + length) : pen;
            const array_view<placed_glyph> glyphs = run.glyphs.view().subspan(before);
            for (placed_glyph& g : glyphs) g.origin = g.origin + (down ? point{0.0, 0.0 - start} : point{start, 0.0});
            if (to_the_left) detail::reverse(glyphs);
            pen += length;
        }
        if (end == last) break;
        if (apart > 0.0) pen = tab_stop_behind(pen, apart, least_tab(*digit));
        begin = end + 1;
        end = next_tab(begin);
    }
    if (to_the_left) {
        const array_view<placed_glyph> glyphs = run.glyphs.view().subspan(first_glyph);
        detail::reverse(glyphs);  // reverses the segments; their own glyphs are then in order again
        for (placed_glyph& g : glyphs) g.origin.x += pen;
    }
    return down ? point{0.0, 0.0 - pen} : point{pen, 0.0};
}

}  // namespace typemesh::inline TYPEMESH_ABI
