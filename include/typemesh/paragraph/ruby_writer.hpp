// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/layout.hpp>
#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Small text above a range of a text.
struct ruby_span {
    std::uint32_t first = 0;  ///< the range of the text, in its units
    std::uint32_t last = 0;
    text_view text = {};  ///< without line breaks
    style_id style = {};  ///< of the small text
};

/// The options for rubies.
struct ruby_options {
    double size = 0.5;         ///< times the text's size: more than 0, up to 1
    double gap = 0.0;          ///< em between the line and its ruby; may be negative
    shape_options shape = {};  ///< of the rubies; without styles

    /// The error for an option that is out of range.
    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(size) || !(size > 0.0) || size > 1.0) return error::bad("size");
        if (!is_finite(gap)) return error::bad("gap");
        return shape.styles.empty() ? error{} : error::bad("styles");
    }
};

/// Sets rubies above the lines of a paragraph, after each layout:
///
///     words.lay_out({.width = 20.0, .line_spacing = 1.5}, page);
///     rubies.write(font, words.laid(), spans, {}, page);
///
///      to kyo          the ruby is centred above its text. If it is narrower and consists of ideographs or kana, they
///     +------+         are spread: the space at both ends is half of the space between them (JLREQ 3.3.6, group ruby)
///     | base |
///     +------+         If it is wider, it reaches beyond its text on both sides, and `overhanging` counts it: the text
///                      is not spread, so that it may touch its neighbours
///
/// Lines do not become higher: line_spacing must leave room. A text that has several boxes, in several lines or
/// directions, has its ruby above the first one, and `divided` counts it. A ruby without a box (its text is dropped or
/// blank) is not drawn.
///
/// In the run each ruby is a line of its own after the text's lines. Its glyphs have the cluster of the text's first
/// unit.
class ruby_writer {
public:
    explicit ruby_writer(memory source = heap()) noexcept : layout_{source}, own_{source} {}

    std::uint32_t overhanging = 0;  ///< of the last call: rubies that are wider than their texts
    std::uint32_t divided = 0;      ///< of the last call: rubies whose texts have several boxes

    /// Appends the rubies to the run of the paragraph's last layout.
    ///
    /// Fails  error::bad_option: an option is out of range, or "direction": the text is set in columns; as plain_layout
    ///        does. The run then has no further glyphs.
    /// Cost   O(rubies), shaping, and the lines' clusters; without allocations after the first texts of this size
    template <shaper Shaper>
    result<void> write(Shaper& shaper, const laid_text& laid, std::span<const ruby_span> spans,
                       const ruby_options& options, glyph_run& run) noexcept
    {
        overhanging = divided = 0;
        const std::size_t glyphs = run.glyphs.size(), lines = run.lines.size();
        const std::uint32_t missing = run.missing;
        const cluster_id first_missing = run.first_missing;
        error e = options.refused();
        if (!e && laid.in_columns()) e = error::bad("direction");
        for (const ruby_span& s : spans)
            if (!e) e = write_one(shaper, laid, s, options, run);
        if (!e) return {};
        run.glyphs.truncate(glyphs);
        run.lines.truncate(lines);
        run.missing = missing;
        run.first_missing = first_missing;
        return e;
    }

private:
    template <shaper Shaper>
    error write_one(Shaper& shaper, const laid_text& laid, const ruby_span& span, const ruby_options& options,
                    glyph_run& run) noexcept
    {
        box base;
        std::uint32_t boxes = 0;
        laid.boxes_of(span.first, span.last, [&](const box& b) noexcept {
            if (boxes++ == 0) base = b;
        });
        if (boxes == 0 || span.text.empty()) return {};
        if (auto done = layout_(shaper, span.text, options.shape, {.align = alignment::left}, own_); !done)
            return done.error().at(no_glyph, span.first);
        const double em = shaper.units_per_em(), left = base.low.x * em, width = base.width() * em;
        const double own = own_.lines.empty() ? 0.0 : own_.lines[0].advance * options.size;
        if (boxes > 1) ++divided;
        if (own > width) ++overhanging;
        const line_metrics m = shaper.metrics(direction::left_to_right);
        const point origin{left + 0.5 * (width - own), (base.high.y + options.gap) * em - m.descender * options.size};
        const std::uint32_t count = own < width && is_spread(span.text) ? clusters() : 0;
        const double space = count != 0 ? (width - own) / count : 0.0;
        return append(span, options.size, origin, space, run);
    }

    /// `space`: between clusters, if they are spread.
    error append(const ruby_span& span, double size, point origin, double space, glyph_run& run) noexcept
    {
        const auto first = static_cast<std::uint32_t>(run.glyphs.size());
        double shift = own_.glyphs.empty() ? 0.0 : 0.5 * space - 0.5 * space * clusters();
        cluster_id before = own_.glyphs.empty() ? 0 : own_.glyphs[0].cluster;
        for (const placed_glyph& g : own_.glyphs) {
            if (g.cluster != before) shift += space;
            before = g.cluster;
            glyph_style drawn = own_.glyph_styles.empty() ? glyph_style{} : own_.glyph_styles[g.glyph_style];
            affine& map = drawn.map;
            for (double* part : {&map.xx, &map.xy, &map.dx, &map.yx, &map.yy, &map.dy}) *part *= size;
            drawn.style = span.style;
            const auto number = run.number_of(drawn);
            if (!number) return number.error();
            placed_glyph put = g;
            put.cluster = span.first;
            put.origin = {origin.x + shift + g.origin.x * size, origin.y + g.origin.y * size};
            put.to_middle = static_cast<float>(as_double(g.to_middle) * size);
            put.glyph_style = *number;
            if (!run.glyphs.push_back(put)) return error::out_of_memory;
            if (g.missing) run.note_missing(span.first);
        }
        text_line line;
        line.first_glyph = first;
        line.glyph_count = static_cast<std::uint32_t>(run.glyphs.size()) - first;
        line.origin = origin;
        line.advance = own_.lines.empty() ? 0.0 : own_.lines[0].advance * size;
        return run.lines.push_back(line) ? error{} : error{error::out_of_memory};
    }

    /// The number of clusters of the ruby, which are in order.
    [[nodiscard]] std::uint32_t clusters() const noexcept
    {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < own_.glyphs.size(); ++i)
            count += i == 0 || own_.glyphs[i].cluster != own_.glyphs[i - 1].cluster ? 1u : 0u;
        return count;
    }

    /// Whether all characters are ideographs, kana or the like.
    [[nodiscard]] static bool is_spread(text_view text) noexcept
    {
        for (std::size_t i = 0; i < text.size();) {
            const code_point c = decode(text, i);
            if (c.value < 0x2E80 || (c.value >= 0xAC00 && c.value < 0xF900)) return false;
            i = c.next;
        }
        return true;
    }

    plain_layout layout_;
    glyph_run own_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
