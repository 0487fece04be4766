// SPDX-License-Identifier: MIT
#ifdef TYPEMESH_TEST_WITH_ICU
#include "unicode/break_test_file.hpp"
#include "unicode/slow_breaks.hpp"

#include <typemesh/adapt/icu.hpp>
#include <typemesh/unicode/impl/word_boundaries.hpp>

#include <unicode/ubidi.h>
#include <unicode/uchar.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// The text with | where a line may end.
std::u16string broken(icu_analyser& analyser, const std::u16string& text)
{
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(text, {}, found));
    REQUIRE(found.unbroken.empty());
    std::u16string s;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (has(found.marks[i], text_mark::may_break)) s += u'|';
        s += text[i];
    }
    return s;
}

}  // namespace

TEST_CASE("lines may end between words that ICU's dictionaries know", "[adapt][icu]")
{
    icu_analyser analyser;
    CHECK((broken(analyser, u"ภาษาไทย") == u"ภาษา|ไทย"));
    CHECK((broken(analyser, u"ab ภาษาไทย cd") == u"ab |ภาษา|ไทย |cd"));
    CHECK((broken(analyser, u"ພາສາລາວ") == u"ພາສາ|ລາວ"));
    CHECK((broken(analyser, u"មានទឹក") == u"មាន|ទឹក"));
    CHECK((broken(analyser, u"ကမ္ဘာလူသား") == u"ကမ္ဘာ|လူသား"));
}

TEST_CASE("the words are the same in both encodings", "[adapt][icu]")
{
    icu_analyser analyser;
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(u8"ab ภาษาไทย", {}, found));
    CHECK(found.unbroken.empty());
    for (std::size_t i = 4; i < found.marks.size(); ++i) CHECK(has(found.marks[i], text_mark::may_break) == (i == 15));
}

TEST_CASE("beside words of a dictionary an analysis with ICU is that without", "[adapt][icu]")
{
    icu_analyser with;
    unicode_analyser without;
    text_analysis a, b;
    const std::u16string text = u"Hello (שלום 12) fox-trot\nภาษาไทย 漢字, ok";
    REQUIRE_FALSE(with.analyse(text, {}, a));
    REQUIRE_FALSE(without.analyse(text, {}, b));
    REQUIRE(b.unbroken.size() == 1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        CHECK(a.levels[i] == b.levels[i]);
        const bool inside = i > b.unbroken[0].first && i < b.unbroken[0].last;
        if (!inside) CHECK(a.marks[i] == b.marks[i]);
    }
}

TEST_CASE("what no dictionary of ICU's is for stays unbroken", "[adapt][icu]")
{
    icu_analyser analyser;
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(u"ภาษาไทย \u1A20\u1A21\u1A22", {}, found));  // Tai Tham
    REQUIRE(found.unbroken.size() == 1);
    CHECK(found.unbroken[0].first == 8);
    REQUIRE_FALSE(analyser.analyse(u"\u1A20\u1A21ภาษาไทย", {}, found));  // and holds up no other script
    REQUIRE(found.unbroken.size() == 1);
    CHECK(found.unbroken[0].last == 2);
    CHECK(has(found.marks[6], text_mark::may_break));
}

TEST_CASE("an analyser that has been moved goes on", "[adapt][icu]")
{
    icu_analyser first;
    CHECK((broken(first, u"ภาษาไทย") == u"ภาษา|ไทย"));
    icu_analyser second{std::move(first)};
    CHECK((broken(second, u"ภาษาไทย") == u"ภาษา|ไทย"));
    first = std::move(second);
    CHECK((broken(first, u"ภาษาไทย") == u"ภาษา|ไทย"));
}

// What follows compares unicode_analyser with ICU's own breaks and levels. Where ICU is of an older Unicode, every
// difference must be one between the two editions of the rules, as slow_breaks has them word by word.

namespace {

std::u16string utf16_of(const std::vector<char32_t>& text)
{
    std::u16string s;
    for (const char32_t c : text) {
        if (c >= 0x10000) s += static_cast<char16_t>(0xD7C0 + (c >> 10));
        s += static_cast<char16_t>(c < 0x10000 ? c : 0xDC00 | (c & 0x3FF));
    }
    return s;
}

/// Where ICU would end lines, or begin graphemes, of a text: before which units.
std::vector<bool> breaks_by_icu(UBreakIteratorType kind, const std::u16string& text)
{
    UErrorCode status = U_ZERO_ERROR;
    UBreakIterator* breaks = ubrk_open(kind, "", text.data(), static_cast<std::int32_t>(text.size()), &status);
    REQUIRE(U_SUCCESS(status));
    std::vector<bool> before(text.size() + 1);
    for (std::int32_t i = ubrk_first(breaks); i != UBRK_DONE; i = ubrk_next(breaks))
        before[static_cast<std::size_t>(i)] = true;
    ubrk_close(breaks);
    before.pop_back();
    return before;
}

std::vector<bool> breaks_by_us(text_mark which, const std::u16string& text)
{
    unicode_analyser analyser;
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(text, {}, found));
    std::vector<bool> before;
    for (const text_mark m : found.marks) before.push_back(has(m, which));
    return before;
}

/// The edition of slow_breaks that this ICU follows; 0 and a warning where there is none.
int edition_of_icu()
{
    UVersionInfo version;
    u_getUnicodeVersion(version);
    if (version[0] == 15 && version[1] == 0) return 15;
    if (version[0] == 16 || version[0] == 17) return version[0];
    WARN("Skipped: this ICU is of Unicode " << int(version[0]) << '.' << int(version[1]) << ", not 15.0, 16 or 17");
    return 0;
}

/// Where a word of ours begins: before which units of UTF-16.
std::vector<bool> words_by_us(const std::vector<char32_t>& text)
{
    word_boundaries begins;
    std::vector<bool> before;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t k = i + 1;
        const auto next = [&]() noexcept {
            return k < text.size() ? word_character_of(text[k++]).word : word_class::newline;
        };
        before.push_back(begins(word_character_of(text[i]).word, next));
        if (text[i] >= 0x10000) before.push_back(false);
    }
    return before;
}

std::vector<char32_t> random_text(std::mt19937& random, const std::u32string& letters)
{
    std::vector<char32_t> text(1 + random() % 20);
    for (char32_t& c : text) c = letters[random() % letters.size()];
    return text;
}

slow_breaks::letters letters_of(const std::vector<char32_t>& text)
{
    slow_breaks::letters all;
    for (const char32_t c : text) all.push_back({character_of(c).line, character_of(c).wide, c == 0x2010});
    return all;
}

/// Each break of ICU's must be ours, or what the older edition says and ours does not. Returns how many differ.
int compare_lines(const std::vector<char32_t>& text, int edition)
{
    const std::u16string units = utf16_of(text);
    const auto icu = breaks_by_icu(UBRK_LINE, units);
    const auto us = breaks_by_us(text_mark::may_break | text_mark::must_break, units);
    const slow_breaks::letters letters = letters_of(text);
    int different = 0;
    std::size_t unit = 0;
    for (std::size_t i = 0; i < text.size(); unit += text[i++] >= 0x10000 ? 2 : 1) {
        if (i == 0 || icu[unit] == us[unit]) continue;
        ++different;
        std::string shown;
        for (const char32_t c : text) shown += ucd::hex_of(c) + " ";
        INFO(shown << ", before character " << i);
        CHECK(edition != 17);
        CHECK((slow_breaks::breaks(letters, i, edition) != 0) == icu[unit]);
        CHECK((slow_breaks::breaks(letters, i) != 0) == us[unit]);
    }
    return different;
}

}  // namespace

TEST_CASE("ICU ends lines where we do, but where its edition of Unicode says otherwise", "[adapt][icu]")
{
    const int edition = edition_of_icu();
    if (edition == 0) return;
    // Characters whose classes are the same in all editions, but for hyphens and letters of Javanese.
    const std::u32string letters =
        U"ab1 -.,:/!?$%()[]\u00AB\u00BB\u2018\u2019\u201C\u201D\"\u05D0\u0628\u0301\u200D\u200B\u2060\u00A0\u00AD"
        U"\u2014\u2010\u2026\u3001\u6F22\u3041\u30FC\uAC00\uAC01\u1100\u1161\u11A8\U0001F1E9\U0001F466"
        U"\U0001F3FB\U0001FAFF\u2028\u000D\u000A\u0085\uFFFC\u2329\uFF08\u0E3F\u20AC\u0915\u094D\uA98F\uA9C0\u25CC";
    std::mt19937 random{11};
    int different = 0;
    for (int repeat = 0; repeat < 20000; ++repeat) different += compare_lines(random_text(random, letters), edition);
    CHECK((different > 0) == (edition != 17));
    if (edition != 17 || !ucd::is_of_our_version()) return;
    for (const ucd::break_case& one : ucd::break_cases("auxiliary/LineBreakTest.txt")) compare_lines(one.text, 17);
}

TEST_CASE("ICU begins graphemes where we do", "[adapt][icu]")
{
    if (edition_of_icu() == 0) return;
    // Without marks of no combining class, emoji modifiers say, which ICU keeps out of conjuncts up to Unicode 15.
    const std::u32string letters =
        U"ab1 "
        U"\u00AD\u0301\u0301\u200D\u200C\u200B\u0915\u0937\u094D\u093F\u0B95\u0BCD\u0E01\u0E33\u0E48\u0600\uAC00\uAC01"
        U"\u1100\u1161\u11A8\U0001F1E9\U0001F466\u2764\u000D\u000A";
    std::mt19937 random{13};
    for (int repeat = 0; repeat < 20000; ++repeat) {
        const auto text = random_text(random, letters);
        const std::u16string units = utf16_of(text);
        std::string shown;
        for (const char32_t c : text) shown += ucd::hex_of(c) + " ";
        INFO(shown);
        CHECK((breaks_by_icu(UBRK_CHARACTER, units) == breaks_by_us(text_mark::grapheme, units)));
    }
}

TEST_CASE("ICU finds the levels that we find, where no embeddings and overrides are", "[adapt][icu]")
{
    if (edition_of_icu() == 0) return;
    const std::u32string letters =
        U"ab\u05D0\u05D1\u0628\u0301+-$%.,:1\u0661 \t!()[]<>\u2066\u2067\u2068\u2069\u200E\u200F\u00AD";
    std::mt19937 random{12};
    UErrorCode status = U_ZERO_ERROR;
    UBiDi* bidi = ubidi_open();
    unicode_analyser analyser;
    text_analysis found;
    for (int repeat = 0; repeat < 20000; ++repeat) {
        const std::u16string text = utf16_of(random_text(random, letters));
        const auto size = static_cast<std::int32_t>(text.size());
        ubidi_setPara(bidi, text.data(), size, UBIDI_DEFAULT_LTR, nullptr, &status);
        const UBiDiLevel* levels = ubidi_getLevels(bidi, &status);
        REQUIRE(U_SUCCESS(status));
        REQUIRE_FALSE(analyser.analyse(text, {}, found));
        buffer<visual_run> runs;
        REQUIRE(visual_runs(found, {0, static_cast<std::uint32_t>(size)}, runs));  // after rule L1, as ICU's
        // Where all is read in one direction ICU gives the paragraph's level instead of those of nested isolates.
        const int modulus = ubidi_getDirection(bidi) == UBIDI_MIXED ? 256 : 2;
        for (const visual_run& run : runs)
            for (std::uint32_t i = run.first; i < run.last; ++i)
                if (character_of(text[i]).bidi != bidi_class::bn && levels[i] % modulus != run.level % modulus) {
                    std::string shown;
                    for (const char16_t c : text) shown += ucd::hex_of(c) + " ";
                    FAIL(shown << ", character " << i);
                }
    }
    ubidi_close(bidi);
}

TEST_CASE("ICU begins words where we do, beside scripts of its dictionaries", "[adapt][icu]")
{
    const int edition = edition_of_icu();
    if (edition == 0) return;
    // ICU's own changes to UAX #29 are left out, as ICU 72.1 of Unicode 15.0 has them: the commercial at is like a letter
    // for it, so that addresses are whole, and the colon, which it has within words only in Swedish, ends one. Hangul
    // syllables, kana and ideographs belong to its dictionary of East Asian words.
    const std::u32string letters =
        U"ab1 -.,'/!?$%()[]_;#\"\u2019\u00AD\u0301\u200D\u200B\u2060\u00A0\u05D0\u05D1\u0628\u0640\u0915\u094D"
        U"\u093F\u0661\u2024\u00B7\u24C2\u1100\u1161\u0431\U0001F1E9\U0001F1EA\U0001F466\U0001F3FB\u2764\u2028"
        U"\u000D\u000A\u0085\u3000\u2003\uFE0F";
    std::mt19937 random{17};
    for (int repeat = 0; repeat < 20000; ++repeat) {
        const auto text = random_text(random, letters);
        const std::u16string units = utf16_of(text);
        std::string shown;
        for (const char32_t c : text) shown += ucd::hex_of(c) + " ";
        INFO(shown);
        CHECK((breaks_by_icu(UBRK_WORD, units) == words_by_us(text)));
    }
}
#endif
