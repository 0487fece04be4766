// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/layout/impl/column_runs.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The part of shape_options that an analyser needs.
[[nodiscard]] inline analysis_options analysis_of(const shape_options& how) noexcept
{
    analysis_options reading{.language = how.language};
    const bool downwards = how.direction == direction::top_to_bottom && how.columns.latin == column_latin::upright;
    if (how.direction == direction::left_to_right || downwards) reading.direction = paragraph_direction::left_to_right;
    if (how.direction == direction::right_to_left) reading.direction = paragraph_direction::right_to_left;
    return reading;
}

/// Splits a line or a column, which may have both directions, into items in drawing order: for shapers. It keeps its
/// memory for the next line.
class mixed_line {
public:
    explicit mixed_line(memory source = heap()) noexcept
        : analyser_{source}, found_{source}, runs_{source}, columns_{source}
    {
    }

    /// Splits text[first, last). No text before it affects its direction.
    ///
    ///     items   emptied first; gets the items from left to right. Places count from the text's start. Items are
    ///             made of whole graphemes.
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(n), plus O(log n) for each run
    error split(text_view text, std::size_t first, std::size_t last, const shape_options& how,
                buffer<text_item>& items) noexcept
    {
        columns_.clear();
        if (error e = analyser_.analyse(part_of(text, first, last), analysis_of(how), found_)) return e;
        return split_runs(first, last, items);
    }

    /// Does the same for a column, from top to bottom. has_form(c): whether the font has a vertical form of a
    /// character; see find_column_runs().
    template <class HasForm>
    error split_column(text_view text, std::size_t first, std::size_t last, const shape_options& how,
                       const HasForm& has_form, buffer<text_item>& items) noexcept
    {
        const text_view part = part_of(text, first, last);
        if (error e = analyser_.analyse(part, analysis_of(how), found_)) return e;
        if (error e = find_column_runs(part, found_.marks.view(), how.columns, {}, has_form, columns_)) return e;
        return split_runs(first, last, items);
    }

private:
    error split_runs(std::size_t first, std::size_t last, buffer<text_item>& items) noexcept
    {
        items.clear();
        const text_range whole{0, static_cast<std::uint32_t>(last - first)};
        join_graphemes();
        if (const auto done = visual_runs(found_, whole, runs_); !done) return done.error();
        for (const visual_run& run : runs_)
            if (error e = split_run(run, static_cast<std::uint32_t>(first), items)) return e;
        return {};
    }

    static text_view part_of(text_view text, std::size_t first, std::size_t last) noexcept
    {
        if (text.encoding() == encoding::utf8) return std::string_view{text.utf8() + first, last - first};
        return std::u16string_view{text.utf16() + first, last - first};
    }

    /// Marks take the properties of their letters, so that no grapheme is split.
    void join_graphemes() noexcept
    {
        for (std::size_t i = 1; i < found_.levels.size(); ++i) {
            if (has(found_.marks[i], text_mark::grapheme)) continue;
            found_.levels[i] = found_.levels[i - 1];
            found_.marks[i] = has(found_.marks[i - 1], text_mark::trailing) ? text_mark::trailing : text_mark::none;
        }
    }

    /// Splits a run where the script or the orientation in a column changes, but never inside a grapheme.
    error split_run(const visual_run& run, std::uint32_t offset, buffer<text_item>& items) noexcept
    {
        const std::size_t before = items.size();
        const array_view<const script_run> scripts = found_.scripts.view();
        const array_view<const column_run> columns = columns_.view();
        const auto ends_behind = [&run](const auto& runs) noexcept {
            return first_where(0, runs.size(), [&](std::size_t k) noexcept { return runs[k].last > run.first; });
        };
        std::size_t s = ends_behind(scripts), c = ends_behind(columns);
        for (std::uint32_t first = run.first; first < run.last && s < scripts.size();) {
            std::uint32_t last = scripts[s].last < run.last ? scripts[s].last : run.last;
            if (c < columns.size() && columns[c].last < last) last = columns[c].last;
            while (last < run.last && !has(found_.marks[last], text_mark::grapheme)) ++last;
            text_item item{
                .first = first + offset, .last = last + offset, .script = scripts[s].script, .level = run.level};
            if (c < columns.size()) {
                item.level = columns[c].level(run.level);
                item.orientation = columns[c].orientation;
            }
            if (first < last && !items.push_back(item)) return error::out_of_memory;
            first = last;
            while (s < scripts.size() && scripts[s].last <= last) ++s;
            while (c < columns.size() && columns[c].last <= last) ++c;
        }
        if (run.level % 2 != 0)
            for (std::size_t i = before, end = items.size(); i + 1 < end; ++i) swap_values(items[i], items[--end]);
        return {};
    }

    unicode_analyser analyser_;
    text_analysis found_;
    buffer<visual_run> runs_;
    buffer<column_run> columns_;  // empty for a line
};

}  // namespace typemesh::inline TYPEMESH_ABI
