// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/encoded.hpp"

#include <typemesh/unicode/text_range.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fuzz {

using test::append_utf16;
using test::append_utf8;

/// The character of a byte: critical characters are more frequent than others.
inline char32_t character_of(std::uint32_t byte) noexcept
{
    static constexpr char32_t others[] = {
        // directions: embeddings, isolates, marks; invisible characters
        0x202A, 0x202B, 0x202C, 0x202D, 0x202E, 0x2066, 0x2067, 0x2068, 0x2069, 0x200E, 0x200F, 0x061C, 0x00AD, 0x200B,
        0x200C, 0x200D, 0x2060, 0xFEFF, 0xFE0F, 0x20E3,
        // ends of lines and paragraphs, and spaces
        0x0A, 0x0D, 0x09, 0x0B, 0x0C, 0x1C, 0x1D, 0x1E, 0x1F, 0x85, 0x2028, 0x2029, 0xA0, 0x2003, 0x202F, 0x3000,
        0x1680,
        // letters of both directions, marks, digits
        0x05D0, 0x05D1, 0x05BF, 0x0628, 0x0628, 0x0627, 0x064B, 0x0660, 0x06F1, 0x0300, 0x0301, 0x0483, 0x0915, 0x094D,
        0x0937, 0x0E01, 0x0E33, 0x0E40, 0x1100, 0x1161, 0x11A8, 0xAC00, 0xAC01, 0x4E00, 0x3042, 0x30FC, 0x3001, 0x300C,
        0x300D, 0x2014, 0x2026, 0x201C, 0x201D, 0x2019, 0x2329, 0x232A, 0x10A00, 0x1E900, 0x1D7CE, 0x1F1E6, 0x1F1E7,
        0x1F468, 0x1F3FD, 0x1F466, 0x20000, 0xE0001, 0xE0100, 0x10FFFF, 0xFFFD, 0xFFFE, 0xFFFF, 0x7F, 0x0, 0xFB01,
        0x0178};
    constexpr std::uint32_t count = sizeof others / sizeof *others;
    return byte < 0x20 + count && byte >= 0x20 ? others[byte - 0x20]
           : byte < 0x20                       ? U'a' + byte % 26
                                               : U' ' + byte % 95;
}

/// A text of up to `most` units, and its memory: any bytes, or well-formed ones.
class read_text {
public:
    read_text(values& in, std::size_t most)
    {
        const std::uint32_t kind = in.byte() % 6;
        is_wide_ = kind % 2 != 0;
        const std::size_t count = in.below(4) == 0 ? most : in.below(48);
        for (std::size_t i = 0; i < count && !in.empty(); ++i) {
            const char32_t c = kind < 2 ? (is_wide_ ? in.bits(2) : in.byte()) : character_of(in.byte());
            if (kind == 0)
                utf8_ += static_cast<char>(static_cast<unsigned char>(c));
            else if (is_wide_)
                append_utf16(utf16_, c);
            else
                append_utf8(utf8_, c);
        }
    }

    [[nodiscard]] typemesh::text_view view() const noexcept
    {
        return is_wide_ ? typemesh::text_view{utf16_} : typemesh::text_view{utf8_};
    }

private:
    bool is_wide_ = false;
    std::string utf8_;
    std::u16string utf16_;
};

/// Hyphenates words at every so many units, also in wrong places and after the word.
struct any_hyphens {
    std::uint32_t step = 0;

    template <class Put>
    void hyphenate(typemesh::text_view, typemesh::text_range word, std::string_view, const Put& put) noexcept
    {
        for (std::size_t i = word.first; step != 0 && i <= word.last + std::size_t{step}; i += step) put(i);
    }
};

}  // namespace fuzz
