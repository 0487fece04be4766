// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// True for the characters of scripts whose letters are joined: Arabic, Syriac, N'Ko, Mandaic, Mongolian, Phags-pa and
/// related scripts. It is based on the blocks of Unicode 15.
[[nodiscard]] constexpr bool is_written_joined(char32_t c) noexcept
{
    constexpr detail::code_range ranges[] = {
        {0x0600, 0x077F},   {0x07C0, 0x07FF},   {0x0840, 0x08FF},   {0x1800, 0x18AF},   {0xA840, 0xA87F},
        {0xFB50, 0xFDFF},   {0xFE70, 0xFEFC},   {0x10AC0, 0x10AFF}, {0x10B80, 0x10BAF}, {0x10D00, 0x10D3F},
        {0x10F30, 0x10FDF}, {0x11660, 0x1167F}, {0x1E900, 0x1E95F},
    };
    return c >= 0x0600 && detail::holds(ranges, c);
}

/// Moves the letters of a shaped segment farther apart. A negative distance moves them closer together.
///
///     Hamburg          H a m b u r g        n letters have n - 1 distances between them. Letters are clusters: a base
///                                           and its marks, or other text that the shaper keeps together.
///
/// No distance is added between two letters of a joined script, which would tear them apart, and none at invisible
/// characters. Spaces count as letters.
///
///     glyphs      of text[.., last), in drawing order, unchanged after the shaper; `down`: of a column
///     distance    in font units
///
/// Returns the increase of the segment's length. Cost: O(n)
inline double space_letters(text_view text, std::size_t last, double distance, bool down,
                            array_view<placed_glyph> glyphs) noexcept
{
    cluster_id before = no_cluster;  // of the previous letter
    char32_t letter_before = 0;
    double moved = 0.0;
    for (placed_glyph& g : glyphs) {
        if (g.cluster != before && g.cluster < last) {
            const char32_t letter = decode(text, g.cluster, last).value;
            if (!is_default_ignorable(letter)) {
                const bool joined = is_written_joined(letter) && is_written_joined(letter_before);
                if (before != no_cluster && !joined) moved += distance;
                before = g.cluster;
                letter_before = letter;
            }
        }
        g.origin = g.origin + (down ? point{0.0, 0.0 - moved} : point{moved, 0.0});
    }
    return moved;
}

}  // namespace typemesh::inline TYPEMESH_ABI
