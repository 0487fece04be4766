// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/ideograph_gaps.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>
#include <typemesh/layout/line_room.hpp>
#include <typemesh/unicode/visual_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Consecutive clusters of a line that are set in one direction. Lengths are in font units, along the line.
struct line_slice {
    std::uint32_t first = 0;  ///< clusters of the shaped text
    std::uint32_t last = 0;
    std::uint8_t level = 0;
    bool together = false;  ///< its glyphs are contiguous in drawing order: the ones below
    std::uint32_t item = 0;
    std::uint32_t glyph = 0;
    std::uint32_t glyph_end = 0;
    double width = 0.0;
    double lead = 0.0;        ///< the start of its pen, relative to the slice's place
    double stretch = 0.0;     ///< the increase of each of its spaces
    double spread = 0.0;      ///< the increase of each of its clusters that has a gap after it: see has_gap()
    bool ideographs = false;  ///< only ideographs and spaces have a gap
    double at = 0.0;          ///< its place along the line
};

/// Whether a cluster of a slice has a gap after it if letters move apart.
[[nodiscard]] inline bool has_gap(const shaped_text& shaped, const line_slice& s, const text_cluster& c) noexcept
{
    return s.ideographs ? has_ideograph_gap(shaped, c) : shaped.may_be_spaced(c);
}

/// The width of a cluster of a slice in its line. The last cluster, for example a tab, may be wider or narrower: it
/// ends the slice.
[[nodiscard]] inline double width_of(const shaped_text& shaped, const line_slice& s, std::uint32_t cluster) noexcept
{
    const text_cluster& c = shaped.cluster(cluster);
    double width = c.advance;
    if (has(c.flags, cluster_flags::stretches)) width += s.stretch;
    if (!is_zero(s.spread) && has_gap(shaped, s, c)) width += s.spread;
    return width;
}

/// The content of one line, in the order of the text: see paragraph. Functions that add to it fail with
/// error::out_of_memory, and as the shaper does.
class line_slices {
public:
    explicit line_slices(memory source = heap()) noexcept : slices_{source} {}

    void clear() noexcept
    {
        slices_.clear();
        visible_ = 0;
    }
    [[nodiscard]] array_view<line_slice> slices() noexcept { return slices_.view(); }
    [[nodiscard]] array_view<const line_slice> slices() const noexcept { return slices_.view(); }
    /// The number of slices that count for the line's width. Later slices hang, or show nothing.
    [[nodiscard]] std::size_t visible() const noexcept { return visible_; }

    /// Appends clusters [from, to) of the text, item by item.
    error append_text(const shaped_text& shaped, std::uint32_t from, std::uint32_t to) noexcept
    {
        while (from < to) {
            const std::uint32_t end = shaped.end_cluster(shaped.cluster(from).item);
            if (end <= from) break;  // only if a shaper's clusters are out of order, which is asserted
            const std::uint32_t count = (end < to ? end : to) - from;
            if (error e = append(shaped, from, count)) return e;
            from += count;
        }
        return {};
    }

    /// Appends clusters of one item, at its level or another one.
    error append(const shaped_text& shaped, std::uint32_t first, std::uint32_t count, int level = -1) noexcept
    {
        if (count == 0) return {};
        if (has(shaped.cluster(first).flags, cluster_flags::tab)) {
            const auto parted = part(shaped, slices_.size(), cluster_flags::hangs, false);
            if (!parted) return parted.error();
        }
        const std::uint8_t own = shaped.items()[shaped.cluster(first).item].level;
        const line_slice slice{
            .first = first, .last = first + count, .level = level < 0 ? own : static_cast<std::uint8_t>(level)};
        return slices_.push_back(slice) ? error{} : error::out_of_memory;
    }

    /// Removes clusters that would hang at the line's end, and a hyphen.
    void trim(const shaped_text& shaped) noexcept
    {
        constexpr cluster_flags trimmed = cluster_flags::unshown | cluster_flags::foreign;
        while (!slices_.empty()) {
            line_slice& s = slices_.back();
            while (s.last > s.first && has(shaped.cluster(s.last - 1).flags, trimmed)) --s.last;
            if (s.last > s.first) return;
            slices_.truncate(slices_.size() - 1);
        }
    }

    /// Ends the line. It separates the hanging part. It sets this part, and white space before tabs, at the paragraph's
    /// level (rule L1 of UAX #9). It measures everything, with the pen starting at `pen`. Returns the line's width.
    ///
    ///     word SPACE RLM SPACE     White space before an invisible mark hangs, too, so it is also set at the
    ///          |.............|     paragraph's level. At the level of the mark it would be inside the line.
    result<double> finish(const shaped_text& shaped, std::uint8_t level, double pen, const line_room& room) noexcept
    {
        const auto visible = part(shaped, slices_.size(), cluster_flags::unshown, true);
        if (!visible) return visible.error();
        visible_ = *visible;
        const auto hanging = part_hanging(shaped);
        if (!hanging) return hanging.error();
        for (std::size_t k = *hanging; k < slices_.size(); ++k) slices_[k].level = level;
        line_end_rule rule;
        for (std::size_t k = slices_.size(); k-- > 0;) {
            line_slice& s = slices_[k];
            if (rule.takes(is_tab(shaped, s), end_before(shaped, s, cluster_flags::hangs) == s.first)) s.level = level;
        }
        const double start = pen;
        for (std::size_t k = 0; k < slices_.size(); ++k) {
            line_slice& s = slices_[k];
            s.width = is_tab(shaped, s) ? room.after_tab(pen) - pen : shaped.advance(s.first, s.last);
            if (k + 1 == visible_) trim_spacing(shaped, s);
            if (k < visible_) pen += s.width;
        }
        return pen - start;
    }

    /// The slice after the last tab. Slices before it are not justified.
    [[nodiscard]] std::size_t behind_tabs(const shaped_text& shaped) const noexcept
    {
        std::size_t first = visible_;
        while (first > 0 && !is_tab(shaped, slices_[first - 1])) --first;
        return first;
    }

    /// Makes the line wider, or narrower, by stretching its spaces after the last tab. Returns the increase: 0 if there
    /// are no spaces.
    double justify(const shaped_text& shaped, double gap) noexcept
    {
        const std::size_t first = behind_tabs(shaped);
        std::size_t spaces = 0;
        for (std::size_t k = first; k < visible_; ++k) spaces += count_spaces(shaped, slices_[k]);
        if (spaces == 0) return 0.0;
        for (std::size_t k = first; k < visible_; ++k) {
            line_slice& s = slices_[k];
            s.stretch = gap / static_cast<double>(spaces);
            s.width += s.stretch * static_cast<double>(count_spaces(shaped, s));
        }
        return gap;
    }

    /// Finds the glyphs of slices whose glyphs are contiguous. A writer then needs no clusters, which may have left the
    /// processor's cache. Stretched slices are written cluster by cluster.
    void find_glyphs(const shaped_text& shaped) noexcept
    {
        for (line_slice& s : slices_) {
            const bool back = s.level % 2 != 0;
            const text_cluster& low = shaped.cluster(back ? s.last - 1 : s.first);
            const text_cluster& high = shaped.cluster(back ? s.first : s.last - 1);
            const bool reversed = low.glyph > high.glyph;  // text that is read back ends with a hyphen
            s.item = low.item;
            s.together =
                !reversed && back == shaped.items()[s.item].to_the_left() && is_zero(s.stretch) && is_zero(s.spread);
            s.glyph = low.glyph;
            s.glyph_end = high.glyph + high.glyph_count;
        }
    }

    /// Replaces the slices by others that were made from them, and sets how many are visible.
    void replace(buffer<line_slice>& made, std::size_t visible) noexcept
    {
        slices_.swap(made);
        visible_ = visible;
    }

private:
    [[nodiscard]] static bool is_tab(const shaped_text& shaped, const line_slice& s) noexcept
    {
        return has(shaped.cluster(s.first).flags, cluster_flags::tab);
    }

    [[nodiscard]] static std::size_t count_spaces(const shaped_text& shaped, const line_slice& s) noexcept
    {
        std::size_t n = 0;
        for (std::uint32_t c = s.first; c < s.last; ++c)
            n += has(shaped.cluster(c).flags, cluster_flags::stretches) ? 1u : 0u;
        return n;
    }

    /// The start of the trailing clusters of a slice that have a flag.
    static std::uint32_t end_before(const shaped_text& shaped, const line_slice& s, cluster_flags flag) noexcept
    {
        std::uint32_t last = s.last;
        while (last > s.first && has(shaped.cluster(last - 1).flags, flag)) --last;
        return last;
    }

    /// Splits the trailing clusters that have a flag off the first `count` slices. Returns the number of slices before
    /// them. Unless `beyond_tabs`, it stops at a tab, and returns the number of slices up to the tab.
    result<std::size_t> part(const shaped_text& shaped, std::size_t count, cluster_flags flag,
                             bool beyond_tabs) noexcept
    {
        std::size_t k = count;
        while (k > 0 && end_before(shaped, slices_[k - 1], flag) == slices_[k - 1].first &&
               (beyond_tabs || !is_tab(shaped, slices_[k - 1])))
            --k;
        if (k == 0) return k;
        const line_slice all = slices_[k - 1];
        const std::uint32_t last = end_before(shaped, all, flag);
        if (last == all.last || last == all.first) return k;
        line_slice rest = all;
        rest.first = slices_[k - 1].last = last;
        if (!slices_.push_back(rest)) return error::out_of_memory;
        for (std::size_t m = slices_.size() - 1; m > k; --m) slices_[m] = slices_[m - 1];
        slices_[k] = rest;
        return k;
    }

    /// Splits invisible clusters off the first hanging white space after them. Returns the white space's slice.
    result<std::size_t> part_hanging(const shaped_text& shaped) noexcept
    {
        for (std::size_t k = visible_; k < slices_.size(); ++k) {
            std::uint32_t c = slices_[k].first;
            while (c < slices_[k].last && !has(shaped.cluster(c).flags, cluster_flags::hangs)) ++c;
            if (c == slices_[k].first) return k;
            if (c == slices_[k].last) continue;
            line_slice rest = slices_[k];
            rest.first = slices_[k].last = c;
            if (!slices_.push_back(rest)) return error::out_of_memory;
            for (std::size_t m = slices_.size() - 1; m > k + 1; --m) slices_[m] = slices_[m - 1];
            slices_[k + 1] = rest;
            return k + 1;
        }
        return slices_.size();
    }

    /// Removes the letter spacing after a line's last letter.
    void trim_spacing(const shaped_text& shaped, line_slice& s) noexcept
    {
        const double spacing = shaped.spacing_of(shaped.cluster(s.last - 1));
        s.width -= spacing;
        if (s.level % 2 != 0) s.lead = 0.0 - spacing;
    }

    buffer<line_slice> slices_;
    std::size_t visible_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
