// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/itemise.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/layout/impl/text_columns.hpp>
#include <typemesh/layout/impl/text_lines.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/line_room.hpp>
#include <typemesh/paragraph/broken_line.hpp>
#include <typemesh/paragraph/impl/line_pieces.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>
#include <typemesh/unicode/bidi_analyser.hpp>
#include <typemesh/unicode/visual_order.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// The input from which the lines of a paragraph are made.
template <shaper Shaper>
struct line_source {
    shaped_text& shaped;
    text_pieces& pieces;
    Shaper& shaper;
    const line_room& room;
    const layout_options& options;
};

/// Makes the lines that cannot show all their text: as many graphemes as there is room for, and an ellipsis.
///
///     at the end   one two th...     The ellipsis replaces the dropped graphemes and the white space before them. Its
///     middle       one t...hree      glyphs belong to the first of these graphemes in the text. If only later lines
///     start        ...two three      are dropped, the ellipsis is at the end.
///
/// The ellipsis is set like the line's first character, and painted like the first dropped grapheme.
class elision {
public:
    explicit elision(memory source = heap()) noexcept
        : analyser_{source}, found_{source}, columns_{source}, parts_{source}
    {
    }

    /// Whether a line needs an ellipsis: it is wider than the room, or text after it is dropped.
    [[nodiscard]] static bool is_needed(const broken_line& line, const line_room& room,
                                        const layout_options& options) noexcept
    {
        return !options.ellipsis.empty() && (line.drops || line.least_end(room) > widened(room.width));
    }

    /// The graphemes from which an elided line shows some. They are the line's own graphemes, or, if text after it is
    /// dropped, all graphemes up to the text's next line break. They are made only once, before anything is appended
    /// for a single layout.
    template <shaper Shaper>
    static result<const text_pieces::list*> graphemes_of(const line_source<Shaper>& from,
                                                         const broken_line& line) noexcept
    {
        const array_view<const break_piece> p = line.all.pieces.view();
        const std::size_t last = line.drops ? p.size() : line.last;
        double pen = line.pen;
        std::size_t k = line.first;
        for (; k + 1 < last && !p[k].ends_line(); ++k) {
            pen += p[k].width + p[k].space;
            if (from.options.elide == ellipsis_place::end && pen > from.room.width) break;
        }
        return from.pieces.graphemes_of(p[line.first].first, p[k].last, from.shaped, from.shaper);
    }

    /// Makes a line of a paragraph with this level: `slices` gets the finished visible part. Returns the line's width.
    /// It is greater than the room only if the room is too small even for the ellipsis.
    ///
    /// Fails  error::out_of_memory, and as the shaper does
    template <shaper Shaper>
    result<double> compose(const line_source<Shaper>& from, const broken_line& line, std::uint8_t level,
                           line_slices& slices) noexcept
    {
        const auto made = graphemes_of(from, line);
        if (!made) return made.error();
        const text_pieces::list& graphemes = **made;
        const array_view<const break_piece> p = graphemes.pieces.view();
        shaped_text& shaped = from.shaped;
        const auto text_end = static_cast<std::uint32_t>(shaped.text().size());
        const auto dots = static_cast<std::uint32_t>(shaped.all_clusters());
        if (error e = append_ellipsis(from, p.front().first, level)) return e;
        std::uint32_t turned = dots;  // as it looks inside text of the other direction
        if (from.options.elide == ellipsis_place::middle && is_mixed(shaped, p, level)) {
            turned = static_cast<std::uint32_t>(shaped.all_clusters());
            if (error e = append_ellipsis(from, p.front().first, level + 1u)) return e;
        }

        const std::size_t clusters = shaped.all_clusters(), glyphs = shaped.all_glyphs();
        const double most = from.room.width - line.pen;
        double spare = most - shaped.cluster(dots).advance;
        for (;;) {
            const shown s = fitting(p, from, line.pen, spare);
            shaped.truncate(clusters, glyphs);
            slices.clear();
            if (error e = append_pieces(slices, from.pieces, {graphemes, 0, s.head}, shaped, from.shaper)) return e;
            slices.trim(shaped);
            const std::size_t at = slices.slices().size();
            const std::uint32_t shown_to =
                at == 0 ? p.front().first : shaped.cluster(slices.slices().back().last - 1).last;
            const std::uint32_t dropped_to = line.drops ? text_end : p.back().last;
            const std::uint32_t shown_from = s.tail < p.size() ? p[s.tail].first : dropped_to;
            std::uint32_t used = dots;
            if (error e = slices.append(shaped, dots, 1, level)) return e;
            if (error e = append_pieces(slices, from.pieces, {graphemes, s.tail, p.size()}, shaped, from.shaper))
                return e;
            if (at > 0 && at + 1 < slices.slices().size()) {
                const std::uint8_t before = slices.slices()[at - 1].level, behind = slices.slices()[at + 1].level;
                line_slice& between = slices.slices()[at];
                between.level = before < behind ? before : behind;
                if (between.level % 2 != level % 2) between.first = used = turned;
                between.last = between.first + 1;
            }
            const auto width = slices.finish(shaped, level, line.pen, from.room);
            if (!width) return width;
            if (!(*width > most) || !is_finite(*width) || (s.head == 0 && s.tail == p.size())) {
                const std::uint32_t dropped = s.head < p.size() ? p[s.head].first : p.back().last;
                shaped.move_foreign(used, {shown_to, shown_from}, dropped);
                return width;
            }
            const double less = spare - (*width - most),
                         fewer = std::nextafter(s.width, -std::numeric_limits<double>::infinity());
            spare = less < fewer ? less : fewer;
        }
    }

private:
    /// The visible graphemes, [0, head) and from `tail` on, and their approximate width.
    struct shown {
        std::size_t head = 0, tail = 0;
        double width = 0.0;
    };

    /// Whether part of the pieces' text is read against the direction of a level.
    [[nodiscard]] static bool is_mixed(const shaped_text& shaped, array_view<const break_piece> p,
                                       std::uint8_t level) noexcept
    {
        for (std::size_t i = shaped.item_at(p.front().first); i < shaped.items().size(); ++i) {
            if (shaped.items()[i].first >= p.back().last) return false;
            if (shaped.items()[i].level % 2 != level % 2) return true;
        }
        return false;
    }

    /// Shapes the ellipsis by itself, in the direction of a level, as a cluster of the unit `at`.
    template <shaper Shaper>
    error append_ellipsis(const line_source<Shaper>& from, std::uint32_t at, unsigned level) noexcept
    {
        shaped_text& shaped = from.shaped;
        const std::uint32_t item = shaped.item_at(at);
        shape_options how;
        how.direction = level % 2 != 0 ? direction::right_to_left : direction::left_to_right;
        how.columns.latin = shaped.options().columns.latin;
        if (shaped.in_columns()) how.direction = direction::top_to_bottom;
        const std::size_t clusters = shaped.all_clusters(), glyphs = shaped.all_glyphs();
        for (const text_view wanted : {from.options.ellipsis, text_view{"..."}}) {
            shaped.truncate(clusters, glyphs);
            if (error e = find_parts(from.shaper, wanted, how)) return e;
            const auto complete = shaped.append_foreign(from.shaper, item, at, wanted, parts_.view());
            if (!complete) return complete.error();
            if (*complete) break;
        }
        return {};
    }

    /// Cuts the ellipsis into items, in drawing order.
    template <shaper Shaper>
    error find_parts(Shaper& shaper, text_view wanted, const shape_options& how) noexcept
    {
        if (error e = analyser_.analyse(wanted, analysis_of(how), found_)) return e;
        if (error e = columns_.find(shaper, wanted, how, style_spans{}, found_)) return e;
        if (error e = itemise(wanted, found_, {}, columns_.runs(), parts_)) return e;
        order_visually(parts_.view());
        return {};
    }

    template <shaper Shaper>
    [[nodiscard]] static shown fitting(array_view<const break_piece> p, const line_source<Shaper>& from, double pen,
                                       double room) noexcept
    {
        const ellipsis_place place = from.options.elide;
        shown s{0, p.size(), 0.0};
        if (place == ellipsis_place::end) take_head(p, from.room, pen, room, s);
        if (place == ellipsis_place::middle) take_head(p, from.room, pen, room / 2, s);
        if (place != ellipsis_place::end) take_tail(p, room, s);
        if (s.tail <= s.head) s.head = s.tail = p.size();
        return s;
    }
    static void take_head(array_view<const break_piece> p, const line_room& room, double start, double most,
                          shown& s) noexcept
    {
        double pen = start + (p.empty() ? 0.0 : p.front().begin_change);
        for (std::size_t k = 0; k < p.size() && pen - start + p[k].width <= most; ++k) {
            const double width = pen - start + p[k].width + p[k].end_change;
            if (width <= most) {
                s.head = k + 1;
                s.width = width;
            }
            pen += p[k].width + p[k].space;
            if (p[k].tab) pen = room.after_tab(pen);
        }
    }
    static void take_tail(array_view<const break_piece> p, double most, shown& s) noexcept
    {
        const double head = s.width;
        double width = head;
        for (std::size_t k = p.size(); k > s.head; --k) {
            width += p[k - 1].width + (k < p.size() ? p[k - 1].space : p[k - 1].end_change);
            if (width > most) break;
            if (width + p[k - 1].begin_change <= most) {
                s.tail = k - 1;
                s.width = width + p[k - 1].begin_change;
            }
        }
    }

    bidi_analyser analyser_;
    text_analysis found_;
    text_columns columns_;
    buffer<text_item> parts_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
