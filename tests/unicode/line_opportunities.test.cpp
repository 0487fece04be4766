// SPDX-License-Identifier: MIT
#include "unicode/break_test_file.hpp"
#include "unicode/slow_breaks.hpp"

#include <typemesh/unicode/impl/line_opportunities.hpp>

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

/// A text with | where a line may end and || where it must end.
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

TEST_CASE("line breaks pass every case of LineBreakTest.txt", "[breaks]")
{
    ucd::check_break_cases("auxiliary/LineBreakTest.txt", 19338, [](const std::vector<char32_t>& text) {
        std::vector<bool> breaks;
        for (const line_opportunity o : opportunities(text)) breaks.push_back(o != line_opportunity::none);
        return breaks;
    });
}

TEST_CASE("lines may end after spaces and hyphens, and must end after line feeds", "[breaks]")
{
    CHECK(shown(U"a quick-witted fox") == "a |quick-|witted |fox");
    CHECK(shown(U"a\nb") == "a\n||b");
    CHECK(shown(U"a\r\n\nb") == "a\r\n||\n||b");
    CHECK(shown(U"(a) b") == "(a) |b");
    CHECK(shown(U"$ 3.50 or 1,000%") == "$ |3.50 |or |1,000%");
    CHECK(shown(U"日本。語") == "x|xx|x");
    CHECK(shown(U"ภาษาไทย") == "xxxxxxx");
    CHECK(shown(U"a-\u00A0b") == "a-|xb");
    CHECK(shown(U"א-\u00A0b") == "x-xb");  // LB21a decides where LB12a does not
    CHECK(shown(U"").empty());
}

TEST_CASE("abbreviations, ports, versions and numbers with a leading full stop stay whole", "[breaks]")
{
    CHECK(shown(U"see Fig.3 at localhost:8080, not .5") == "see |Fig.3 |at |localhost:8080, |not |.5");
    CHECK(shown(U"$ .5 (.5) v1.2:0") == "$ |.5 |(.5) |v1.2:0");
    CHECK(shown(U"the -able and well-known") == "the |-able |and |well-|known");
    CHECK(shown(U"the \u2010able") == "the |xable");
}

TEST_CASE("quotation marks stay with their quotation, and separate from ideographs", "[breaks]")
{
    CHECK(shown(U"dit \u00AB oui \u00BB fort") == "dit |x oui x |fort");
    CHECK(shown(U"a \u201Cb\u201D (c)") == "a |xbx |(c)");
    CHECK(shown(U"\u65E5\u201C\u672C\u201D\u8A9E") == "x|xxx|x");
    CHECK(shown(U"\u65E5\u201Cb\u201D\u8A9E") == "xxbxx");
}

TEST_CASE("lines end between the syllables of Javanese and Balinese, not inside", "[breaks]")
{
    CHECK(shown(U"\uA98F\uA9C0\uA9B1\uA9B1") == "xxx|x");
    CHECK(shown(U"\u1B13\u1B44\u25CC\u1B13") == "xxx|x");
    CHECK(shown(U"\u25CCa") == "xa");
}

TEST_CASE("line breaks between any classes agree with the rules word by word", "[breaks]")
{
    std::mt19937 random{5};
    const int count = static_cast<int>(line_class::sa_mark) + 1;
    for (int repeat = 0; repeat < 400000; ++repeat) {
        // A text has few classes, so that rules for several characters apply.
        std::vector<character> some(1 + random() % 6), text(1 + random() % 12);
        for (character& c : some) {
            c.line = static_cast<line_class>(random() % count);
            using enum line_class;
            c.wide = random() % 2 == 0 && !class_set<line_class>{bk, cr, lf, nl, sp, zw}.holds(c.line);
        }
        slow_breaks::letters letters;
        for (character& c : text) {
            c = some[random() % some.size()];
            letters.push_back({c.line, c.wide});
        }
        line_opportunities next{text.data(), text.size()};
        for (std::size_t i = 0; i < text.size(); ++i) {
            const int found = static_cast<int>(next(i));
            if (found == (i == 0 ? 0 : slow_breaks::breaks(letters, i))) continue;
            std::string shown;
            for (const character& c : text) shown += std::to_string(static_cast<int>(c.line)) + (c.wide ? "w " : " ");
            FAIL("classes " << shown << ", before character " << i);
        }
    }
}
