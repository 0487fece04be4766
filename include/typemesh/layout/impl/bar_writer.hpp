// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/layout/laid_line.hpp>
#include <typemesh/outline/bar_face.hpp>

#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether columns of a language (BCP 47: "ja", "ko-KR") are underlined on the right.
[[nodiscard]] constexpr bool underlined_on_the_right(std::string_view language) noexcept
{
    if (language.size() < 2 || (language.size() > 2 && language[2] != '-' && language[2] != '_')) return false;
    const char first = static_cast<char>(language[0] | 0x20), second = static_cast<char>(language[1] | 0x20);
    return (first == 'j' && second == 'a') || (first == 'k' && second == 'o');
}

/// Writes the decorations of lines into a run. Each group of consecutive clusters whose bars have one height, one
/// thickness and one style gets a glyph of the bar face. Bars are as wide as the clusters; hanging white space at a
/// line's end has none. Bars have no place in the text: their cluster is no_cluster.
///
///     underline, strike_through   as the font of the text suggests (face_metrics.hpp), scaled with the text
///     overline                    as thick as the underline; its upper edge is at the ascender
///     in columns                  to the left of the letters, through their middle, and to their right; the distance
///                                 is the thickness. Japanese and Korean are underlined on the right (as in CSS)
///     small letters               synthetic superscripts and subscripts: underlined like full letters; the other bars
///                                 are scaled and moved with the letters
template <shaper Font>
class bar_writer {
public:
    bar_writer(Font& font, const shaped_text& shaped, glyph_run& run) noexcept : font_{font}, shaped_{shaped}, run_{run}
    {
    }

    /// Appends the bars of a line with these slices.
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(clusters of the line); nothing in a text without decorations
    error write(const laid_line& line, array_view<const line_slice> slices) noexcept
    {
        for (const decoration kind : {decoration::underline, decoration::strike_through, decoration::overline})
            if (has(shaped_.styles.decorations(), kind))
                if (error e = write(kind, line, slices)) return e;
        return {};
    }

private:
    /// A bar from `from` to `to` along a line. `low` and `high` are measured across the line, from the baseline.
    struct bar {
        double from = 0.0, to = 0.0, low = 0.0, high = 0.0;
        style_id style = {};

        [[nodiscard]] bool goes_on(const bar& next) const noexcept
        {
            return same(low, next.low) && same(high, next.high) && style == next.style;
        }
    };

    error write(decoration kind, const laid_line& line, array_view<const line_slice> slices) noexcept
    {
        bar open;
        for (const line_slice& s : slices) {
            double pen = s.at, rest = s.width;
            for (std::uint32_t k = s.first; k + 1 < s.last; ++k) rest -= width_of(shaped_, s, k);
            for (std::uint32_t n = s.first; n < s.last; ++n) {
                const std::uint32_t k = s.level % 2 != 0 ? s.last - 1 - (n - s.first) : n;
                bar next = bar_of(kind, k);
                next.from = pen > line.left ? pen : line.left;
                pen += k + 1 == s.last ? rest : width_of(shaped_, s, k);
                next.to = pen < line.right() ? pen : line.right();
                const bool drawn = next.high > next.low, shown = drawn && next.to > next.from;
                if (drawn && open.to > open.from && open.goes_on(next)) {  // also over clusters without width
                    open.to = next.to > open.to ? next.to : open.to;
                    continue;
                }
                if (error e = append(open, line.origin)) return e;
                open = shown ? next : bar{};
            }
        }
        return append(open, line.origin);
    }

    /// The bar of a cluster, across its line. It is empty if the cluster has none.
    [[nodiscard]] bar bar_of(decoration kind, std::uint32_t cluster) noexcept
    {
        const text_cluster& c = shaped_.cluster(cluster);
        const text_style& painted = shaped_.style_of(c);
        if (!has(painted.decorations, kind)) return {};
        const text_item& item = shaped_.items()[c.item];
        read_metrics(item.face);
        const bool under = kind == decoration::underline;
        const item_setting set = shaped_.setting_of(c.item);
        const double em = shaped_.units_per_em(), size = under ? shaped_.styles[item.style].size : set.scale;
        const bar_metrics& own = kind == decoration::strike_through ? metrics_.strike_through : metrics_.underline;
        const double thickness = own.thickness * em * size;
        double top = own.top * em * size;
        if (kind == decoration::overline) top = lines_.ascender * size;
        if (shaped_.in_columns()) {
            const bool right = under == underlined_on_the_right(shaped_.options_of(c.item).language);
            top = right ? lines_.ascender * size + 2 * thickness : lines_.descender * size - thickness;
            if (kind == decoration::strike_through) top = thickness / 2;
        }
        const double rise = painted.rise * em + (under ? 0.0 : set.lift);
        return {.low = top - thickness + rise, .high = top + rise, .style = painted.style};
    }

    void read_metrics(std::uint32_t face) noexcept
    {
        if (known_ && face == face_) return;
        metrics_ = face_metrics_of(font_, face);
        lines_ = line_metrics_of(font_, shaped_.options().direction, face);
        face_ = face;
        known_ = true;
    }

    error append(const bar& b, point origin) noexcept
    {
        if (!(b.to > b.from)) return {};
        const double length = b.to - b.from, thickness = b.high - b.low;
        const bool down = shaped_.in_columns();
        const auto number = run_.number_of({.face = bar_face,
                                            .map = {.xx = down ? thickness : length, .yy = down ? length : thickness},
                                            .style = b.style});
        if (!number) return number.error();
        const point at = origin + (down ? point{b.low, 0.0 - b.to} : point{b.from, b.low});
        const auto to_middle = static_cast<float>(down ? 0.0 : 0.5 * length);
        return run_.glyphs.push_back({0, no_cluster, at, false, *number, to_middle}) ? error{} : error::out_of_memory;
    }

    Font& font_;
    const shaped_text& shaped_;
    glyph_run& run_;
    face_metrics metrics_;  // of face_, if known_
    line_metrics lines_;
    std::uint32_t face_ = 0;
    bool known_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
