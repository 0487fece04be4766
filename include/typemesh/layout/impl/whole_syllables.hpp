// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/text_analysis.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// UAX #29 separates vowels and tones of Burmese and Tai Tham from their consonant. This function makes them marks of
/// its grapheme: at the start of a line, a font would draw them on a dotted circle.
///
///     kaa, in UAX #29      |k|aa|
///     here                 |k aa|
///
/// Cost   O(n) for runs of these scripts; nothing for others
inline void keep_syllables_whole(text_view text, text_analysis& found) noexcept
{
    for (const script_run& run : found.scripts) {
        if (run.script != script_tag("Mymr") && run.script != script_tag("Lana")) continue;
        bool syllable = false;  // a letter is before it, or a mark on a letter
        for (std::size_t u = run.first; u < run.last;) {
            const code_point c = decode(text, u, run.last);
            const line_class line = character_of(c.value).line;
            if (syllable && line == line_class::sa_mark)
                found.marks[u] = without(found.marks[u], text_mark::grapheme | text_mark::may_break);
            syllable = line == line_class::sa || (syllable && line == line_class::sa_mark);
            u = c.next;
        }
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
