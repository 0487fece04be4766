// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "windows/counted.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite_analyser.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace directwrite_analyser_test {

constexpr UINT8 neutral = DWRITE_BREAK_CONDITION_NEUTRAL, can = DWRITE_BREAK_CONDITION_CAN_BREAK,
                may_not = DWRITE_BREAK_CONDITION_MAY_NOT_BREAK, must = DWRITE_BREAK_CONDITION_MUST_BREAK;

/// An IDWriteTextAnalyzer with a list of words. It reports at the beginning of each word what a test wants.
class fake_words final : public test::counted<IDWriteTextAnalyzer> {
public:
    fake_words() = default;
    explicit fake_words(std::wstring word) : words{std::move(word)} {}

    std::vector<std::wstring> words;
    UINT8 before = can, after = can;
    bool everywhere = false;  // breaks before every unit
    bool overruns = false;    // reports on units after the text, too
    unsigned calls = 0;
    unsigned fails_at = 0;  // that call, counted from 1
    HRESULT failure = E_FAIL;
    std::vector<std::wstring> languages;

    HRESULT STDMETHODCALLTYPE AnalyzeLineBreakpoints(IDWriteTextAnalysisSource* source, UINT32 at, UINT32 length,
                                                     IDWriteTextAnalysisSink* sink) noexcept override
    {
        if (++calls == fails_at) return failure;
        const WCHAR *units = nullptr, *language = nullptr;
        UINT32 count = 0, same = 0;
        if (FAILED(source->GetTextAtPosition(at, &units, &count)) || count < length) return E_INVALIDARG;
        if (FAILED(source->GetLocaleName(at, &same, &language)) || same < length) return E_INVALIDARG;
        languages.push_back(language);
        const std::wstring text{units, length};
        std::vector<bool> begins(length, everywhere);
        for (const std::wstring& word : words)
            for (std::size_t i = text.find(word); i != std::wstring::npos; i = text.find(word, i + 1)) begins[i] = true;
        std::vector<DWRITE_LINE_BREAKPOINT> said(length + 5);
        for (std::size_t i = 0; i < length; ++i) {
            said[i].breakConditionBefore = (begins[i] ? before : neutral) & 3;
            said[i].breakConditionAfter = (i + 1 < length && begins[i + 1] ? after : neutral) & 3;
        }
        // In two parts, as DirectWrite may do.
        const UINT32 half = length / 2;
        if (FAILED(sink->SetLineBreakpoints(at, half, said.data()))) return E_FAIL;
        return sink->SetLineBreakpoints(at + half, length - half + (overruns ? 5 : 0), said.data() + half);
    }

    TYPEMESH_TEST_UNUSED(AnalyzeScript, IDWriteTextAnalysisSource*, UINT32, UINT32, IDWriteTextAnalysisSink*);
    TYPEMESH_TEST_UNUSED(AnalyzeBidi, IDWriteTextAnalysisSource*, UINT32, UINT32, IDWriteTextAnalysisSink*);
    TYPEMESH_TEST_UNUSED(AnalyzeNumberSubstitution, IDWriteTextAnalysisSource*, UINT32, UINT32,
                         IDWriteTextAnalysisSink*);
    TYPEMESH_TEST_UNUSED(GetGlyphs, const WCHAR*, UINT32, IDWriteFontFace*, BOOL, BOOL, const DWRITE_SCRIPT_ANALYSIS*,
                         const WCHAR*, IDWriteNumberSubstitution*, const DWRITE_TYPOGRAPHIC_FEATURES**, const UINT32*,
                         UINT32, UINT32, UINT16*, DWRITE_SHAPING_TEXT_PROPERTIES*, UINT16*,
                         DWRITE_SHAPING_GLYPH_PROPERTIES*, UINT32*);
    TYPEMESH_TEST_UNUSED(GetGlyphPlacements, const WCHAR*, const UINT16*, DWRITE_SHAPING_TEXT_PROPERTIES*, UINT32,
                         const UINT16*, const DWRITE_SHAPING_GLYPH_PROPERTIES*, UINT32, IDWriteFontFace*, FLOAT, BOOL,
                         BOOL, const DWRITE_SCRIPT_ANALYSIS*, const WCHAR*, const DWRITE_TYPOGRAPHIC_FEATURES**,
                         const UINT32*, UINT32, FLOAT*, DWRITE_GLYPH_OFFSET*);
    TYPEMESH_TEST_UNUSED(GetGdiCompatibleGlyphPlacements, const WCHAR*, const UINT16*, DWRITE_SHAPING_TEXT_PROPERTIES*,
                         UINT32, const UINT16*, const DWRITE_SHAPING_GLYPH_PROPERTIES*, UINT32, IDWriteFontFace*, FLOAT,
                         FLOAT, const DWRITE_MATRIX*, BOOL, BOOL, BOOL, const DWRITE_SCRIPT_ANALYSIS*, const WCHAR*,
                         const DWRITE_TYPOGRAPHIC_FEATURES**, const UINT32*, UINT32, FLOAT*, DWRITE_GLYPH_OFFSET*);
};

/// The second of the two words of "Thai language", in Thai.
const std::wstring thai = L"\u0E44\u0E17\u0E22";

text_analysis analysed(directwrite_analyser& analyser, text_view text)
{
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse(text, {}, found));
    return found;
}

/// The units before which a line may end.
std::vector<std::size_t> breaks(const text_analysis& found)
{
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < found.marks.size(); ++i)
        if (has(found.marks[i], text_mark::may_break)) all.push_back(i);
    return all;
}

/// What the library finds by itself, but for breaks within what it leaves unbroken.
void check_the_rest(text_view text, const text_analysis& found)
{
    unicode_analyser plain;
    text_analysis own;
    REQUIRE_FALSE(plain.analyse(text, {}, own));
    REQUIRE(found.marks.size() == own.marks.size());
    std::vector<bool> inside(own.marks.size());
    for (const text_range& r : own.unbroken)
        for (std::size_t i = r.first + 1; i < r.last; ++i) inside[i] = true;
    for (std::size_t i = 0; i < own.marks.size(); ++i) {
        CHECK(found.levels[i] == own.levels[i]);
        const text_mark allowed = inside[i] ? text_mark::may_break : text_mark::none;
        CHECK((found.marks[i] | allowed) == (own.marks[i] | allowed));
    }
    REQUIRE(found.scripts.size() == own.scripts.size());
    for (std::size_t i = 0; i < own.scripts.size(); ++i) {
        CHECK(found.scripts[i].first == own.scripts[i].first);
        CHECK(found.scripts[i].last == own.scripts[i].last);
        CHECK(found.scripts[i].script == own.scripts[i].script);
    }
    REQUIRE(found.paragraphs.size() == own.paragraphs.size());
    for (std::size_t i = 0; i < own.paragraphs.size(); ++i) CHECK(found.paragraphs[i].last == own.paragraphs[i].last);
    CHECK(found.invalid_units == own.invalid_units);
}

}  // namespace directwrite_analyser_test

using namespace directwrite_analyser_test;

TEST_CASE("an analysis with DirectWrite equals the library's own where there are no dictionaries, as in Wine",
          "[windows]")
{
    directwrite_analyser analyser;
    const std::u16string text =
        u"Hello (\u05E9\u05DC\u05D5\u05DD 12) fox-trot\n"
        u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22 \u6F22\u5B57, ok \U0001F44D\U0001F3FD"
        u"\xD800 \u1798\u17B6\u1793\u1791\u17B9\u1780 \u0E9E\u0EB2\u0EAA\u0EB2"
        u"\u1000\u1019\u1039\u1018\u102C";
    const text_analysis found = analysed(analyser, text);
    check_the_rest(text, found);
    unicode_analyser plain;
    text_analysis own;
    REQUIRE_FALSE(plain.analyse(text, {}, own));
    REQUIRE(own.unbroken.size() == 4);
    // Where this is DirectWrite itself, words may have been found.
    if (found.unbroken.size() == 4) {
        CHECK(breaks(found) == breaks(own));
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(found.unbroken[i].first == own.unbroken[i].first);
            CHECK(found.unbroken[i].last == own.unbroken[i].last);
        }
    }
}

TEST_CASE("lines can end between words from DirectWrite's dictionaries, in both encodings", "[windows]")
{
    fake_words words{thai};
    words.overruns = true;
    {
        directwrite_analyser analyser{&words};
        CHECK(words.references == 2);
        const std::u16string text = u"ab \u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22 cd";
        const text_analysis found = analysed(analyser, text);
        CHECK(found.unbroken.empty());
        CHECK(breaks(found) == std::vector<std::size_t>{3, 7, 11});
        check_the_rest(text, found);
        CHECK(words.languages == std::vector<std::wstring>{L"th", L"lo", L"km", L"my", L"th"});

        const text_analysis utf8 = analysed(
            analyser, u8"ab \u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22 \u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22");
        CHECK(utf8.unbroken.empty());
        CHECK(breaks(utf8) == std::vector<std::size_t>{3, 15, 25, 37});
    }
    CHECK(words.references == 1);
}

TEST_CASE("a text that needs no dictionary does not call DirectWrite", "[windows]")
{
    fake_words words;
    directwrite_analyser analyser{&words};
    analysed(analyser, u"plain \u05E9\u05DC\u05D5\u05DD \u6F22\u5B57");
    CHECK(words.calls == 0);
    analysed(analyser, u"\u0E20\u0E32");
    CHECK(words.calls == 4);  // of each script, whether its words are known
}

TEST_CASE("a script without a dictionary in DirectWrite stays unbroken, and does not affect other scripts", "[windows]")
{
    fake_words words{thai};
    directwrite_analyser analyser{&words};
    // Lao, Thai, Tai Tham.
    const std::u16string text = u"\u0E9E\u0EB2\u0EAA\u0EB2\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22\u1A20\u1A21";
    const text_analysis found = analysed(analyser, text);
    REQUIRE(found.unbroken.size() == 2);
    CHECK(found.unbroken[0].first == 0);
    CHECK(found.unbroken[0].last == 4);
    CHECK(found.unbroken[1].first == 11);
    CHECK(found.unbroken[1].last == 13);
    CHECK(breaks(found) == std::vector<std::size_t>{8});
}

TEST_CASE("an analyser that breaks before every letter counts as one without a dictionary", "[windows]")
{
    fake_words words;
    words.everywhere = true;
    directwrite_analyser analyser{&words};
    const text_analysis found = analysed(
        analyser, u"\u0E20\u0E32\u0E29\u0E32 \u0E9E\u0EB2\u0EAA \u1798\u17B6\u1793 \u1000\u1019\u1039\u1018\u102C");
    CHECK(found.unbroken.size() == 4);
    CHECK(breaks(found).size() == 3);  // behind the spaces
}

TEST_CASE("no line ends within a grapheme, even if DirectWrite reports a break there", "[windows]")
{
    fake_words words{thai};
    directwrite_analyser analyser{&words};
    const std::u16string text = u"\u0E20\u0E32\u0E44\u0E17\u0E22\u0E17\u0E35\u0E48\u0E19\u0E35\u0E49";
    analysed(analyser, text);
    words.everywhere = true;
    const text_analysis found = analysed(analyser, text);
    check_the_rest(text, found);
    std::vector<std::size_t> graphemes;
    for (std::size_t i = 1; i < text.size(); ++i)
        if (has(found.marks[i], text_mark::grapheme)) graphemes.push_back(i);
    CHECK(breaks(found) == graphemes);
    CHECK(graphemes.size() < text.size() - 1);
}

TEST_CASE("a line can break where one side allows it and the other does not forbid it", "[windows]")
{
    const auto broken = [](UINT8 after, UINT8 before) {
        fake_words words{thai};
        directwrite_analyser analyser{&words};
        analysed(analyser, u"\u0E20\u0E32");
        words.after = after;
        words.before = before;
        return !breaks(analysed(analyser, u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22")).empty();
    };
    CHECK(broken(can, neutral));
    CHECK(broken(neutral, can));
    CHECK(broken(must, must));
    CHECK_FALSE(broken(neutral, neutral));
    CHECK_FALSE(broken(can, may_not));
    CHECK_FALSE(broken(may_not, can));
}

TEST_CASE("a failure of DirectWrite is an error, and the next text is analysed again", "[windows]")
{
    const std::u16string text =
        u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22 \u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22";
    for (unsigned k = 1; k <= 6; ++k) {
        INFO("call " << k);
        fake_words words{thai};
        words.fails_at = k;
        {
            directwrite_analyser analyser{&words};
            text_analysis found;
            const error e = analyser.analyse(text, {}, found);
            CHECK(e == error::font_library_failed);
            CHECK(e.count == static_cast<std::uint32_t>(E_FAIL));
            CHECK(found.marks.empty());
            CHECK(found.unbroken.empty());
            CHECK(found.paragraphs.empty());
            REQUIRE_FALSE(analyser.analyse(text, {}, found));
            CHECK(breaks(found) == std::vector<std::size_t>{4, 8, 12});
        }
        CHECK(words.references == 1);
    }
    fake_words words;
    words.fails_at = 1;
    words.failure = E_OUTOFMEMORY;
    directwrite_analyser analyser{&words};
    text_analysis found;
    CHECK(analyser.analyse(text, {}, found) == error::out_of_memory);
}

TEST_CASE("a lack of memory at any request is an error, and no memory is lost", "[windows]")
{
    const std::u16string text = u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22";
    fake_words words{thai};
    std::size_t failed = 0;
    for (std::size_t k = 1;; ++k) {
        test::counting_memory counted;
        counted.fail_at = k;
        counted.fail_once = true;
        error e;
        {
            directwrite_analyser analyser{&words, counted.source()};
            text_analysis found;
            e = analyser.analyse(text, {}, found);
            CHECK(found.marks.empty() == static_cast<bool>(e));
            REQUIRE_FALSE(analyser.analyse(text, {}, found));
            CHECK(breaks(found) == std::vector<std::size_t>{4});
            const std::size_t warm = counted.requests;
            REQUIRE_FALSE(analyser.analyse(text, {}, found));
            CHECK(counted.requests == warm);
        }
        CHECK(counted.bytes_held == 0);
        if (!e) break;
        CHECK(e == error::out_of_memory);
        ++failed;
    }
    CHECK(failed >= 3);
    CHECK(words.references == 1);
}

TEST_CASE("an analyser with DirectWrite still works after it was moved", "[windows]")
{
    fake_words words{thai};
    {
        directwrite_analyser first{&words};
        const std::u16string text = u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22";
        analysed(first, text);
        directwrite_analyser second{std::move(first)};
        CHECK(breaks(analysed(second, text)) == std::vector<std::size_t>{4});
        CHECK(words.references == 2);
    }
    CHECK(words.references == 1);
}
