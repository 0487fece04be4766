// SPDX-License-Identifier: MIT
#include "unicode/break_test_file.hpp"

#include <typemesh/unicode/grapheme_boundaries.hpp>

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

TEST_CASE("graphemes are those of every case of GraphemeBreakTest.txt", "[breaks]")
{
    if (!ucd::is_of_our_version()) return;
    const auto cases = ucd::break_cases("auxiliary/GraphemeBreakTest.txt");
    CHECK(cases.size() == 602);
    for (const ucd::break_case& one : cases) {
        INFO(one.row);
        grapheme_boundaries begins;
        std::vector<bool> breaks;
        for (const char32_t c : one.text) breaks.push_back(begins(character_of(c).grapheme));
        breaks.push_back(true);  // the end, which is not asked for
        CHECK(breaks == one.breaks);
    }
}

TEST_CASE("letters with marks, syllables, flags and families are one grapheme each", "[breaks]")
{
    CHECK(graphemes(U"e\u0301") == 1);
    CHECK(graphemes(U"\u1100\u1161\u11A8") == 1);
    CHECK(graphemes(U"\r\n") == 1);
    CHECK(graphemes(U"\U0001F1E9\U0001F1EA\U0001F1EB\U0001F1F7\U0001F1E9") == 3);
    CHECK(graphemes(U"\U0001F468\u200D\U0001F469\u200D\U0001F467") == 1);
    CHECK(graphemes(U"a\u200D\U0001F467") == 2);
}
