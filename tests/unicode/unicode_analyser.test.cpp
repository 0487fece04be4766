// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"
#include "support/encoded.hpp"
#include "unicode/break_test_file.hpp"

#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::analysed;
using test::utf16_of;
using test::utf8_of;

/// The marks or levels of the first units of all characters.
template <class T>
std::vector<T> of_characters(const text_analysis& found, const buffer<T>& all)
{
    std::vector<T> kept;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (has(found.marks[i], text_mark::character)) kept.push_back(all[i]);
    return kept;
}
std::vector<text_mark> marks_of(const text_analysis& found) { return of_characters(found, found.marks); }
std::vector<std::uint8_t> levels_of(const text_analysis& found) { return of_characters(found, found.levels); }

/// Laws for the analysis of any bytes.
void check_laws(text_view text, const text_analysis& found)
{
    REQUIRE(found.levels.size() == text.size());
    REQUIRE(found.marks.size() == text.size());
    REQUIRE_FALSE(found.paragraphs.empty());
    std::size_t at = 0;
    for (const text_paragraph& p : found.paragraphs) {
        REQUIRE(p.first == at);
        REQUIRE((p.last > p.first || &p == &found.paragraphs.back()));
        REQUIRE((p.first == 0 || p.first == text.size() || has(found.marks[p.first], text_mark::must_break)));
        for (std::size_t i = p.first; i < p.last; ++i) REQUIRE((found.levels[i] >= p.level && found.levels[i] <= 126));
        at = p.last;
    }
    REQUIRE(at == text.size());
    at = 0;
    for (const script_run& s : found.scripts) {
        REQUIRE(s.first == at);
        REQUIRE(s.last > s.first);
        REQUIRE(s.last <= found.paragraph_of(s.first).last);
        at = s.last;
    }
    REQUIRE(at == text.size());
    for (const text_range& r : found.unbroken)
        for (std::size_t i = r.first + 1; i < r.last; ++i)
            REQUIRE_FALSE(has(found.marks[i], text_mark::may_break | text_mark::must_break));
    constexpr text_mark of_first =
        text_mark::character | text_mark::grapheme | text_mark::may_break | text_mark::must_break;
    std::size_t next = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const text_mark m = found.marks[i];
        REQUIRE(has(m, text_mark::character) == (i == next));
        if (i == next)
            next = decode(text, i).next;
        else
            REQUIRE(!has(m, of_first));
        REQUIRE(!(has(m, text_mark::may_break) && has(m, text_mark::must_break)));
        // A line may end inside a grapheme only where UAX #14 wants it: between a space and a mark.
        if (has(m, text_mark::must_break)) REQUIRE(has(m, text_mark::grapheme));
    }
    if (text.size() > 0) REQUIRE(found.marks[0] == (found.marks[0] | text_mark::character | text_mark::grapheme));
}

}  // namespace

TEST_CASE("an analysis marks each unit of a text", "[analysis]")
{
    const text_analysis found = analysed(u8"say ש\u05C1ל\n");
    REQUIRE(found.levels.size() == 11);
    CHECK(levels_of(found) == std::vector<std::uint8_t>{0, 0, 0, 0, 1, 1, 1, 0});
    CHECK(found.levels[9] == 1);
    using enum text_mark;
    constexpr text_mark cg = character | grapheme;
    CHECK(marks_of(found) == std::vector<text_mark>{cg, cg, cg, cg | space | trailing, cg | may_break, character, cg,
                                                    cg | space | separator});
    REQUIRE(found.scripts.size() == 2);
    CHECK(found.scripts[1].first == 4);
    CHECK(found.scripts[1].script == script_tag("Hebr"));
    REQUIRE(found.paragraphs.size() == 2);
    CHECK(found.paragraphs[1].first == 11);
    CHECK(found.unbroken.empty());
}

TEST_CASE("an analysis does not depend on the encoding", "[analysis]")
{
    const std::u32string text =
        U"Hello (שלום 12) \U0001F468\u200D\U0001F469 e\u0301\r\n"
        U"มาก 漢字, ok\u2029\u0661%";
    const text_analysis eight = analysed(utf8_of(text)), sixteen = analysed(utf16_of(text));
    CHECK(levels_of(eight) == levels_of(sixteen));
    CHECK(marks_of(eight) == marks_of(sixteen));
    CHECK(marks_of(eight).size() == text.size());
    CHECK(eight.scripts.size() == sixteen.scripts.size());
    CHECK(eight.paragraphs.size() == 3);
    CHECK(sixteen.paragraphs.size() == 3);
    CHECK(eight.unbroken.size() == 1);
    check_laws(utf8_of(text), eight);
    check_laws(utf16_of(text), sixteen);
}

TEST_CASE("paragraphs end at separators, and CR LF is one", "[analysis]")
{
    const auto starts = [](std::u16string_view text) {
        const text_analysis found = analysed(text);
        std::vector<std::uint32_t> all;
        for (const text_paragraph& p : found.paragraphs) all.push_back(p.first);
        return all;
    };
    CHECK(starts(u"") == std::vector<std::uint32_t>{0});
    CHECK(starts(u"a") == std::vector<std::uint32_t>{0});
    CHECK(starts(u"a\n") == std::vector<std::uint32_t>{0, 2});
    CHECK(starts(u"a\r\nb\rc\x85"
                 u"d\u2029\x1C") == std::vector<std::uint32_t>{0, 3, 5, 7, 9, 10});
    CHECK(starts(u"a\v\f\u2028b") == std::vector<std::uint32_t>{0});  // these end lines, but not paragraphs
}

TEST_CASE("a given direction applies to every paragraph", "[analysis]")
{
    const text_analysis left = analysed("a\n1\n", {.direction = paragraph_direction::right_to_left});
    for (const text_paragraph& p : left.paragraphs) CHECK(p.level == 1);
    CHECK(left.levels[0] == 2);
    const text_analysis right = analysed(u8"ש", {.direction = paragraph_direction::left_to_right});
    CHECK(right.paragraphs[0].level == 0);
    CHECK(right.levels[0] == 1);
}

TEST_CASE("words that need a dictionary are listed by script, and nothing breaks inside", "[analysis]")
{
    using ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    for (const auto& [text, expected] : {std::pair<std::u16string, ranges>{u"ab ภาษาไทย cd ພາສາ", {{3, 10}, {14, 18}}},
                                         {u"ภาພາສາ\u1A20\u1A21", {{0, 2}, {2, 6}, {6, 8}}}}) {
        const text_analysis found = analysed(text);
        ranges unbroken;
        for (const text_range& r : found.unbroken) unbroken.emplace_back(r.first, r.last);
        CHECK(unbroken == expected);
        check_laws(text, found);
    }
}

TEST_CASE("the units of invalid UTF are counted", "[analysis]")
{
    const text_analysis found = analysed(
        "ab\xFF"
        "c\xE2\x82");
    CHECK(found.invalid_units == 2);
    CHECK(found.first_invalid_unit == 2);
    CHECK(analysed("ab").invalid_units == 0);
}

TEST_CASE("the analyser's breaks pass all test files in both encodings", "[analysis]")
{
    if (!ucd::is_of_our_version()) return;
    unicode_analyser analyser;
    text_analysis found;
    for (const char* file : {"auxiliary/LineBreakTest.txt", "auxiliary/GraphemeBreakTest.txt"}) {
        const bool lines = file[10] == 'L';
        std::size_t wrong = 0;
        for (const ucd::break_case& one : ucd::break_cases(file)) {
            const std::u32string text{one.text.begin(), one.text.end()};
            const auto wanted = [&](std::size_t i) { return i == 0 ? !lines : bool(one.breaks[i]); };
            const std::string eight = utf8_of(text);
            const std::u16string sixteen = utf16_of(text);
            for (const text_view view : {text_view{eight}, text_view{sixteen}}) {
                REQUIRE_FALSE(analyser.analyse(view, {}, found));
                const auto marks = marks_of(found);
                bool same = marks.size() == text.size();
                for (std::size_t i = 0; same && i < marks.size(); ++i)
                    same = has(marks[i], lines ? text_mark::may_break | text_mark::must_break : text_mark::grapheme) ==
                           wanted(i);
                if (!same && ++wrong <= 5) WARN(one.row);
            }
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("the analysis of any bytes obeys its laws", "[analysis]")
{
    std::mt19937 random{4};
    unicode_analyser analyser;
    text_analysis found;
    const std::u32string some =
        U"a 1-(\u05D0\u0628)[]\u0301\u200D\U0001F468\U0001F1E9\r\n\u2029\u0E01\u0E31\u2067\u2069\u202B$";
    for (int repeat = 0; repeat < 3000; ++repeat) {
        std::string bytes(random() % 50, ' ');
        for (char& c : bytes) c = static_cast<char>(random());
        std::u16string units(random() % 50, u' ');
        for (char16_t& c : units) c = static_cast<char16_t>(random());
        std::u32string text(random() % 50, U' ');
        for (char32_t& c : text) c = some[random() % some.size()];
        const std::string encoded = utf8_of(text);
        for (const text_view view : {text_view{bytes}, text_view{units}, text_view{encoded}}) {
            REQUIRE_FALSE(analyser.analyse(view, {}, found));
            check_laws(view, found);
        }
    }
}

TEST_CASE("each request for memory may fail, and a warm analyser has none", "[analysis]")
{
    const std::string text = utf8_of(U"Hello (שלום 12)\nมาก 漢字, \u2067ok\u2069\n");
    bool failed = true;
    for (std::size_t fail = 1; failed; ++fail) {
        test::counting_memory heap{.fail_at = fail, .fail_once = true};
        unicode_analyser analyser{heap.source()};
        text_analysis found{heap.source()};
        const error e = analyser.analyse(text, {}, found);
        failed = heap.requests >= fail;
        CHECK((failed ? e == error::out_of_memory && found.levels.empty() : !e && fail > 8));
        CHECK_FALSE(analyser.analyse(failed ? text : "", {}, found));
        const std::size_t warm = heap.requests;
        CHECK_FALSE(analyser.analyse(text, {}, found));
        CHECK(heap.requests == warm);
        check_laws(text, found);
    }
}

// Each text has a million pieces: a step that is not linear would exceed the time limit of a test.
TEST_CASE("long texts of all kinds are analysed", "[analysis]")
{
    unicode_analyser analyser;
    text_analysis found;
    std::u16string units;
    const std::u32string pieces[] = {
        U"Hello שלום (12%) ",    // mixed
        U"(",                    // never closed
        U"(\u05D0",              //
        U"[)",                   // never matched
        U"\u2067",               // deep isolates
        U"\u2068\u05D0",         // isolates that search for their first letter
        U"\u2068",               // isolates that find none
        U"\u202B\u05D0",         // deep embeddings
        U"\u202B\u05D0\u2067",   // both
        U"\u05D0\u2067a\u2069",  // one sequence of many runs
        U"\u05D0 . ",            // neutrals
        U"\u05D0$$$",            // terminators
        U"$(\u0301",             // rule LB25 looks ahead
        U"\U0001F1E9",           // flags
        U"\U0001F468\u200D",     // a family
        U"\u0E01",               // words that need a dictionary
        U"\n",                   // paragraphs
        U"漢か",                 // scripts
    };
    constexpr std::size_t many = 1'000'000;
    for (std::size_t k = 0; k <= std::size(pieces); ++k) {
        const std::u16string one = utf16_of(k < std::size(pieces) ? pieces[k] : U"");
        units.clear();
        for (std::size_t i = 0; i < many; ++i) units += one;
        if (one.empty()) units.append(many, u'(').append(many, u')');
        INFO("row " << k);
        REQUIRE_FALSE(analyser.analyse(units, {}, found));
        CHECK(found.levels.size() == units.size());
        CHECK(found.marks.size() == units.size());
    }
}
