// SPDX-License-Identifier: MIT
#include "unicode/break_test_file.hpp"

#include <typemesh/unicode/impl/grapheme_boundaries.hpp>

#include <vector>

using namespace typemesh;

namespace {

std::size_t graphemes(const std::u32string& text)
{
    grapheme_boundaries begins;
    std::size_t n = 0;
    for (const char32_t c : text) n += begins(character_of(c).grapheme) ? 1 : 0;
    return n;
}

}  // namespace

TEST_CASE("graphemes pass every case of GraphemeBreakTest.txt", "[breaks]")
{
    ucd::check_break_cases("auxiliary/GraphemeBreakTest.txt", 766, [](const std::vector<char32_t>& text) {
        grapheme_boundaries begins;
        std::vector<bool> breaks;
        for (const char32_t c : text) breaks.push_back(begins(character_of(c).grapheme));
        return breaks;
    });
}

TEST_CASE("a letter with marks, a syllable, a flag or a family is one grapheme", "[breaks]")
{
    CHECK(graphemes(U"e\u0301") == 1);
    CHECK(graphemes(U"\u1100\u1161\u11A8") == 1);
    CHECK(graphemes(U"\r\n") == 1);
    CHECK(graphemes(U"\U0001F1E9\U0001F1EA\U0001F1EB\U0001F1F7\U0001F1E9") == 3);
    CHECK(graphemes(U"\U0001F468\u200D\U0001F469\u200D\U0001F467") == 1);
    CHECK(graphemes(U"a\u200D\U0001F467") == 2);
}

TEST_CASE("a conjunct or a stack is one grapheme, whatever signs it contains", "[breaks]")
{
    CHECK(graphemes(U"\u0915\u094D\u0937") == 1);              // Devanagari kssa
    CHECK(graphemes(U"\u0915\u094D\u200D\u0937\u093F") == 1);  // with a joiner
    CHECK(graphemes(U"\u0915\u094D\u200C\u0937") == 2);        // split by a non-joiner
    CHECK(graphemes(U"\u0915\u0937") == 2);
    CHECK(graphemes(U"\u094D\u0937") == 2);
    CHECK(graphemes(U"\u179F\u178F\u17B7\u179F\u1798\u17D2\u1794\u1787\u1789\u17D2\u1789\u17C8") == 6);  // Khmer stacks
    CHECK(graphemes(U"\u1019\u1004\u103A\u1039\u1002\u101C") == 3);  // Burmese: kinzi
    CHECK(graphemes(U"\u1000\u1019\u1039\u1018\u101C") == 3);        // Burmese: a stack
    CHECK(graphemes(U"\u0B95\u0BCD\u0BB7") == 2);                    // Tamil's virama does not join
}
