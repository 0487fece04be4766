// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

struct code_range {
    char32_t first;
    char32_t last;
};

template <std::size_t N>
[[nodiscard]] constexpr bool holds(const code_range (&sorted)[N], char32_t c) noexcept
{
    const std::size_t k = first_where(0, N, [&](std::size_t i) noexcept { return c <= sorted[i].last; });
    return k < N && c >= sorted[k].first;
}

}  // namespace detail

/// True for characters that need more than placing glyph after glyph, by character map and advance: right-to-left and
/// joining scripts, scripts that reorder, stack or attach their signs (Indian scripts, Thai, Lao, Tibetan, Burmese,
/// Khmer, ...), conjoining Hangul, combining marks of every script, joiners and bidirectional controls.
///
/// All other characters are plain: Latin, Greek, Cyrillic, Armenian, Georgian, Ethiopic, Cherokee, Han, kana, Hangul
/// syllables, Yi and similar scripts, punctuation and symbols. It is based on the blocks of Unicode 15, and true in
/// case of doubt.
[[nodiscard]] constexpr bool is_complex(char32_t c) noexcept
{
    constexpr detail::code_range ranges[] = {
        {0x0300, 0x036F},   {0x0483, 0x0489},   {0x0590, 0x109F},   {0x1100, 0x11FF},   {0x135D, 0x135F},
        {0x1700, 0x18AF},   {0x1900, 0x194F},   {0x1A00, 0x1C4F},   {0x1CD0, 0x1CFF},   {0x1DC0, 0x1DFF},
        {0x200C, 0x200F},   {0x202A, 0x202E},   {0x2066, 0x2069},   {0x20D0, 0x20FF},   {0x2CEF, 0x2CF1},
        {0x2D7F, 0x2D7F},   {0x2DE0, 0x2DFF},   {0x302A, 0x302F},   {0x3099, 0x309A},   {0xA66F, 0xA67D},
        {0xA69E, 0xA69F},   {0xA6F0, 0xA6F1},   {0xA800, 0xA82F},   {0xA840, 0xA9DF},   {0xA9E0, 0xAAFF},
        {0xABC0, 0xABFF},   {0xD7B0, 0xD7FF},   {0xFB1D, 0xFDFF},   {0xFE20, 0xFE2F},   {0xFE70, 0xFEFE},
        {0x101FD, 0x101FD}, {0x102E0, 0x102E0}, {0x10376, 0x1037A}, {0x10800, 0x11FBF}, {0x16100, 0x1613F},
        {0x16AF0, 0x16AF4}, {0x16B30, 0x16B36}, {0x16F4F, 0x16F92}, {0x16FE4, 0x16FF1}, {0x1BC00, 0x1BCAF},
        {0x1CF00, 0x1CF46}, {0x1D165, 0x1D1AD}, {0x1D242, 0x1D244}, {0x1D800, 0x1DAAF}, {0x1E000, 0x1E2FF},
        {0x1E4D0, 0x1E4FF}, {0x1E800, 0x1EEFF}, {0x1F1E6, 0x1F1FF}, {0x1F3FB, 0x1F3FF}, {0xE0020, 0xE007F},
    };
    return c >= 0x0300 && detail::holds(ranges, c);
}

/// True for characters that are invisible, even if the font has no glyph for them: soft hyphen, zero-width space, word
/// joiner, variation selectors, byte order mark. It follows Unicode's Default_Ignorable_Code_Point.
[[nodiscard]] constexpr bool is_default_ignorable(char32_t c) noexcept
{
    constexpr detail::code_range ranges[] = {
        {0x00AD, 0x00AD},   {0x034F, 0x034F},   {0x061C, 0x061C}, {0x115F, 0x1160}, {0x17B4, 0x17B5},
        {0x180B, 0x180F},   {0x200B, 0x200F},   {0x202A, 0x202E}, {0x2060, 0x206F}, {0x3164, 0x3164},
        {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0}, {0xFFF0, 0xFFF8}, {0x1BCA0, 0x1BCA3},
        {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF},
    };
    return c >= 0x00AD && detail::holds(ranges, c);
}

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

}  // namespace typemesh::inline TYPEMESH_ABI
