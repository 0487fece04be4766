// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/ideographic.hpp>

using namespace typemesh;

TEST_CASE("Han, kana, Bopomofo and their punctuation are ideographic, and Hangul, Latin, emoji and spaces are not",
          "[paragraph]")
{
    for (const char32_t c : U"\u6F22\u304B\u30AB\u3041\u30FC\u3105\u3001\u300C\uFF08\uFF21\uFF76\U00020000")
        if (c != 0) CHECK(is_ideographic(c));
    for (const char32_t c : U"a1 .\u00E9\u0628\uAC00\u1100\u3000\u0301\u2014\U0001F600\U0001F1E9\u0E01")
        if (c != 0) CHECK_FALSE(is_ideographic(c));
}
