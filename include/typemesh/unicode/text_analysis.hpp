// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/unicode/impl/script_runs.hpp>
#include <typemesh/unicode/text_mark.hpp>
#include <typemesh/unicode/text_range.hpp>
#include <typemesh/unicode/visual_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A paragraph, including its separator, and its level: 0 if it is read to the right, 1 if it is read to the left.
struct text_paragraph {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint8_t level = 0;
};

/// The results of Unicode's algorithms for a text, found by a text_analyser. All places count units, as clusters do.
///
///     units     a  b     R  R  S  S  LF      "ab " and the two Hebrew letters R and S, of two bytes each
///     levels    0  0  0  1  1  1  1  0       one for each unit: odd levels are read to the left
///     marks     g  g  g  b     g     g       a set for each unit, text_mark. Here graphemes begin at g and at b; the
///                                            fourth grapheme, R, may also begin a line (b).
struct text_analysis {
    buffer<std::uint8_t> levels;        ///< the levels before rule L1 of UAX #9, which visual_runs() applies
    buffer<text_mark> marks;            ///< where graphemes begin and lines may end
    buffer<script_run> scripts;         ///< no run goes beyond a paragraph
    buffer<text_paragraph> paragraphs;  ///< one more than there are paragraph separators; the last one may be empty
    buffer<text_range> unbroken;        ///< ranges of Thai, Lao, Khmer, Burmese: lines could end inside, but only a
                                        ///< dictionary knows where, and the analyser has no dictionary; each range has
                                        ///< one script
    std::uint32_t invalid_units = 0;    ///< the number of places that are not valid UTF and are read as U+FFFD
    std::uint32_t first_invalid_unit = 0;

    explicit text_analysis(memory source = heap()) noexcept
        : levels{source}, marks{source}, scripts{source}, paragraphs{source}, unbroken{source}
    {
    }

    void clear() noexcept
    {
        levels.clear();
        marks.clear();
        scripts.clear();
        paragraphs.clear();
        unbroken.clear();
        invalid_units = first_invalid_unit = 0;
    }

    /// The paragraph that contains the unit i; after the end of the text, the last one. Cost: O(log(paragraphs))
    [[nodiscard]] const text_paragraph& paragraph_of(std::size_t i) const noexcept
    {
        TYPEMESH_ASSERT(!paragraphs.empty(), "a paragraph was requested before its text was analysed");
        const auto begins_behind = [&](std::size_t k) noexcept { return paragraphs[k].first > i; };
        return paragraphs[first_where(1, paragraphs.size(), begins_behind) - 1];
    }
};

/// The runs of one line from left to right: see visual_order.hpp. The line must lie in one paragraph.
///
/// Fails  error::out_of_memory
inline result<void> visual_runs(const text_analysis& text, text_range line, buffer<visual_run>& runs) noexcept
{
    TYPEMESH_ASSERT(line.first <= line.last && line.last <= text.levels.size(), "a line lies outside its text");
    return visual_runs(text.levels.data(), text.marks.data(), text.paragraph_of(line.first).level, line, runs);
}

}  // namespace typemesh::inline TYPEMESH_ABI
