// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/layout/text_style.hpp>
#include <typemesh/unicode/text_analysis.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The error for a style that is out of range; error::none if it is valid. `faces`: the number of the shaper's faces.
[[nodiscard]] inline error refused_style(const text_style& s, std::uint32_t faces) noexcept
{
    if (s.face >= faces) return {error::no_such_face, faces};
    if (!is_finite(s.size) || !(s.size > 0.0)) return error::bad("size");
    if (!is_finite(s.letter_spacing)) return error::bad("letter_spacing");
    if (!is_finite(s.word_spacing)) return error::bad("word_spacing");
    if (!is_finite(s.rise)) return error::bad("rise");
    if (!is_finite(s.slant)) return error::bad("slant");
    return {};
}

/// The styles of a text, by whole graphemes. Text outside all spans is plain: its style has number 0.
class style_spans {
public:
    explicit style_spans(memory source = heap()) noexcept : spans_{source}, borders_{source} {}

    void clear() noexcept
    {
        spans_.clear();
        borders_.clear();
        decorations_ = decoration::none;
        moved_ = 0;
    }

    /// Reads spans in any order; empty ones are dropped. An end inside a grapheme is moved out of the grapheme. If two
    /// spans meet inside a grapheme, the grapheme belongs to the first span. Features and languages must outlive this
    /// object.
    ///
    ///     faces    the number of the shaper's faces
    ///
    /// Fails  error::overlapping_spans: two spans contain the same unit; the cluster is the beginning of the second
    ///        span;
    ///        error::bad_option: a span ends before it begins or after the text, or a number of its style is out of
    ///        range; error::no_such_face; error::out_of_memory. There are then no spans.
    /// Cost   O(n log n) for n spans, O(n) if they are in the text's order
    error read(std::span<const style_span> given, const text_analysis& found, std::uint32_t faces) noexcept
    {
        clear();
        const error e = take(given, found, faces);
        if (e) clear();
        return e;
    }

    /// Moves ends of spans out of graphemes that have been joined since read().
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(n) for n spans
    error move_out_of(const text_analysis& joined) noexcept
    {
        borders_.clear();
        move_ends(joined);
        return find_borders();
    }

    [[nodiscard]] bool empty() const noexcept { return spans_.empty(); }
    /// The spans in the order of the text.
    [[nodiscard]] std::span<const style_span> spans() const noexcept { return spans_.view(); }

    /// The number of the style of a unit. Cost: O(log spans)
    [[nodiscard]] std::uint32_t number_at(std::uint32_t unit) const noexcept
    {
        const std::size_t k =
            first_where(0, spans_.size(), [&](std::size_t i) noexcept { return spans_[i].last > unit; });
        return k < spans_.size() && spans_[k].first <= unit ? static_cast<std::uint32_t>(k + 1) : 0;
    }
    /// The range of units around a unit that have the same style. Cost: O(log spans)
    [[nodiscard]] text_range range_at(std::uint32_t unit) const noexcept
    {
        const std::size_t k =
            first_where(0, spans_.size(), [&](std::size_t i) noexcept { return spans_[i].last > unit; });
        const std::uint32_t before = k == 0 ? 0 : spans_[k - 1].last;
        if (k == spans_.size()) return {before, no_cluster};
        return spans_[k].first <= unit ? text_range{spans_[k].first, spans_[k].last}
                                       : text_range{before, spans_[k].first};
    }
    /// The style with this number.
    [[nodiscard]] const text_style& operator[](std::uint32_t number) const noexcept
    {
        return number == 0 ? plain_ : spans_[number - 1].style;
    }

    /// The places where the text must be divided for shaping, ascending.
    [[nodiscard]] std::span<const std::uint32_t> borders() const noexcept { return borders_.view(); }

    /// All decorations in the styles.
    [[nodiscard]] decoration decorations() const noexcept { return decorations_; }

    /// The number of ends of spans that were moved.
    [[nodiscard]] std::uint32_t moved() const noexcept { return moved_; }

private:
    error take(std::span<const style_span> given, const text_analysis& found, std::uint32_t faces) noexcept
    {
        const std::size_t size = found.marks.size();
        for (const style_span& s : given) {
            if (s.first > s.last || s.last > size) return error::bad("spans").at(no_glyph, s.first);
            if (error e = refused_style(s.style, faces)) return e.at(no_glyph, s.first);
            if (s.first != s.last && !spans_.push_back(s)) return error::out_of_memory;
        }
        const auto before = [](const style_span& a, const style_span& b) noexcept { return a.first < b.first; };
        bool sorted = true;
        for (std::size_t i = 1; i < spans_.size(); ++i) sorted = sorted && !before(spans_[i], spans_[i - 1]);
        if (!sorted) detail::heap_sort(spans_.data(), spans_.size(), before);
        for (std::size_t i = 1; i < spans_.size(); ++i)
            if (spans_[i].first < spans_[i - 1].last)
                return error{error::overlapping_spans}.at(no_glyph, spans_[i].first);
        move_ends(found);
        return find_borders();
    }

    /// Moves ends out of graphemes, and drops spans that are then empty.
    void move_ends(const text_analysis& found) noexcept
    {
        const auto begins = [&found](std::size_t unit) noexcept {
            return unit == found.marks.size() || has(found.marks[unit], text_mark::grapheme);
        };
        std::uint32_t end = 0;  // of the previous span
        std::size_t kept = 0;
        for (style_span s : spans_) {
            moved_ += (begins(s.first) ? 0u : 1u) + (begins(s.last) ? 0u : 1u);
            while (s.first > end && !begins(s.first)) --s.first;
            if (s.first < end) s.first = end;
            while (!begins(s.last)) ++s.last;
            if (s.first >= s.last) continue;
            end = s.last;
            decorations_ = decorations_ | s.style.decorations;
            spans_[kept++] = s;
        }
        spans_.truncate(kept);
    }

    error find_borders() noexcept
    {
        const auto add = [this](std::uint32_t unit, const text_style& before, const text_style& behind) noexcept {
            return shaped_alike(before, behind) || borders_.push_back(unit);
        };
        for (std::size_t i = 0; i < spans_.size(); ++i) {
            const style_span& s = spans_[i];
            const bool follows = i > 0 && spans_[i - 1].last == s.first;
            const bool followed = i + 1 < spans_.size() && spans_[i + 1].first == s.last;
            if (!add(s.first, follows ? spans_[i - 1].style : plain_, s.style)) return error::out_of_memory;
            if (!followed && !add(s.last, s.style, plain_)) return error::out_of_memory;
        }
        return {};
    }

    text_style plain_;
    buffer<style_span> spans_;
    buffer<std::uint32_t> borders_;
    decoration decorations_ = decoration::none;
    std::uint32_t moved_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
