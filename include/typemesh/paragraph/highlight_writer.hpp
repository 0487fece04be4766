// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/line_extent.hpp>
#include <typemesh/layout/text_highlight.hpp>
#include <typemesh/outline/bar_face.hpp>
#include <typemesh/paragraph/laid_text.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The options for backgrounds, in em.
struct highlight_options {
    double pad_along = 0.0;   ///< added at both ends of each part along the line; may be negative
    double pad_across = 0.0;  ///< added above and below, in columns on both sides; may be negative
    double radius = 0.0;      ///< of the corners; at most half of the shorter side is used

    /// The error for an option that is out of range.
    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(pad_along)) return error::bad("pad_along");
        if (!is_finite(pad_across)) return error::bad("pad_across");
        return is_finite(radius) && radius >= 0.0 ? error{} : error::bad("radius");
    }
};

/// Puts backgrounds behind ranges of a paragraph's text, after each layout:
///
///     words.lay_out({.width = 20.0}, page);
///     backgrounds.write(font, words.laid(), spans, {.pad_along = 0.1, .radius = 0.15}, page);
///
/// Each part of a range that a line shows in one piece gets one rectangle, which becomes a closed solid; a range of
/// mixed directions may have several parts in a line. It reaches from the lowest descender to the highest ascender of
/// the range's text in this line, whatever its styles; rubies and white space that hangs are outside. Ranges that
/// follow each other in the list and in the text, with the same style, are one range. Ranges may overlap; later ones
/// are drawn later.
///
/// In the run, the backgrounds of a line come before its letters, so that a flat mesh is drawn in the right order. They
/// are bars: their face is bar_face and their cluster is no_cluster. Backgrounds and letters are equally deep and meet
/// each other. Give backgrounds their own style and make another mesh of them (select_glyphs.hpp), with another depth,
/// to stand behind the letters.
class highlight_writer {
public:
    explicit highlight_writer(memory source = heap()) noexcept : parts_{source} {}

    /// Inserts the backgrounds into the run of the paragraph's last layout, before the rubies or after.
    ///
    /// Fails  error::bad_option: an option is out of range, or the run has fewer lines than the layout ("run");
    ///        error::too_large; error::out_of_memory. The run is then unchanged, except for glyph styles.
    /// Cost   O(glyphs), O(n log n) for n parts, and the clusters of the ranges' lines for each range; without
    ///        allocations after the first texts of this size
    template <shaper Shaper>
    result<void> write(Shaper& shaper, const laid_text& laid, std::span<const text_highlight> spans,
                       const highlight_options& options, glyph_run& run) noexcept
    {
        parts_.clear();
        error e = options.refused();
        if (!e && run.lines.size() < laid.lines().size()) e = error::bad("run");
        for (std::size_t i = 0; i < spans.size() && !e;) {
            text_highlight all = spans[i++];
            for (; i < spans.size() && spans[i].first == all.last && spans[i].style == all.style; ++i)
                all.last = spans[i].last;
            e = add_range(shaper, laid, all, options, run);
        }
        if (!e) e = insert(run);
        return e;
    }

private:
    struct part {
        std::uint32_t line = 0;
        std::uint32_t order = 0;
        placed_glyph glyph = {};
    };

    template <shaper Shaper>
    error add_range(Shaper& shaper, const laid_text& laid, const text_highlight& all, const highlight_options& options,
                    glyph_run& run) noexcept
    {
        const array_view<const laid_line> lines = laid.lines();
        if (lines.empty() || all.first >= all.last) return {};
        const bool down = laid.in_columns();
        const direction way = down ? direction::top_to_bottom : direction::left_to_right;
        error e;
        for (std::size_t k = laid.line_of(all.first); k < lines.size() && lines[k].first < all.last && !e; ++k) {
            const std::uint32_t first = all.first > lines[k].first ? all.first : lines[k].first;
            const std::uint32_t last = all.last < lines[k].last ? all.last : lines[k].last;
            const text_range text{first, last};
            const line_metrics high =
                extent_of(shaper, laid.shaped(), laid.slices_of(lines[k]), line_reach_of(shaper, way), &text);
            laid.boxes_of(first, last, [&](const box& b) noexcept {
                if (!e) e = add_part({static_cast<std::uint32_t>(k), lines[k], high, all.style, down}, b, options, run);
            });
        }
        return e;
    }

    /// The line of a part, and how the range looks there.
    struct home {
        std::uint32_t number;
        const laid_line& line;
        const line_metrics& high;
        style_id style;
        bool down;
    };

    error add_part(const home& in, const box& along, const highlight_options& options, glyph_run& run) noexcept
    {
        const laid_line& line = in.line;
        const bool down = in.down;
        const double em = run.units_per_em, end = options.pad_along * em, side = options.pad_across * em;
        const double base = down ? line.origin.x : line.origin.y;
        box b = along;
        b.low = em * along.low;
        b.high = em * along.high;
        if (down) {  // without white space that hangs at the line's end
            b.low.y = std::fmax(b.low.y, line.origin.y - line.right());
            b.high.y = std::fmin(b.high.y, line.origin.y - line.left);
        } else {
            b.low.x = std::fmax(b.low.x, line.origin.x + line.left);
            b.high.x = std::fmin(b.high.x, line.origin.x + line.right());
        }
        if (!((down ? b.height() : b.width()) > 0.0)) return {};
        (down ? b.low.x : b.low.y) = base + in.high.descender - side;
        (down ? b.high.x : b.high.y) = base + in.high.ascender + side;
        (down ? b.low.y : b.low.x) -= end;
        (down ? b.high.y : b.high.x) += end;
        const double width = b.width(), height = b.height(), radius = options.radius * em;
        if (!(width > 0.0) || !(height > 0.0)) return {};
        const double most = 0.5 * (width < height ? width : height), r = radius < most ? radius : most;
        const auto drawn = run.number_of({.face = bar_face, .map = {.xx = width, .yy = height}, .style = in.style});
        if (!drawn) return drawn.error();
        const auto to_middle = static_cast<float>(down ? 0.5 * height : 0.5 * width);
        const placed_glyph g{rounded_bar(r / width, r / height), no_cluster, b.low, false, *drawn, to_middle, false};
        return parts_.push_back({in.number, static_cast<std::uint32_t>(parts_.size()), g})
                   ? error{}
                   : error{error::out_of_memory};
    }

    /// Moves the glyphs of lines back, from the last line on, and puts the parts before them.
    error insert(glyph_run& run) noexcept
    {
        if (parts_.empty()) return {};
        const std::size_t count = run.glyphs.size(), more = parts_.size();
        if (count + more > 0xFFFF'FFFFu) return error::too_large;
        if (run.glyphs.append(more) == nullptr) return error::out_of_memory;
        detail::heap_sort(parts_.data(), more, [](const part& a, const part& b) noexcept {
            return a.line != b.line ? a.line < b.line : a.order < b.order;
        });
        std::size_t end = count, to = count + more, p = more;
        for (std::size_t k = run.lines.size(); k-- > 0;) {
            text_line& line = run.lines[k];
            for (; end > line.first_glyph; --end) run.glyphs[--to] = run.glyphs[end - 1];
            for (; p > 0 && parts_[p - 1].line == k; --p) {
                run.glyphs[--to] = parts_[p - 1].glyph;
                ++line.glyph_count;
            }
            line.first_glyph = static_cast<std::uint32_t>(to);
        }
        return {};
    }

    buffer<part> parts_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
