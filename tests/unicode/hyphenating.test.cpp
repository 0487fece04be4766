// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/unicode/hyphenating.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace hyphenating_tests {
namespace {

/// Hyphenates words before every n-th unit, and records them.
struct every_unit {
    std::size_t step = 1;
    std::vector<std::u16string>* words = nullptr;

    template <class Put>
    void hyphenate(text_view text, text_range word, std::string_view language, const Put& put) noexcept
    {
        if (language == "xx") return;
        std::u16string shown;
        for (std::uint32_t i = word.first; i < word.last; ++i) shown += static_cast<char16_t>(text.unit(i));
        if (words != nullptr) words->push_back(shown);
        for (std::size_t i = 0; i < text.size() + 5; i += step) put(i);
    }
};
static_assert(hyphenator<every_unit>);
static_assert(!hyphenator<int>);
static_assert(text_analyser<hyphenating<unicode_analyser, every_unit>>);

/// A text with its hyphens, as "ex-am-ple".
std::u16string parted(const std::u16string& text, std::size_t step, std::string_view language = {})
{
    hyphenating analyser{unicode_analyser{}, every_unit{step}};
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(text, {.language = language}, found));
    std::u16string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (has(found.marks[i], text_mark::hyphen)) {
            CHECK(has(found.marks[i], text_mark::may_break));
            shown += u'-';
        }
        shown += text[i];
    }
    return shown;
}

std::vector<std::u16string> words_of(const std::u16string& text)
{
    std::vector<std::u16string> words;
    hyphenating analyser{unicode_analyser{}, every_unit{1, &words}};
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(text, {}, found));
    return words;
}

}  // namespace
}  // namespace hyphenating_tests

using namespace hyphenating_tests;

TEST_CASE("a hyphenator gets each word, which consists of letters and their marks", "[analysis]")
{
    using list = std::vector<std::u16string>;
    CHECK(words_of(u"One two, l'eau: x2y! end") == list{u"One", u"two", u"l", u"eau", u"x", u"y", u"end"});
    CHECK(words_of(u"na\u00EFve \u043C\u0438\u0440-e\u0301t") ==
          list{u"na\u00EFve", u"\u043C\u0438\u0440", u"e\u0301t"});
    CHECK(words_of(u"\u0301 12 \u4E16\u754C \u2191").empty());
    CHECK(words_of(u"").empty());
}

TEST_CASE("a word is hyphenated inside, between graphemes, and nowhere else", "[analysis]")
{
    CHECK(parted(u"abc de", 1) == u"a-b-c d-e");
    CHECK(parted(u"abcdef", 2) == u"ab-cd-ef");
    CHECK(parted(u"ae\u0301b", 1) == u"a-e\u0301-b");
    CHECK(parted(u"a", 1) == u"a");
    CHECK(parted(u"abc", 1, "xx") == u"abc");
}

TEST_CASE("a word with soft hyphens is hyphenated only there", "[analysis]")
{
    CHECK(words_of(u"exam\u00ADple one \u00ADtwo") == std::vector<std::u16string>{u"one", u"two"});
    CHECK(parted(u"exam\u00ADple", 1) == u"exam\u00ADple");
}

TEST_CASE("hyphenating keeps the results and errors of its analyser", "[analysis]")
{
    const std::u16string text = u"ab \u05D0\u05D1.\n12 cd";
    const text_analysis plain = test::analysed(text);
    text_analysis more;
    hyphenating both{unicode_analyser{}, every_unit{}};
    REQUIRE_FALSE(both.analyse(text, {}, more));
    for (std::size_t i = 0; i < text.size(); ++i) {
        CHECK(plain.levels[i] == more.levels[i]);
        if (!has(more.marks[i], text_mark::hyphen)) CHECK(plain.marks[i] == more.marks[i]);
    }
    test::counting_memory failing{.fail_at = 1};
    text_analysis none{failing.source()};
    CHECK(both.analyse(text, {}, none) == error::out_of_memory);
}
