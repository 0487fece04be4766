// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The effect of a character on the direction in which its line is read.
enum class reading : std::uint8_t {
    to_the_right,  ///< letters of Latin, Han, Devanagari, ...
    to_the_left,   ///< letters of Hebrew, Arabic, N'Ko, ...
    digit,         ///< read to the right in any line; Arabic-Indic digits too
    separator,     ///< keeps two digits together: . , : / + -
    terminator,    ///< belongs to the digits beside it: % $ and similar characters
    neutral,       ///< spaces, other punctuation, symbols
};

/// The reading of one code point.
///
/// This is a coarse form of Unicode's Bidi_Class (UAX #9, version 14). Marks belong to their script's letters. Small
/// symbols inside letter blocks count as letters, and so do all characters that are not in the table. If it is wrong, a
/// line counts as a line of both directions, but is never set wrongly.
[[nodiscard]] inline reading reading_of(char32_t c) noexcept
{
    struct range {
        char32_t last;
        reading what;
    };
    constexpr auto R = reading::to_the_right, L = reading::to_the_left, D = reading::digit, S = reading::separator,
                   T = reading::terminator, N = reading::neutral;
    static constexpr range table[] = {
        {0x0022, N},  {0x0025, T},  {0x002A, N},   {0x002F, S},  {0x0039, D},  {0x003A, S},  {0x0040, N},  {0x005A, R},
        {0x0060, N},  {0x007A, R},  {0x009F, N},   {0x00A0, S},  {0x00A1, N},  {0x00A5, T},  {0x00A9, N},  {0x00AA, R},
        {0x00AF, N},  {0x00B1, T},  {0x00B3, D},   {0x00B4, N},  {0x00B5, R},  {0x00B8, N},  {0x00B9, D},  {0x00BA, R},
        {0x00BF, N},  {0x00D6, R},  {0x00D7, N},   {0x00F6, R},  {0x00F7, N},  {0x02B8, R},  {0x02BA, N},  {0x02C1, R},
        {0x02CF, N},  {0x02D1, R},  {0x02DF, N},   {0x02E4, R},  {0x036F, N},  {0x037D, R},  {0x037E, N},  {0x0383, R},
        {0x0385, N},  {0x0386, R},  {0x0387, N},   {0x0589, R},  {0x058E, N},  {0x058F, T},  {0x05FF, L},  {0x0605, D},
        {0x0607, N},  {0x0608, L},  {0x060A, T},   {0x060B, L},  {0x060C, S},  {0x060D, L},  {0x060F, N},  {0x065F, L},
        {0x0669, D},  {0x066A, T},  {0x066C, D},   {0x06DC, L},  {0x06DD, D},  {0x06DE, N},  {0x06E8, L},  {0x06E9, N},
        {0x06EF, L},  {0x06F9, D},  {0x07F5, L},   {0x07F9, N},  {0x088F, L},  {0x0891, D},  {0x08E1, L},  {0x08E2, D},
        {0x08FF, L},  {0x0E3E, R},  {0x0E3F, T},   {0x1FFF, R},  {0x200D, N},  {0x200E, R},  {0x200F, L},  {0x2029, N},
        {0x202A, R},  {0x202B, L},  {0x202C, N},   {0x202D, R},  {0x202E, L},  {0x202F, S},  {0x2034, T},  {0x2043, N},
        {0x2044, S},  {0x2065, N},  {0x2066, R},   {0x2067, L},  {0x206F, N},  {0x2070, D},  {0x2073, R},  {0x2079, D},
        {0x207B, S},  {0x207F, N},  {0x2089, D},   {0x208B, S},  {0x208F, N},  {0x209F, R},  {0x20CF, T},  {0x2106, N},
        {0x2107, R},  {0x2109, N},  {0x2113, R},   {0x2114, N},  {0x2115, R},  {0x2118, N},  {0x211D, R},  {0x2123, N},
        {0x2124, R},  {0x2125, N},  {0x2126, R},   {0x2127, N},  {0x2128, R},  {0x2129, N},  {0x212D, R},  {0x212E, T},
        {0x2139, R},  {0x214D, N},  {0x214E, R},   {0x215F, N},  {0x2188, R},  {0x2211, N},  {0x2212, S},  {0x2213, T},
        {0x2487, N},  {0x249B, D},  {0x2BFF, N},   {0x2DFF, R},  {0x3004, N},  {0x3007, R},  {0x3020, N},  {0x3029, R},
        {0x3030, N},  {0x3035, R},  {0x3037, N},   {0x303C, R},  {0x303F, N},  {0x309A, R},  {0x309C, N},  {0x309F, R},
        {0x30A0, N},  {0x30FA, R},  {0x30FB, N},   {0x31BF, R},  {0x31EF, N},  {0x31FF, R},  {0x33FF, N},  {0x4DBF, R},
        {0x4DFF, N},  {0xA48F, R},  {0xA4CF, N},   {0xA6FF, R},  {0xA721, N},  {0xFB1C, R},  {0xFB28, L},  {0xFB29, S},
        {0xFD3D, L},  {0xFD4F, N},  {0xFDCE, L},   {0xFDCF, N},  {0xFDFC, L},  {0xFE4F, N},  {0xFE50, S},  {0xFE51, N},
        {0xFE52, S},  {0xFE54, N},  {0xFE55, S},   {0xFE5E, N},  {0xFE5F, T},  {0xFE61, N},  {0xFE63, S},  {0xFE68, N},
        {0xFE6A, T},  {0xFE6F, N},  {0xFEFE, L},   {0xFF02, N},  {0xFF05, T},  {0xFF0A, N},  {0xFF0F, S},  {0xFF19, D},
        {0xFF1A, S},  {0xFF20, N},  {0xFF3A, R},   {0xFF40, N},  {0xFF5A, R},  {0xFF65, N},  {0xFFDF, R},  {0xFFE1, T},
        {0xFFE4, N},  {0xFFE6, T},  {0xFFFF, N},   {0x107FF, R}, {0x1091E, L}, {0x1091F, N}, {0x10B38, L}, {0x10B3F, N},
        {0x10D2F, L}, {0x10D39, D}, {0x10E5F, L},  {0x10E7E, D}, {0x10FFF, L}, {0x1D1FF, R}, {0x1D37F, N}, {0x1D7CD, R},
        {0x1D7FF, D}, {0x1E7FF, R}, {0x1EEEF, L},  {0x1F0FF, N}, {0x1F10A, D}, {0x1FBEF, N}, {0x1FBF9, D}, {0x1FFFF, N},
        {0xDFFFF, R}, {0xE0FFF, N}, {0x10FFFF, R},
    };
    const std::size_t last = sizeof table / sizeof table[0] - 1;
    return table[first_where(0, last, [c](std::size_t i) noexcept { return c <= table[i].last; })].what;
}

/// Whether a code point is right-to-left. It needs only a few comparisons.
[[nodiscard]] inline bool reads_to_the_left(char32_t c) noexcept
{
    if (c < 0x0590) return false;
    if (c > 0x08FF && (c < 0x200F || c > 0x2067) && (c < 0xFB1D || c > 0xFEFE) && (c < 0x10800 || c > 0x1EEEF))
        return false;
    return reading_of(c) == reading::to_the_left;
}

/// How often invalid units were read as U+FFFD, and the first such place.
struct invalid_places {
    std::uint32_t count = 0;
    cluster_id first = no_cluster;
};

/// The content of a line, and the first place of each kind.
struct line_reading {
    static constexpr std::size_t nowhere = ~std::size_t{0};

    std::size_t to_the_right = nowhere;  ///< the first letter read to the right
    std::size_t to_the_left = nowhere;   ///< the first letter read to the left
    bool only_ascii = true;
    invalid_places invalid;
};

/// Scans text[first, last) once.
[[nodiscard]] inline line_reading read_line(text_view text, std::size_t first, std::size_t last) noexcept
{
    line_reading found;
    for (std::size_t i = first; i < last;) {
        const code_point c = decode(text, i, last);
        if (found.to_the_right == line_reading::nowhere && reading_of(c.value) == reading::to_the_right)
            found.to_the_right = i;
        if (c.value >= 0x80) {
            found.only_ascii = false;
            if (!c.valid && found.invalid.count++ == 0) found.invalid.first = static_cast<cluster_id>(i);
            if (found.to_the_left == line_reading::nowhere && reads_to_the_left(c.value)) found.to_the_left = i;
        }
        i = c.next;
    }
    return found;
}

/// The first place in a right-to-left line where several characters must be read together from left to right. This is a
/// number of more than one digit, including separators between digits ("42", "3.5", "12:30"), or a digit beside a sign
/// that belongs to it ("5%"). A single digit reads the same in both directions. Otherwise line_reading::nowhere.
[[nodiscard]] inline std::size_t find_number(text_view text, std::size_t first, std::size_t last) noexcept
{
    // The previous character, and the one before it.
    reading before = reading::neutral, earlier = reading::neutral;
    std::size_t before_at = first, earlier_at = first;
    for (std::size_t i = first; i < last;) {
        const code_point c = decode(text, i, last);
        const reading what = reading_of(c.value);
        if (what == reading::digit) {
            if (before == reading::digit || before == reading::terminator) return before_at;
            if (before == reading::separator && earlier == reading::digit) return earlier_at;
        }
        if (what == reading::terminator && before == reading::digit) return before_at;
        earlier = before;
        earlier_at = before_at;
        before = what;
        before_at = i;
        i = c.next;
    }
    return line_reading::nowhere;
}

}  // namespace typemesh::inline TYPEMESH_ABI
