// SPDX-License-Identifier: MIT
#include "unicode/break_test_file.hpp"

#include <typemesh/unicode/impl/word_boundaries.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

std::vector<bool> word_starts(std::u32string_view text)
{
    word_boundaries begins;
    std::vector<bool> starts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t k = i + 1;
        const auto next = [&]() noexcept {
            return k < text.size() ? word_character_of(text[k++]).word : word_class::newline;
        };
        starts.push_back(begins(word_character_of(text[i]).word, next));
    }
    return starts;
}

/// The words, each in brackets.
std::string words_of(const std::u32string& text)
{
    const auto starts = word_starts(text);
    std::string cut;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (starts[i] && i > 0) cut += '|';
        cut += text[i] < 0x80 ? static_cast<char>(text[i]) : '*';
    }
    return cut;
}

}  // namespace

TEST_CASE("words pass every case of WordBreakTest.txt", "[breaks]")
{
    ucd::check_break_cases("auxiliary/WordBreakTest.txt", 1944,
                           [](const std::vector<char32_t>& text) { return word_starts({text.data(), text.size()}); });
}

TEST_CASE("a word keeps its apostrophes, points within numbers, marks and numbers", "[breaks]")
{
    CHECK(words_of(U"don't stop") == "don't| |stop");
    CHECK(words_of(U"3.14, 2") == "3.14|,| |2");
    CHECK(words_of(U"a.b. c") == "a.b|.| |c");
    CHECK(words_of(U"e\u0301te\u0301") == "e*te*");
    CHECK(words_of(U"a\r\n\u0301b") == "a|\r\n|*|b");
    CHECK(words_of(U"a: b") == "a|:| |b");
}

TEST_CASE("joining types are Unicode's", "[tables]")
{
    using enum joining_type;
    CHECK(word_character_of(U'a').joining == none);
    CHECK(word_character_of(U'\u0628').joining == dual);     // beh
    CHECK(word_character_of(U'\u0627').joining == right);    // alef
    CHECK(word_character_of(U'\u0640').joining == causing);  // tatweel
    CHECK(word_character_of(U'\u064E').joining == transparent);
    CHECK(word_character_of(U'\uA872').joining == left);  // Phags-pa
    CHECK(word_character_of(char32_t{0x110000}).joining == none);
}
