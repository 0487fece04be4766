// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/bidi_analyser.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <algorithm>
#include <random>
#include <string>

using namespace typemesh;

namespace {

/// The marks that both analysers find.
text_mark without_line_ends(text_mark marks) { return without(marks, text_mark::may_break | text_mark::must_break); }

template <class A, class B, class Equal>
bool alike(const buffer<A>& a, const buffer<B>& b, const Equal& equal)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

}  // namespace

TEST_CASE("A bidi_analyser finds all that unicode_analyser finds except line ends", "[unicode]")
{
    // Blocks of ASCII only, of Latin, and of everything that raises a level or joins a grapheme.
    const std::vector<std::vector<std::pair<char32_t, char32_t>>> alphabets{
        {{0x20, 0x7E}, {0x20, 0x7E}, {0x09, 0x0D}},
        {{0x00, 0x17F}},
        {{0x20, 0x7E}, {0x300, 0x310}, {0x3040, 0x30FF}, {0x4E00, 0x4E80}, {0x900, 0x97F}, {0x2028, 0x2029}},
        {{0x20, 0x40},
         {0x5D0, 0x5EA},
         {0x620, 0x669},
         {0x200B, 0x200F},
         {0x202A, 0x202E},
         {0x2066, 0x2069},
         {0x0A, 0x0D}}};
    std::mt19937 random{11};
    const auto below = [&random](std::size_t n) { return random() % n; };
    bidi_analyser plain;
    unicode_analyser full;
    text_analysis a, b;
    for (int round = 0; round < 4000; ++round) {
        const auto& alphabet = alphabets[below(alphabets.size())];
        std::u16string text;
        for (std::size_t k = below(40); k > 0; --k) {
            const auto [first, last] = alphabet[below(alphabet.size())];
            text += static_cast<char16_t>(first + below(last - first + 1));
        }
        const analysis_options how{.direction = static_cast<paragraph_direction>(below(3))};
        INFO("round " << round);
        REQUIRE_FALSE(plain.analyse(text, how, a));
        REQUIRE_FALSE(full.analyse(text, how, b));
        REQUIRE(alike(a.levels, b.levels, [](auto x, auto y) { return x == y; }));
        REQUIRE(alike(a.marks, b.marks, [](text_mark x, text_mark y) { return x == without_line_ends(y); }));
        REQUIRE(alike(a.scripts, b.scripts, [](const script_run& x, const script_run& y) {
            return x.first == y.first && x.last == y.last && x.script == y.script;
        }));
        REQUIRE(alike(a.paragraphs, b.paragraphs, [](const text_paragraph& x, const text_paragraph& y) {
            return x.first == y.first && x.last == y.last && x.level == y.level;
        }));
    }
}
