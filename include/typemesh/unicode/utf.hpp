// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/text_view.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A decoded code point, and the place of the next one.
struct code_point {
    char32_t value = 0xFFFD;
    std::size_t next = 0;
    bool valid = true;  ///< false if U+FFFD replaces something that is not valid UTF
};

/// Decodes the code point at text[i]. It reads no further than `end`. It never fails and always advances. Precondition:
/// i < end <= text.size().
///
/// UTF-8 follows Unicode's "substitution of maximal subparts" (The Unicode Standard, 3.9), and so does WHATWG's
/// decoder. The longest sequence of bytes that could begin a code point becomes one U+FFFD. Any other byte becomes a
/// separate U+FFFD. Overlong forms, surrogates and values beyond U+10FFFF are invalid.
///
///     E2 82 | 41        one U+FFFD, then A         E2 82 begins a sequence that is incomplete
///     C0 | AF           two U+FFFD                 no sequence begins with C0
///     ED | A0 | 80      three U+FFFD               a surrogate, which is invalid in UTF-8
///
/// In UTF-16 each unpaired half of a surrogate pair is one U+FFFD.
[[nodiscard]] inline code_point decode(text_view text, std::size_t i, std::size_t end) noexcept
{
    if (text.encoding() == encoding::utf16) {
        const char32_t unit = text.utf16()[i];
        if (unit < 0xD800 || unit > 0xDFFF) return {unit, i + 1, true};
        if (unit < 0xDC00 && i + 1 < end) {
            const char32_t low = text.utf16()[i + 1];
            if (low >= 0xDC00 && low <= 0xDFFF)
                return {0x10000 + ((unit - 0xD800) << 10) + (low - 0xDC00), i + 2, true};
        }
        return {0xFFFD, i + 1, false};
    }

    const auto byte = [&](std::size_t k) noexcept -> char32_t { return static_cast<unsigned char>(text.utf8()[k]); };
    const char32_t lead = byte(i);
    if (lead < 0x80) return {lead, i + 1, true};
    if (lead < 0xC2 || lead > 0xF4) return {0xFFFD, i + 1, false};

    const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    const char32_t lowest = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;  // of the second byte
    const char32_t highest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    char32_t value = lead & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if (i + k >= end) return {0xFFFD, i + k, false};
        const char32_t b = byte(i + k);
        if (k == 1 ? (b < lowest || b > highest) : (b & 0xC0) != 0x80) return {0xFFFD, i + k, false};
        value = value << 6 | (b & 0x3F);
    }
    return {value, i + length, true};
}

/// Decodes up to the end of the text.
[[nodiscard]] inline code_point decode(text_view text, std::size_t i) noexcept { return decode(text, i, text.size()); }

}  // namespace typemesh::inline TYPEMESH_ABI
