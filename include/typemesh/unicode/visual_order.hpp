// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/unicode/text_mark.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// A range of a text's units, [first, last).
struct text_range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

/// A stretch of one line that is read in one direction.
struct visual_run {
    std::uint32_t first = 0;
    std::uint32_t last = 0;  ///< one past its end
    std::uint8_t level = 0;  ///< odd: read to the left
};

namespace detail {

/// Rule L1: the runs of a line from its end to its start.
inline error line_runs(const std::uint8_t* levels, const text_mark* marks, std::uint8_t paragraph, text_range line,
                       buffer<visual_run>& runs) noexcept
{
    bool trailing = true;
    for (std::uint32_t i = line.last; i-- > line.first;) {
        if (has(marks[i], text_mark::separator))
            trailing = true;
        else if (!has(marks[i], text_mark::trailing))
            trailing = false;
        const std::uint8_t level = trailing ? paragraph : levels[i];
        if (!runs.empty() && runs.back().level == level)
            runs.back().first = i;
        else if (!runs.push_back({i, i + 1, level}))
            return error::out_of_memory;
    }
    return {};
}

/// Rule L2 for runs from the line's end to its start. Every sequence of runs at a level or above stands in the order of
/// that level: what is read first to the left or to the right. Such sequences lie in one another as brackets do, so a
/// stack of those that are still open joins them in one pass.
inline void sort_visually(buffer<visual_run>& runs, visual_run* sorted, std::uint32_t* next) noexcept
{
    struct group {
        std::uint8_t level;
        std::uint32_t left, right;  // runs at its ends; `next` links those between
    };
    group open[128] = {};
    std::size_t depth = 0;
    const auto join = [next](group& outer, const group& later) noexcept {
        if (outer.level % 2 == 0) {
            next[outer.right] = later.left;
            outer.right = later.right;
        } else {
            next[later.right] = outer.left;
            outer.left = later.left;
        }
    };
    for (auto k = static_cast<std::uint32_t>(runs.size()); k-- > 0;) {
        const std::uint8_t level = runs[k].level;
        while (depth > 0 && open[depth - 1].level > level) {
            if (depth > 1 && open[depth - 2].level >= level) {
                join(open[depth - 2], open[depth - 1]);
                --depth;
            } else
                open[depth - 1].level = level;
        }
        const group one{level, k, k};
        if (depth > 0 && open[depth - 1].level == level)
            join(open[depth - 1], one);
        else
            open[depth++] = one;
    }
    for (; depth > 1; --depth) join(open[depth - 2], open[depth - 1]);
    next[open[0].right] = 0;
    std::uint32_t k = open[0].left;
    for (std::size_t i = 0; i < runs.size(); ++i, k = next[k]) sorted[i] = runs[k];
    std::memcpy(runs.data(), sorted, runs.size() * sizeof(visual_run));
}

}  // namespace detail

/// Puts one line in visual order: rules L1 and L2 of UAX #9.
///
///     levels, marks   of the units of the text, as in a text_analysis; those of the line are read
///     paragraph       the level of its paragraph
///     runs            emptied first; gets the line's runs from left to right. Within a run of odd level the characters
///                     stand from right to left.
///
/// Fails  error::out_of_memory
/// Cost   O(length of the line)
inline error visual_runs(const std::uint8_t* levels, const text_mark* marks, std::uint8_t paragraph, text_range line,
                         workspace& space, buffer<visual_run>& runs) noexcept
{
    runs.clear();
    if (error e = detail::line_runs(levels, marks, paragraph, line, runs)) {
        runs.clear();
        return e;
    }
    if (runs.size() < 2) return {};
    workspace::scope scratch{space};
    auto* sorted = scratch.take<visual_run>(runs.size());
    auto* next = scratch.take<std::uint32_t>(runs.size());
    if (sorted == nullptr || next == nullptr) {
        runs.clear();
        return error::out_of_memory;
    }
    detail::sort_visually(runs, sorted, next);
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
