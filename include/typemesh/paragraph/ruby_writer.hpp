// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/layout/impl/line_extent.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/layout/text_room.hpp>
#include <typemesh/paragraph/impl/ruby_base.hpp>
#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Small text above a range of a text: one for a word (group ruby), or one for each of its characters (mono ruby).
struct ruby_span {
    std::uint32_t first = 0;  ///< the range of the text, in its units
    std::uint32_t last = 0;
    text_view text = {};  ///< without line breaks
    style_id style = {};  ///< of the small text
};

/// The options for rubies.
struct ruby_options {
    double size = 0.5;         ///< times the text's size: more than 0, up to 1
    double gap = 0.0;          ///< em between the text and its ruby; may be negative
    double overhang = 0.0;     ///< em by which a wide ruby may reach over a kana beside its text: 0 to 1; JLREQ has 0.5
    shape_options shape = {};  ///< of the rubies; without styles. For columns, rooms() needs direction::top_to_bottom

    /// The error for an option that is out of range.
    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(size) || !(size > 0.0) || size > 1.0) return error::bad("size");
        if (!is_finite(gap)) return error::bad("gap");
        if (!is_finite(overhang) || overhang < 0.0 || overhang > 1.0) return error::bad("overhang");
        return shape.styles.empty() ? error{} : error::bad("styles");
    }
};

/// Sets rubies above the lines of a paragraph, or to the right of its columns. Rooms make space for them before the
/// text is shaped; they are written after each layout:
///
///     ruby_writer rubies;
///     auto rooms = rubies.rooms(font, text, spans, {});
///     words.set(text, {.rooms = *rooms});
///     words.lay_out({.width = 20.0}, page);
///     rubies.write(font, words.laid(), spans, {}, page);
///
///      to kyo          A ruby is centred above its text. If it is narrower and consists of ideographs or kana, they
///     +------+         are spread: the space at both ends is half of the space between them (JLREQ 3.3.6, group ruby).
///     | base |         If it is wider, its room spreads the text in the same way (text_room.hpp), and no line ends
///     +------+         inside it. Lines are as high as the rubies need, except with line_box::uniform.
///
/// With an overhang, the text is spread less beside a kana that has no ruby itself. Where a line begins or ends, the
/// ruby then keeps to the line if the kana on its other side allows this. Without rooms, a ruby that is wider reaches
/// beyond its text on both sides, `overhanging` counts it, and line_spacing must leave space for it.
///
/// Text and ruby are taken to be as high as their fonts' ascenders and descenders say, but each at most one em from
/// ascender to descender, as browsers do: many fonts have more, and their rubies would stand too high.
///
/// A text that has several boxes, because of its directions or of line breaks in it, has its ruby above the first one,
/// and `divided` counts it. A ruby whose text is dropped or blank is not drawn.
///
/// In the run each ruby is a line of its own after the text's lines. Its glyphs have the cluster of the text's first
/// unit.
class ruby_writer {
public:
    explicit ruby_writer(memory source = heap()) noexcept : layout_{source}, own_{source}, rooms_{source} {}

    std::uint32_t overhanging = 0;  ///< of the last write(): rubies that are wider than their texts
    std::uint32_t divided = 0;      ///< of the last write(): rubies whose texts have several boxes

    /// Measures rubies. The rooms for shape_options::rooms live until the next call.
    ///
    ///     text    the text above which they stand
    ///
    /// Fails  error::bad_option: an option is out of range, or "spans": a range is, or a ruby has a line break; as
    ///        plain_layout does
    /// Cost   O(n log n) for n rubies, and shaping; without allocations after the first texts of this size
    template <shaper Shaper>
    result<std::span<const text_room>> rooms(Shaper& shaper, text_view text, std::span<const ruby_span> spans,
                                             const ruby_options& options) noexcept
    {
        rooms_.clear();
        error e = options.refused();
        for (const ruby_span& s : spans)
            if (!e) e = measure(shaper, text, s, options);
        if (e) {
            rooms_.clear();
            return e;
        }
        detail::heap_sort(rooms_.data(), rooms_.size(),
                          [](const text_room& a, const text_room& b) noexcept { return a.first < b.first; });
        for (std::size_t k = 0; k < rooms_.size(); ++k) {
            text_room& r = rooms_[k];
            const bool left = detail::kana_before(text, r.first) && (k == 0 || rooms_[k - 1].last != r.first);
            const bool right =
                detail::kana_at(text, r.last) && (k + 1 == rooms_.size() || rooms_[k + 1].first != r.last);
            r.width -= options.overhang * ((left ? 1.0 : 0.0) + (right ? 1.0 : 0.0));
            if (r.width < 0.0) r.width = 0.0;
        }
        return std::span<const text_room>{rooms_.data(), rooms_.size()};
    }

    /// Appends the rubies to the run of the paragraph's last layout.
    ///
    /// Fails  error::bad_option: an option is out of range, or "spans": a ruby has a line break; as plain_layout does.
    ///        The run then has no further glyphs.
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
    /// Lays a ruby out at the text's size. Its length is own_length().
    template <shaper Shaper>
    error lay_out(Shaper& shaper, const ruby_span& span, const ruby_options& options, bool down) noexcept
    {
        shape_options how = options.shape;
        if (down != (how.direction == direction::top_to_bottom))
            how.direction = down ? direction::top_to_bottom : direction::automatic;
        const auto done = layout_(shaper, span.text, how, {.align = alignment::left}, own_);
        if (!done) return done.error().at(no_glyph, span.first);
        return own_.lines.size() > 1 ? error::bad("spans").at(no_glyph, span.first) : error{};
    }
    [[nodiscard]] double own_length() const noexcept { return own_.lines.empty() ? 0.0 : own_.lines[0].advance; }

    /// The part of a font's ascender and descender that counts.
    [[nodiscard]] static double share_of(const line_metrics& m, double em) noexcept
    {
        const double high = m.ascender - m.descender;
        return high > em && is_finite(high) ? em / high : 1.0;
    }

    template <shaper Shaper>
    error measure(Shaper& shaper, text_view text, const ruby_span& span, const ruby_options& options) noexcept
    {
        if (span.first > span.last || span.last > text.size()) return error::bad("spans").at(no_glyph, span.first);
        if (span.first == span.last || span.text.empty()) return {};
        const bool down = options.shape.direction == direction::top_to_bottom;
        if (error e = lay_out(shaper, span, options, down)) return e;
        const double em = shaper.units_per_em();
        const line_metrics m = shaper.metrics(down ? direction::top_to_bottom : direction::left_to_right);
        const double share = share_of(m, em), lower = (1.0 - share) * m.ascender;  // than the text's own ascender
        const double above = options.gap + (share * (m.ascender - m.descender) * options.size - lower) / em;
        const text_room room{span.first, span.last, own_length() * options.size / em, above > 0.0 ? above : 0.0};
        return rooms_.push_back(room) ? error{} : error{error::out_of_memory};
    }

    template <shaper Shaper>
    error write_one(Shaper& shaper, const laid_text& laid, const ruby_span& span, const ruby_options& options,
                    glyph_run& run) noexcept
    {
        if (span.text.empty()) return {};
        const detail::ruby_base base = detail::find_ruby_base(laid, {span.first, span.last});
        if (base.parts == 0) return {};
        const bool down = laid.in_columns();
        if (error e = lay_out(shaper, span, options, down)) return e;
        const laid_line& line = laid.lines()[base.line];
        const direction way = down ? direction::top_to_bottom : direction::left_to_right;
        const double em = shaper.units_per_em(), width = base.to - base.from, own = own_length() * options.size;
        const line_metrics high =
            extent_of(shaper, laid.shaped(), laid.slices_of(line), line_reach_of(shaper, way), &base.text);
        if (base.parts > 1) ++divided;
        const double over = options.overhang * em;
        double left = base.from + 0.5 * (width - own);
        if (own > width) {
            const double before = base.kana_before ? over : 0.0, behind = base.kana_behind ? over : 0.0;
            left = base.from - base.reach_before(own - width, before, behind);
            constexpr double rounding = 1.0 + 1e-9;
            if (own > width * rounding + before + behind) ++overhanging;
        }
        const line_metrics m = shaper.metrics(way);
        const double share = share_of(m, em);
        const double across = share * (high.ascender - m.descender * options.size) + options.gap * em;
        const point origin = line.origin + (down ? point{across, 0.0 - left} : point{left, across});
        const std::uint32_t count = own < width && is_spread(span.text) ? clusters() : 0;
        const double space = count != 0 ? (width - own) / count : 0.0;
        return append(span, options.size, origin, space, down, run);
    }

    /// `space`: between clusters, if they are spread.
    error append(const ruby_span& span, double size, point origin, double space, bool down, glyph_run& run) noexcept
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
            put.origin = origin + size * g.origin + (down ? point{0.0, 0.0 - shift} : point{shift, 0.0});
            put.to_middle = static_cast<float>(as_double(g.to_middle) * size);
            put.glyph_style = *number;
            if (!run.glyphs.push_back(put)) return error::out_of_memory;
            if (g.missing) run.note_missing(span.first);
        }
        text_line line;
        line.first_glyph = first;
        line.glyph_count = static_cast<std::uint32_t>(run.glyphs.size()) - first;
        line.origin = origin;
        line.advance = own_length() * size;
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
    buffer<text_room> rooms_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
