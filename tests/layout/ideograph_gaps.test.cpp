// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/layout/impl/ideograph_gaps.hpp>

using namespace typemesh;

TEST_CASE("Han, kana, Bopomofo and their punctuation are ideographic, and Hangul, Latin, emoji and spaces are not",
          "[paragraph]")
{
    for (const char32_t c : U"\u6F22\u304B\u30AB\u3041\u30FC\u3105\u3001\u300C\uFF08\uFF21\uFF76\U00020000")
        if (c != 0) CHECK(is_ideographic(c));
    for (const char32_t c : U"a1 .\u00E9\u0628\uAC00\u1100\u3000\u0301\u2014\U0001F600\U0001F1E9\u0E01")
        if (c != 0) CHECK_FALSE(is_ideographic(c));
}

TEST_CASE("a gap is at each space and beside each ideograph, but not before a space or at the text's end",
          "[paragraph]")
{
    const test::shaped_paragraph p{u"\u6F22\u5B57ab c\u6F22 d\u6F22"};
    std::string gaps;
    for (std::uint32_t c = 0; c < p.shaped.cluster_count(); ++c)
        gaps += has_ideograph_gap(p.shaped, p.shaped.cluster(c)) ? '|' : '.';
    CHECK(gaps ==
          "||.."
          "||.||.");
}
