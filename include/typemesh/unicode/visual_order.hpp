// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/unicode/text_mark.hpp>
#include <typemesh/unicode/text_range.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A part of one line that is read in one direction.
struct visual_run {
    std::uint32_t first = 0;
    std::uint32_t last = 0;  ///< one past its end
    std::uint8_t level = 0;  ///< odd: read to the left
};

/// Sorts the parts of a line, each with a `level`, from left to right: rule L2 of UAX #9. Before the call they are in
/// reading order. `parts` is a std::span, or any other type with data() and size(). Cost: O(n) for each level; there
/// are at most 126 levels.
template <class Parts>
void order_visually(Parts&& parts) noexcept
{
    const array_view line{parts.data(), parts.size()};
    unsigned highest = 0;
    for (const auto& run : line) highest = run.level > highest ? run.level : highest;
    for (unsigned level = highest; level > 0; --level)
        for (std::size_t first = 0; first < line.size(); ++first) {
            std::size_t last = first;
            while (last < line.size() && line[last].level >= level) ++last;
            for (std::size_t a = first, b = last; a + 1 < b;) swap_values(line[a++], line[--b]);
            if (last > first) first = last;
        }
}

/// Finds the parts of a line that get the level of their paragraph: rule L1 of UAX #9. Call it for the parts of a line
/// from the line's end to its start. These parts are separators (tabs), and white space before a separator or at the
/// line's end.
class line_end_rule {
public:
    /// Whether the rule selects the next part towards the start.
    constexpr bool takes(bool separator, bool white_space) noexcept
    {
        return takes_ = separator || (takes_ && white_space);
    }

private:
    bool takes_ = true;
};

namespace detail {

/// Finds the runs of a line from its end to its start.
inline error line_runs(const std::uint8_t* levels, const text_mark* marks, std::uint8_t paragraph, text_range line,
                       buffer<visual_run>& runs) noexcept
{
    line_end_rule rule;
    for (std::uint32_t i = line.last; i-- > line.first;) {
        const bool reset = rule.takes(has(marks[i], text_mark::separator), has(marks[i], text_mark::trailing));
        const std::uint8_t level = reset ? paragraph : levels[i];
        if (!runs.empty() && runs.back().level == level)
            runs.back().first = i;
        else if (!runs.push_back({i, i + 1, level}))
            return error::out_of_memory;
    }
    return {};
}

}  // namespace detail

/// Puts one line in visual order: rules L1 and L2 of UAX #9.
///
///     levels, marks   the levels and marks of the text's units, as in a text_analysis; only the units of the line are
///                     read
///     paragraph       the level of its paragraph
///     runs            emptied first; gets the line's runs from left to right. Within a run of odd level the characters
///                     are ordered from right to left.
///
/// Fails  error::out_of_memory
/// Cost   O(length of the line), plus the cost of order_visually()
inline result<void> visual_runs(const std::uint8_t* levels, const text_mark* marks, std::uint8_t paragraph,
                                text_range line, buffer<visual_run>& runs) noexcept
{
    runs.clear();
    if (error e = detail::line_runs(levels, marks, paragraph, line, runs)) {
        runs.clear();
        return e;
    }
    for (std::size_t a = 0, b = runs.size(); a + 1 < b;) swap_values(runs[a++], runs[--b]);
    order_visually(runs.view());
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
