// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/plain_text.hpp>
#include <typemesh/unicode/impl/character.hpp>

#include <string_view>

using namespace typemesh;

TEST_CASE("right-to-left text is never plain", "[layout][plain_text]")
{
    std::size_t wrong = 0;
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        if (c >= 0x1EF00 && c <= 0x1EFFF) continue;  // unassigned
        const bidi_class bidi = character_of(c).bidi;
        if (bidi == bidi_class::r || bidi == bidi_class::al || bidi == bidi_class::an) wrong += !is_complex(c);
    }
    CHECK(wrong == 0);
}

TEST_CASE("plain scripts are plain and complex ones are not", "[layout][plain_text]")
{
    for (const char32_t c :
         std::u32string_view{U"Az09 "
                             U"\u00E9\u0142\u03B1\u0416\u0531\u10D0\u1200\u13A0\u1401\u16A0\u1E00\u1F00\u2014\u20AC"
                             U"\u2122\u2500\u3042\u30A2\u4E16\uAC00\uA000\uFF21\uFFFD\uE000\U00020000\U0001F600"}) {
        INFO(static_cast<std::uint32_t>(c));
        CHECK(!is_complex(c));
    }
    for (const char32_t c : std::u32string_view{
             U"\u0301\u05D0\u0627\u0710\u0780\u07CA\u0905\u0995\u0B85\u0C05\u0D05\u0D85\u0E01\u0E81\u0F40\u1000\u1100"
             U"\u1780\u1820\u1A20\u1B05\u200D\u3099\uA8F2\uA984\uABC0\uFB50\uFE8D\U00010A00\U00011103\U0001E900"}) {
        INFO(static_cast<std::uint32_t>(c));
        CHECK(is_complex(c));
    }
}

TEST_CASE("default-ignorable characters are those that leave no mark", "[layout][plain_text]")
{
    for (const char32_t c : std::u32string_view{U"\u00AD\u034F\u200B\u200E\u2060\uFE0F\uFEFF\U000E0100"})
        CHECK(is_default_ignorable(c));
    for (const char32_t c : std::u32string_view{U"a \u00A0\u0300\u2010\u3000\uFFFD\uFE10"})
        CHECK(!is_default_ignorable(c));
}

TEST_CASE("Scripts whose letters are joined are known by their blocks", "[layout][plain_text]")
{
    for (const char32_t c : std::u32string_view{U"\u0628\u07CA\u1820\U0001E900"}) CHECK(is_written_joined(c));
    for (const char32_t c : std::u32string_view{U"a\u05D0\uFEFF\u4E00"}) CHECK_FALSE(is_written_joined(c));
}
