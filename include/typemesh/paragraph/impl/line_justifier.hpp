// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes finished lines as wide as the room, after their last tab: see justification.
class line_justifier {
public:
    explicit line_justifier(memory source = heap()) noexcept : made_{source}, elongations_{source}, word_{source} {}

    /// Prepares for a new layout: removes the data of the previous one.
    void clear() noexcept { model_ = no_cluster; }

    /// Makes a line wider by `gap`. Returns the increase. It is 0 if nothing can grow, and less than `gap` if a line
    /// without spaces would need more than max_strokes in a word.
    ///
    /// Fails  error::out_of_memory, and as the shaper does, which shapes U+0640
    template <shaper Shaper>
    result<double> widen(line_slices& line, shaped_text& shaped, Shaper& shaper, justification by, double gap) noexcept
    {
        const bool ideographs = by == justification::automatic && has_ideographs(line, shaped);
        if (by == justification::letters || ideographs) {
            const auto grown = spread(line, shaped, gap, ideographs);
            if (!grown || *grown > 0.0) return grown;
        }
        double strokes = 0.0;
        if (by == justification::kashida) {
            if (error e = find_elongations(line, shaped, shaper)) return e;
            count_strokes(line, shaped, gap);
            const auto drawn = shape_strokes(line, shaped, shaper);
            if (!drawn) return drawn.error();
            strokes = *drawn < gap ? *drawn : gap;
            if (error e = insert_strokes(line, shaped, strokes / *drawn)) return e;
        }
        return strokes + (gap > strokes ? line.justify(shaped, gap - strokes) : 0.0);
    }

    /// Makes a line narrower by `excess`, if that takes at most the part `shrink` of its spaces' width. Returns the
    /// decrease: all or nothing.
    static double narrow(line_slices& line, const shaped_text& shaped, double excess, double shrink) noexcept
    {
        double spaces = 0.0;
        const auto all = line.slices().subspan(0, line.visible());
        for (const line_slice& s : all.subspan(line.behind_tabs(shaped)))
            for (std::uint32_t c = s.first; c < s.last; ++c)
                if (has(shaped.cluster(c).flags, cluster_flags::stretches)) spaces += shaped.cluster(c).advance;
        constexpr double rounding = 1.0 + 1e-9;
        return excess <= shrink * spaces * rounding ? 0.0 - line.justify(shaped, 0.0 - excess) : 0.0;
    }

    static constexpr std::uint32_t max_strokes = 4;  ///< in a word

private:
    /// A place for strokes: before a cluster of a slice.
    struct elongation {
        std::size_t slice;
        std::uint32_t cluster;
        double stroke;          // the advance of one stroke
        std::uint32_t count;    // the number of strokes
        std::uint32_t strokes;  // the cluster that shows them
    };

    /// The slice of [first, last) that is outermost on one side in visual order.
    static std::size_t outermost(array_view<const line_slice> s, std::size_t first, std::size_t last,
                                 bool right) noexcept
    {
        for (;;) {
            std::uint8_t lowest = s[first].level;
            for (std::size_t k = first; k < last; ++k) lowest = s[k].level < lowest ? s[k].level : lowest;
            std::size_t k = last;
            if (right != (lowest % 2 != 0)) {
                while (s[k - 1].level > lowest) --k;
                if (k == last) return last - 1;
                first = k;
            } else {
                for (k = first; s[k].level > lowest;) ++k;
                if (k == first) return first;
                last = k;
            }
        }
    }

    [[nodiscard]] static bool has_ideographs(const line_slices& line, const shaped_text& shaped) noexcept
    {
        for (std::size_t k = line.behind_tabs(shaped); k < line.visible(); ++k)
            for (std::uint32_t c = line.slices()[k].first; c < line.slices()[k].last; ++c)
                if (is_ideographic(decode(shaped.text(), shaped.cluster(c).first).value)) return true;
        return false;
    }

    /// Moves letters apart, or only ideographs. The gap is after its letter. So the last letter of text that is read
    /// towards an edge of the line must have none: it becomes a separate slice.
    result<double> spread(line_slices& line, const shaped_text& shaped, double gap, bool ideographs) noexcept
    {
        const std::size_t first = line.behind_tabs(shaped), visible = line.visible();
        const auto s = line.slices();
        if (first == visible) return 0.0;
        const std::size_t right = outermost(s, first, visible, true), left = outermost(s, first, visible, false);
        made_.clear();
        std::size_t count = 0, now_visible = visible;
        for (std::size_t k = 0; k < s.size(); ++k) {
            const bool edge = (k == right && s[k].level % 2 == 0) || (k == left && s[k].level % 2 != 0);
            line_slice head = s[k];
            if (edge && s[k].last - s[k].first > 1) {
                if (!append_head(shaped, head, s[k].last - 1)) return error::out_of_memory;
                ++now_visible;
            } else if (!edge && !made_.push_back(head))
                return error::out_of_memory;
            if (k >= first && k < visible && (!edge || s[k].last - s[k].first > 1)) {
                made_.back().spread = 1.0;  // the distance is not known yet
                made_.back().ideographs = ideographs;
                count += count_spaced(shaped, made_.back());
            }
            if (edge && !made_.push_back(head)) return error::out_of_memory;
        }
        if (count == 0) return 0.0;
        for (line_slice& m : made_) {
            m.spread *= gap / static_cast<double>(count);
            m.width += m.spread * static_cast<double>(is_zero(m.spread) ? 0 : count_spaced(shaped, m));
        }
        line.replace(made_, now_visible);
        return gap;
    }

    /// Appends the part of a slice before a cluster, and removes it from the slice.
    [[nodiscard]] bool append_head(const shaped_text& shaped, line_slice& rest, std::uint32_t end) noexcept
    {
        line_slice head = rest;
        head.last = rest.first = end;
        head.width = shaped.advance(head.first, end);
        head.lead = 0.0;
        rest.width -= head.width;
        return made_.push_back(head);
    }

    [[nodiscard]] static std::size_t count_spaced(const shaped_text& shaped, const line_slice& s) noexcept
    {
        std::size_t n = 0;
        for (std::uint32_t c = s.first; c < s.last; ++c) n += has_gap(shaped, s, shaped.cluster(c)) ? 1u : 0u;
        return n;
    }

    /// Finds one place for each word: before the last cluster where its font allows strokes.
    template <shaper Shaper>
    error find_elongations(const line_slices& line, shaped_text& shaped, Shaper& shaper) noexcept
    {
        elongations_.clear();
        for (std::size_t k = line.behind_tabs(shaped); k < line.visible(); ++k) {
            const line_slice& s = line.slices()[k];
            std::uint32_t found = s.first;  // none
            for (std::uint32_t c = s.first; c < s.last; ++c) {
                const cluster_flags flags = shaped.cluster(c).flags;
                if (c > s.first && has(flags, cluster_flags::tatweel)) found = c;
                if (found == s.first || (c + 1 < s.last && !has(flags, cluster_flags::stretches))) continue;
                const auto model = model_for(shaped.cluster(found).item, shaped, shaper);
                if (!model) return model.error();
                const double stroke = shaped.cluster(*model).advance;
                if (stroke > 0.0 && !elongations_.push_back({k, found, stroke, 0, 0})) return error::out_of_memory;
                found = s.first;
            }
        }
        return {};
    }

    /// A cluster of one stroke with the glyph style of an item. It has no advance if the font has no stroke.
    template <shaper Shaper>
    result<std::uint32_t> model_for(std::uint32_t item, shaped_text& shaped, Shaper& shaper) noexcept
    {
        if (model_ != no_cluster) {
            const text_item &a = shaped.items()[shaped.cluster(model_).item], &b = shaped.items()[item];
            if (a.style == b.style && a.face == b.face && a.script == b.script && a.level % 2 == b.level % 2)
                return model_;
        }
        const auto made = static_cast<std::uint32_t>(shaped.all_clusters());
        const std::u16string_view stroke{u"\u0640"};
        if (error e = shaped.append_foreign(shaper, item, shaped.items()[item].first, stroke, text_view{})) return e;
        model_ = made;
        return model_;
    }

    /// Gives each word its share of strokes: as many as there is room for. In a line without spaces it is one more, and
    /// the strokes overlap.
    void count_strokes(const line_slices& line, const shaped_text& shaped, double gap) noexcept
    {
        double round = 0.0;
        for (const elongation& own : elongations_) round += own.stroke;
        if (!(round > 0.0)) return;
        const double rounds = gap / round;
        const auto whole = rounds < max_strokes ? static_cast<std::uint32_t>(rounds) : max_strokes;
        const bool overlap = !has_spaces(line, shaped);
        double all = whole * round;
        for (elongation& own : elongations_) {
            own.count = whole;
            if (whole == max_strokes || !(all + (overlap ? 0.0 : own.stroke) <= gap)) continue;
            ++own.count;
            all += own.stroke;
        }
    }

    /// Shapes each word with its strokes, and keeps only the strokes. Returns their advance.
    template <shaper Shaper>
    result<double> shape_strokes(const line_slices& line, shaped_text& shaped, Shaper& shaper) noexcept
    {
        double all = 0.0;
        for (elongation& own : elongations_) {
            if (own.count == 0) continue;
            const line_slice& s = line.slices()[own.slice];
            const auto is_space = [&shaped](std::uint32_t c) noexcept {
                return has(shaped.cluster(c).flags, cluster_flags::stretches);
            };
            std::uint32_t first = own.cluster, last = own.cluster;
            while (first > s.first && !is_space(first - 1)) --first;
            while (last < s.last && !is_space(last)) ++last;
            word_.clear();
            const bool before = append_text(shaped, first, own.cluster);
            text_range strokes{static_cast<std::uint32_t>(word_.size()), 0};
            for (std::uint32_t n = 0; n < own.count; ++n)
                if (!word_.push_back(u'\u0640')) return error::out_of_memory;
            strokes.last = static_cast<std::uint32_t>(word_.size());
            if (!before || !append_text(shaped, own.cluster, last)) return error::out_of_memory;
            const std::uint32_t item = shaped.cluster(own.cluster).item, at = shaped.cluster(own.cluster - 1).first;
            own.strokes = static_cast<std::uint32_t>(shaped.all_clusters());
            const std::u16string_view word{word_.data(), word_.size()};
            if (error e = shaped.append_part(shaper, item, at, word, strokes)) return e;
            all += shaped.cluster(own.strokes).advance;
        }
        return all;
    }

    /// Appends the text of clusters to the word. A hyphen at their end is omitted, because it is not part of the text.
    [[nodiscard]] bool append_text(const shaped_text& shaped, std::uint32_t first, std::uint32_t last) noexcept
    {
        while (last > first && has(shaped.cluster(last - 1).flags, cluster_flags::foreign)) --last;
        if (first == last) return true;
        const std::uint32_t end = shaped.cluster(last - 1).last;
        for (std::size_t u = shaped.cluster(first).first; u < end;) {
            const code_point c = decode(shaped.text(), u, end);
            u = c.next;
            const char32_t high = 0xD7C0 + (c.value >> 10);  // of a surrogate pair
            if (c.value > 0xFFFF && !word_.push_back(static_cast<char16_t>(high))) return false;
            const char32_t low = c.value > 0xFFFF ? 0xDC00 + (c.value & 0x3FF) : c.value;
            if (!word_.push_back(static_cast<char16_t>(low))) return false;
        }
        return true;
    }

    /// Inserts the strokes into the line, and scales their advances.
    error insert_strokes(line_slices& line, shaped_text& shaped, double scale) noexcept
    {
        made_.clear();
        std::size_t next = 0, visible = line.visible();
        for (std::size_t k = 0; k < line.slices().size(); ++k) {
            line_slice rest = line.slices()[k];
            for (; next < elongations_.size() && elongations_[next].slice == k; ++next) {
                const elongation& own = elongations_[next];
                if (own.count == 0) continue;
                if (scale < 1.0) shaped.scale_foreign(own.strokes, scale);
                const line_slice strokes{.first = own.strokes,
                                         .last = own.strokes + 1,
                                         .level = rest.level,
                                         .width = shaped.cluster(own.strokes).advance};
                if (!append_head(shaped, rest, own.cluster) || !made_.push_back(strokes)) return error::out_of_memory;
                visible += 2;
            }
            if (!made_.push_back(rest)) return error::out_of_memory;
        }
        line.replace(made_, visible);
        return {};
    }

    [[nodiscard]] static bool has_spaces(const line_slices& line, const shaped_text& shaped) noexcept
    {
        for (std::size_t k = line.behind_tabs(shaped); k < line.visible(); ++k)
            for (std::uint32_t c = line.slices()[k].first; c < line.slices()[k].last; ++c)
                if (has(shaped.cluster(c).flags, cluster_flags::stretches)) return true;
        return false;
    }

    buffer<line_slice> made_;
    buffer<elongation> elongations_;
    buffer<char16_t> word_;
    std::uint32_t model_ = no_cluster;
};

}  // namespace typemesh::inline TYPEMESH_ABI
