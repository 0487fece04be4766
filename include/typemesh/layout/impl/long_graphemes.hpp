// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// The maximum number of characters of one grapheme that are shaped together. Real text has a tenth of that: UAX #15
/// allows 30 marks in a row (Stream-Safe Text).
inline constexpr std::size_t max_grapheme = 256;

/// A part of a text that is shaped by itself.
struct shaping_part {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t grapheme = 0;   ///< the start of the grapheme that the part begins within
    std::size_t inner_end = 0;  ///< the end of this grapheme; 0 if the part begins with a grapheme

    /// The cluster of a glyph of this part, which is the cluster of its grapheme.
    [[nodiscard]] constexpr std::size_t cluster(std::size_t unit) const noexcept
    {
        return unit < inner_end ? grapheme : unit;
    }
};

/// Cuts text[first, last), which begins with a grapheme, but only inside graphemes of more than max_grapheme
/// characters. The reason: a shaper's time may grow with the square of the number of a letter's marks.
///
///     a + 600 marks + b      first part: a and 255 marks, second: 256 marks, third: 89 marks and b
///
///     add(part)              called for each part in order; an error of it ends the call
///
/// Cost  O(n); nothing for text of at most max_grapheme units
template <class Add>
error cut_long_graphemes(text_view text, std::size_t first, std::size_t last, const Add& add) noexcept
{
    shaping_part open{first, last};
    if (last - first > max_grapheme) {
        grapheme_boundaries begins;
        std::size_t grapheme = first, count = 0;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            if (begins(c.value >= 0x20 && c.value < 0x7F ? grapheme_class::other : character_of(c.value).grapheme)) {
                if (open.inner_end == last) open.inner_end = i;
                grapheme = i;
                count = 0;
            } else if (count == max_grapheme) {
                open.last = i;
                if (open.inner_end == last) open.inner_end = i;
                if (error e = add(open)) return e;
                open = {i, last, grapheme, last};
                count = 0;
            }
            ++count;
            i = c.next;
        }
    }
    return add(open);
}

}  // namespace typemesh::inline TYPEMESH_ABI
