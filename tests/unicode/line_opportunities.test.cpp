// SPDX-License-Identifier: MIT
#include "unicode/break_test_file.hpp"
#include "unicode/slow_breaks.hpp"

#include <typemesh/unicode/line_opportunities.hpp>

#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

std::vector<line_opportunity> opportunities(const std::vector<char32_t>& text)
{
    std::vector<character> characters;
    for (const char32_t c : text) characters.push_back(character_of(c));
    line_opportunities next{characters.data(), characters.size()};
    std::vector<line_opportunity> all;
    for (std::size_t i = 0; i < text.size(); ++i) all.push_back(next(i));
    return all;
}

/// A text with | where a line may end and || where it must.
std::string shown(const std::u32string& text)
{
    const auto found = opportunities({text.begin(), text.end()});
    std::string s;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (found[i] != line_opportunity::none) s += found[i] == line_opportunity::allowed ? "|" : "||";
        s += text[i] < 0x80 ? static_cast<char>(text[i]) : 'x';
    }
    return s;
}

}  // namespace

TEST_CASE("line breaks are those of every case of LineBreakTest.txt", "[breaks]")
{
    if (!ucd::is_of_our_version()) return;
    const auto cases = ucd::break_cases("auxiliary/LineBreakTest.txt");
    CHECK(cases.size() == 7654);
    std::size_t wrong = 0;
    for (const ucd::break_case& one : cases) {
        const auto found = opportunities(one.text);
        std::vector<bool> breaks;
        for (const line_opportunity o : found) breaks.push_back(o != line_opportunity::none);
        breaks.push_back(true);  // the end, which is not asked for
        if (breaks != one.breaks && ++wrong <= 5) WARN(one.row);
    }
    CHECK(wrong == 0);
}

TEST_CASE("lines end behind spaces and hyphens, and must end behind line feeds", "[breaks]")
{
    CHECK(shown(U"a quick-witted fox") == "a |quick-|witted |fox");
    CHECK(shown(U"a\nb") == "a\n||b");
    CHECK(shown(U"a\r\n\nb") == "a\r\n||\n||b");
    CHECK(shown(U"(a) b") == "(a) |b");
    CHECK(shown(U"$ 3.50 or 1,000%") == "$ |3.50 |or |1,000%");
    CHECK(shown(U"日本。語") == "x|xx|x");
    CHECK(shown(U"ภาษาไทย") == "xxxxxxx");
    CHECK(shown(U"a-\u00A0b") == "a-|xb");
    CHECK(shown(U"א-\u00A0b") == "x-xb");  // LB21a holds where LB12a leaves it open
    CHECK(shown(U"").empty());
}

TEST_CASE("line breaks between any classes are those that the rules give word by word", "[breaks]")
{
    std::mt19937 random{5};
    const int count = static_cast<int>(line_class::sa_mark) + 1;
    for (int repeat = 0; repeat < 400000; ++repeat) {
        // Few classes in a text, so that rules of several characters are met.
        std::vector<line_class> some(1 + random() % 6), classes(1 + random() % 12);
        for (line_class& c : some) c = static_cast<line_class>(random() % count);
        for (line_class& c : classes) c = some[random() % some.size()];
        std::vector<character> text(classes.size());
        for (std::size_t i = 0; i < text.size(); ++i) text[i].line = classes[i];
        line_opportunities next{text.data(), text.size()};
        for (std::size_t i = 0; i < text.size(); ++i) {
            const int found = static_cast<int>(next(i));
            if (found == (i == 0 ? 0 : slow_breaks::breaks(classes, i))) continue;
            std::string shown;
            for (const line_class c : classes) shown += std::to_string(static_cast<int>(c)) + " ";
            FAIL("classes " << shown << ", before character " << i);
        }
    }
}
