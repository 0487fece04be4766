// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/first_where.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Cuts a line that holds text of both directions into items, in the order in which they are drawn: for shapers. Keeps
/// its memory for the next line.
class mixed_line {
public:
    explicit mixed_line(memory source = heap()) noexcept
        : analyser_{source}, found_{source}, space_{source}, runs_{source}
    {
    }

    /// Cuts text[first, last), which is read by itself: no text before it decides on its direction.
    ///
    ///     items   emptied first; then they stand from left to right, their places counted from the text's start
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(n) and O(log n) a run
    error cut(text_view text, std::size_t first, std::size_t last, const shape_options& how,
              buffer<text_item>& items) noexcept
    {
        items.clear();
        analysis_options reading{.language = how.language};
        if (how.direction == direction::left_to_right) reading.direction = paragraph_direction::left_to_right;
        if (how.direction == direction::right_to_left) reading.direction = paragraph_direction::right_to_left;
        if (error e = analyser_.analyse(part_of(text, first, last), reading, found_)) return e;
        const text_range whole{0, static_cast<std::uint32_t>(last - first)};
        if (error e = visual_runs(found_, whole, space_, runs_)) return e;
        for (const visual_run& run : runs_)
            if (error e = cut_run(run, static_cast<std::uint32_t>(first), items)) return e;
        return {};
    }

private:
    static text_view part_of(text_view text, std::size_t first, std::size_t last) noexcept
    {
        if (text.encoding() == encoding::utf8) return std::string_view{text.utf8() + first, last - first};
        return std::u16string_view{text.utf16() + first, last - first};
    }

    /// Cuts a run where the script changes.
    error cut_run(const visual_run& run, std::uint32_t offset, buffer<text_item>& items) noexcept
    {
        const std::size_t before = items.size();
        const std::span<const script_run> scripts = found_.scripts.view();
        const auto ends_behind = [&](std::size_t k) noexcept { return scripts[k].last > run.first; };
        for (std::size_t k = first_where(0, scripts.size(), ends_behind); k < scripts.size(); ++k) {
            const script_run& s = scripts[k];
            const std::uint32_t first = s.first > run.first ? s.first : run.first;
            const std::uint32_t last = s.last < run.last ? s.last : run.last;
            if (first >= last) break;
            const text_item item{
                .first = first + offset, .last = last + offset, .script = s.script, .level = run.level};
            if (!items.push_back(item)) return error::out_of_memory;
        }
        if (run.level % 2 != 0)
            for (std::size_t i = before, k = items.size(); i + 1 < k; ++i) std::swap(items[i], items[--k]);
        return {};
    }

    unicode_analyser analyser_;
    text_analysis found_;
    workspace space_;
    buffer<visual_run> runs_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
