// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace test {

inline void append_utf8(std::string& text, char32_t c)
{
    const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (c < 0x80) return put(c);
    if (c >= 0x1'0000) put(0xF0 | c >> 18);
    if (c >= 0x800) put((c >= 0x1'0000 ? 0x80u : 0xE0u) | (c >> 12 & (c >= 0x1'0000 ? 0x3Fu : 0x0Fu)));
    put((c >= 0x800 ? 0x80u : 0xC0u) | (c >> 6 & (c >= 0x800 ? 0x3Fu : 0x1Fu)));
    put(0x80 | (c & 0x3F));
}

inline void append_utf16(std::u16string& text, char32_t c)
{
    if (c >= 0x1'0000) text += static_cast<char16_t>(0xD800 + ((c - 0x1'0000) >> 10));
    text += static_cast<char16_t>(c >= 0x1'0000 ? 0xDC00 + (c & 0x3FF) : c);
}

inline std::string utf8_of(const std::u32string& text)
{
    std::string s;
    for (const char32_t c : text) append_utf8(s, c);
    return s;
}

inline std::u16string utf16_of(const std::u32string& text)
{
    std::u16string s;
    for (const char32_t c : text) append_utf16(s, c);
    return s;
}

}  // namespace test
