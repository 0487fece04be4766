// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/layout/glyph_style.hpp>
#include <typemesh/layout/impl/ideographic.hpp>
#include <typemesh/layout/impl/text_cluster.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/outline/bar_face.hpp>
#include <typemesh/unicode/text_analysis.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The inline boxes and the rooms of a text, in its order.
class text_insets {
public:
    explicit text_insets(memory source = heap()) noexcept : boxes_{source}, rooms_{source}, borders_{source} {}

    void clear() noexcept
    {
        boxes_.clear();
        rooms_.clear();
        borders_.clear();
    }

    /// Reads them in any order. It makes each box a grapheme of its own. In the analysis it removes the places inside
    /// rooms where lines may end. Ends of rooms inside a grapheme are moved out of it.
    ///
    ///     borders    where the text is divided for shaping in any case
    ///
    /// Fails  error::bad_option "boxes": a number is out of range, or there is no U+FFFC, or another box has it;
    ///        "rooms": a number is out of range, or the range;
    ///        error::overlapping_spans: rooms; error::out_of_memory. There is then nothing.
    /// Cost   O(n log n) for n boxes and rooms, and the units of the rooms
    error read(const shape_options& how, text_view text, std::span<const std::uint32_t> borders,
               text_analysis& found) noexcept
    {
        clear();
        if (how.boxes.empty() && how.rooms.empty()) return {};
        error e = take_boxes(how.boxes, text, found);
        if (!e) e = take_rooms(how.rooms, found);
        if (!e) e = find_borders(borders, text);
        if (e) clear();
        return e;
    }

    [[nodiscard]] bool empty() const noexcept { return boxes_.empty() && rooms_.empty(); }
    /// The places where the text must be divided for shaping, ascending.
    [[nodiscard]] std::span<const std::uint32_t> borders(std::span<const std::uint32_t> others) const noexcept
    {
        if (empty()) return others;
        return borders_.view();
    }

    /// A box, and its index in the caller's list.
    struct numbered_box {
        inline_box box;
        std::uint32_t index = 0;
    };
    /// The box at a unit of the text, or null. Cost: O(log boxes)
    [[nodiscard]] const numbered_box* box_at(std::uint32_t unit) const noexcept
    {
        const auto k =
            first_where(0, boxes_.size(), [&](std::size_t i) noexcept { return boxes_[i].box.unit >= unit; });
        return k < boxes_.size() && boxes_[k].box.unit == unit ? &boxes_[k] : nullptr;
    }
    /// The room around a unit, or null. Cost: O(log rooms)
    [[nodiscard]] const text_room* room_at(std::uint32_t unit) const noexcept
    {
        const auto k = first_where(0, rooms_.size(), [&](std::size_t i) noexcept { return rooms_[i].last > unit; });
        return k < rooms_.size() && rooms_[k].first <= unit ? &rooms_[k] : nullptr;
    }
    /// Whether a unit is inside a room, and not its first one: no line begins there.
    [[nodiscard]] bool keeps(std::uint32_t unit) const noexcept
    {
        if (rooms_.empty()) return false;
        const text_room* const room = room_at(unit);
        return room != nullptr && room->first < unit;
    }

    /// The advance of a box, in em.
    [[nodiscard]] static double advance_of(const numbered_box& b, bool down) noexcept
    {
        return down ? b.box.ascent + b.box.descent : b.box.width;
    }
    /// Appends the glyph and the cluster of a box whose text is this range.
    ///
    /// Fails  error::out_of_memory
    static error append(const numbered_box& b, text_range text, std::uint32_t item, double advance,
                        buffer<shaped_glyph>& glyphs, buffer<text_cluster>& clusters) noexcept
    {
        const shaped_glyph g{
            .id = blank_bar + b.index, .cluster = text.first, .advance = advance, .flags = glyph_flags::box};
        const auto at = static_cast<std::uint32_t>(glyphs.size());
        const text_cluster c{text.first, text.last, at, 1, g.advance, item, cluster_flags::inset};
        return glyphs.push_back(g) && clusters.push_back(c) ? error{} : error{error::out_of_memory};
    }
    /// The way it is drawn: the map turns the unit square into the box.
    [[nodiscard]] static glyph_style style_of(const inline_box& b, bool down, double em, style_id style) noexcept
    {
        const double width = b.width * em, height = (b.ascent + b.descent) * em;
        return {.face = bar_face,
                .map = {.xx = width,
                        .dx = down ? -0.5 * width : 0.0,
                        .yy = height,
                        .dy = down ? 0.0 - height : 0.0 - b.descent * em},
                .style = style};
    }

    /// Whether the pen moves down, and an em in font units.
    struct axis {
        bool down;
        double em;
    };
    /// Spreads the clusters of rooms that are too narrow, and marks the clusters of all rooms.
    ///
    ///     clusters    of the whole text, in its order
    ///     spacing     double(const text_cluster&): the letter spacing after it
    template <class Spacing>
    void widen(text_view text, array_view<const text_item> items, const axis& way, const Spacing& spacing,
               array_view<text_cluster> clusters, shaped_glyph* glyphs) const noexcept
    {
        const auto [down, em] = way;
        std::size_t at = 0;
        for (const text_room& room : rooms_) {
            while (at < clusters.size() && clusters[at].first < room.first) ++at;
            std::size_t first = at;
            double width = 0.0;
            for (; at < clusters.size() && clusters[at].first < room.last; ++at) {
                clusters[at].flags = clusters[at].flags | cluster_flags::inset;
            }
            std::size_t last = at;
            while (last > first && has(clusters[last - 1].flags, cluster_flags::unshown)) --last;
            while (first < last && has(clusters[first].flags, cluster_flags::unshown)) ++first;
            if (first == last) continue;
            for (std::size_t k = first; k < last; ++k) width += clusters[k].advance;
            const double more = room.width * em - (width - spacing(clusters[last - 1]));
            if (!(more > 0.0)) continue;
            const auto parts = [&](std::size_t k) noexcept {  // whether there is a gap before a cluster
                return k == first || k == last || is_ideographic(decode(text, clusters[k].first).value) ||
                       is_ideographic(decode(text, clusters[k - 1].first).value);
            };
            std::size_t gaps = 1;
            for (std::size_t k = first + 1; k < last; ++k) gaps += parts(k) ? 1u : 0u;
            const double half = 0.5 * more / static_cast<double>(gaps);
            for (std::size_t k = first; k < last; ++k) {
                text_cluster& c = clusters[k];
                const double before = parts(k) ? half : 0.0, behind = parts(k + 1) ? half : 0.0;
                const double left = items[c.item].to_the_left() ? behind : before;
                c.advance += before + behind;
                if (c.glyph_count == 0) continue;
                glyphs[c.glyph + c.glyph_count - 1].advance += before + behind;
                for (std::uint32_t g = c.glyph; g < c.glyph + c.glyph_count; ++g)
                    glyphs[g].offset = glyphs[g].offset + (down ? point{0.0, 0.0 - left} : point{left, 0.0});
            }
        }
    }

private:
    /// The units of U+FFFC at a unit of the text; 0 if there is another character.
    static std::uint32_t object_at(text_view text, std::uint32_t unit) noexcept
    {
        if (unit >= text.size()) return 0;
        const code_point c = decode(text, unit);
        return c.value == 0xFFFC ? static_cast<std::uint32_t>(c.next - unit) : 0;
    }

    error take_boxes(std::span<const inline_box> given, text_view text, text_analysis& found) noexcept
    {
        for (const inline_box& b : given) {
            const std::uint32_t units = object_at(text, b.unit);
            const double height = b.ascent + b.descent;  // finite only if both are
            const bool sound = is_finite(b.width) && b.width >= 0.0 && is_finite(height) && height >= 0.0;
            if (!sound || units == 0 || boxes_.size() >= blank_bar) return error::bad("boxes").at(no_glyph, b.unit);
            if (!boxes_.push_back({b, static_cast<std::uint32_t>(boxes_.size())})) return error::out_of_memory;
            found.marks[b.unit] = found.marks[b.unit] | text_mark::grapheme;
            const std::uint32_t end = b.unit + units;
            if (end < text.size()) found.marks[end] = found.marks[end] | text_mark::grapheme;
        }
        detail::heap_sort(boxes_.data(), boxes_.size(), [](const numbered_box& a, const numbered_box& b) noexcept {
            return a.box.unit < b.box.unit;
        });
        for (std::size_t i = 1; i < boxes_.size(); ++i)
            if (boxes_[i].box.unit == boxes_[i - 1].box.unit)
                return error::bad("boxes").at(no_glyph, boxes_[i].box.unit);
        return {};
    }

    error take_rooms(std::span<const text_room> given, text_analysis& found) noexcept
    {
        const std::size_t size = found.marks.size();
        for (const text_room& r : given) {
            const bool sound = is_finite(r.width) && r.width >= 0.0 && is_finite(r.above);
            if (!sound || r.first > r.last || r.last > size) return error::bad("rooms").at(no_glyph, r.first);
            if (r.first != r.last && !rooms_.push_back(r)) return error::out_of_memory;
        }
        detail::heap_sort(rooms_.data(), rooms_.size(),
                          [](const text_room& a, const text_room& b) noexcept { return a.first < b.first; });
        for (std::size_t i = 1; i < rooms_.size(); ++i)
            if (rooms_[i].first < rooms_[i - 1].last)
                return error{error::overlapping_spans}.at(no_glyph, rooms_[i].first);
        const auto begins = [&found, size](std::size_t unit) noexcept {
            return unit == size || has(found.marks[unit], text_mark::grapheme);
        };
        std::uint32_t end = 0;
        std::size_t kept = 0;
        for (text_room r : rooms_) {
            while (r.first > end && !begins(r.first)) --r.first;
            if (r.first < end) r.first = end;
            while (!begins(r.last)) ++r.last;
            if (r.first >= r.last) continue;
            end = r.last;
            rooms_[kept++] = r;
            for (std::uint32_t u = r.first + 1; u < r.last; ++u)
                found.marks[u] = without(found.marks[u], text_mark::may_break | text_mark::hyphen);
        }
        rooms_.truncate(kept);
        return {};
    }

    error find_borders(std::span<const std::uint32_t> others, text_view text) noexcept
    {
        bool ok = borders_.append(array_view<const std::uint32_t>{others.data(), others.size()});
        for (const numbered_box& b : boxes_)
            ok = ok && borders_.push_back(b.box.unit) && borders_.push_back(b.box.unit + object_at(text, b.box.unit));
        for (const text_room& r : rooms_) ok = ok && borders_.push_back(r.first) && borders_.push_back(r.last);
        if (!ok) return error::out_of_memory;
        detail::heap_sort(borders_.data(), borders_.size(),
                          [](std::uint32_t a, std::uint32_t b) noexcept { return a < b; });
        return {};
    }

    buffer<numbered_box> boxes_;
    buffer<text_room> rooms_;
    buffer<std::uint32_t> borders_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
