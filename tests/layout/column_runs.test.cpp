// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"
#include "unicode/character_database.hpp"

#include <typemesh/layout/impl/column_runs.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

namespace columns_of_text {

bool no_form(char32_t) noexcept { return false; }
bool any_form(char32_t) noexcept { return true; }
bool bracket_form(char32_t c) noexcept { return c == U'\u300C'; }

struct found {
    buffer<column_run> runs;

    explicit found(text_view text, const column_options& how = {}, const std::vector<column_span>& styles = {},
                   bool (*form)(char32_t) noexcept = no_form)
    {
        const text_analysis read = test::analysed(text);
        REQUIRE_FALSE(find_column_runs(text, read.marks.view(), how, styles, form, runs));
        std::uint32_t at = 0;  // they cover the text, and end where graphemes do
        for (const column_run& r : runs) {
            CHECK(r.first == at);
            REQUIRE(r.last > r.first);
            CHECK(has(read.marks[r.first], text_mark::grapheme));
            at = r.last;
        }
        CHECK(at == text.size());
    }

    /// A letter for each unit: u(pright), s(ideways), c(ombined), each run of the last kind with a letter of its own.
    [[nodiscard]] std::string letters() const
    {
        std::string all;
        char next = 'A';
        for (const column_run& r : runs) {
            const char letter = r.orientation == glyph_orientation::upright    ? 'u'
                                : r.orientation == glyph_orientation::sideways ? 's'
                                                                               : next++;
            all.append(r.last - r.first, letter);
        }
        return all;
    }
};

}  // namespace columns_of_text
using columns = columns_of_text::found;

}  // namespace

TEST_CASE("characters stand in columns as UAX #50 has it", "[layout][columns]")
{
    CHECK(columns(u"\u65E5\u672C (ab) \u3042\u3002").letters() == "uussssssuu");
    CHECK(columns(u"a\u00A9b\u20AC").letters() == "suss");
    CHECK(columns(u"\u05D0 \u0628 \u0915").letters() == "sssss");
    CHECK(columns(u"\uFF21\uAC00\u3041").letters() == "uuu");
    CHECK(columns(u"").runs.empty());
}

TEST_CASE("what is to be transformed is upright where the font has a vertical form, else as its class says",
          "[layout][columns]")
{
    const char16_t* const text = u"\u3042\u30FC\u300C\u3001";  // Tr: the prolonged sound mark, a corner bracket
    CHECK(columns(text).letters() == "ussu");
    CHECK(columns(text, {}, {}, columns_of_text::any_form).letters() == "uuuu");
    CHECK(columns(u"ab(", {}, {}, columns_of_text::any_form).letters() == "sss");
}

TEST_CASE("a full-width colon without a vertical form is upright in a font that has vertical brackets",
          "[layout][columns]")
{
    const char16_t* const text = u"\u300C\uFF1A\uFF1B\u30FC\u3008";
    CHECK(columns(text, {}, {}, columns_of_text::bracket_form).letters() == "uuuss");
    CHECK(columns(text).letters() == "sssss");
}

TEST_CASE("a grapheme stands as its base does, unless a mark encloses it", "[layout][columns]")
{
    CHECK(columns(u"a\u0301\u3042\u3099").letters() == "ssuu");
    CHECK(columns(u"a\u20DDb").letters() == "uus");
    CHECK(columns(u"1\uFE0F\u20E3").letters() == "uuu");
    CHECK(columns(u"\u0430\u0488").letters() == "uu");
    CHECK(columns(u"a\u20E1").letters() == "ss");  // an arrow above
}

TEST_CASE("the marks that enclose a base have the general category Me", "[layout][columns]")
{
    if (!ucd::is_of_our_version()) return;
    const auto category = ucd::property("extracted/DerivedGeneralCategory.txt");
    std::size_t enclosing = 0, wrong = 0;
    for (char16_t c = 1; c < 0xD800; ++c) {
        const char16_t text[] = {u'a', c};
        const auto stands = grapheme_orientation(std::u16string_view{text, 2}, 0, 2);
        enclosing += category[c] == "Me" ? 1u : 0u;
        wrong += (category[c] == "Me") != (stands == vertical_orientation::upright) ? 1u : 0u;
    }
    CHECK(enclosing == 13);
    CHECK(wrong == 0);
}

TEST_CASE("by option everything is upright and read down", "[layout][columns]")
{
    const columns all{u"a\u05D0\u30FC (b)", {.latin = column_latin::upright}};
    REQUIRE(all.runs.size() == 1);
    CHECK(all.runs[0].orientation == glyph_orientation::upright);
    CHECK(all.runs[0].level(1) == 2);
    CHECK(all.runs[0].level(0) == 0);
    CHECK(columns(u"\u05D0").runs[0].level(1) == 1);
}

TEST_CASE("numbers of few digits are combined, each by itself", "[layout][columns]")
{
    const column_options two{.combined_digits = 2};
    CHECK(columns(u"\u5E7412\u67083\u65E52024", two).letters() == "uAAuBussss");
    CHECK(columns(u"12", two).letters() == "AA");
    CHECK(columns(u"1 2", two).letters() == "AsB");
    CHECK(columns(u"1\u03012", two).letters() == "ssA");  // no digit, but a letter with an accent
    CHECK(columns(u"12").letters() == "ss");
    CHECK(columns("12", {.latin = column_latin::upright, .combined_digits = 4}).letters() == "AA");
}

TEST_CASE("ranges stand as their style says, whatever is in them", "[layout][columns]")
{
    using enum column_style;
    CHECK(columns("abcdef", {}, {{1, 2, upright}, {3, 5, combined}}).letters() == "susAAs");
    CHECK(columns(u"\u3042\u3044\u3046", {}, {{0, 2, sideways}}).letters() == "ssu");
    CHECK(columns("ab", {}, {{0, 1, combined}, {1, 2, combined}}).letters() == "AB");
    CHECK(columns("a1b", {.combined_digits = 2}, {{1, 2, sideways}}).letters() == "sss");
    CHECK(columns("a1b", {.combined_digits = 2}, {{0, 3, automatic}}).letters() == "sAs");
    CHECK(columns(u"xa\u0301y", {}, {{1, 2, upright}}).letters() == "suus");  // a grapheme is not cut
    CHECK(columns(u"xa\u0301y", {}, {{2, 4, upright}}).letters() == "sssu");
    CHECK(columns("ab", {}, {{1, 9, upright}}).letters() == "su");
    CHECK(columns("ab", {}, {{5, 9, upright}}).letters() == "ss");
    CHECK(columns("ab", {}, {{1, 1, upright}}).letters() == "ss");
}

TEST_CASE("find_column_runs() reports a memory that gives nothing", "[layout][columns]")
{
    const text_analysis read = test::analysed("ab");
    test::counting_memory failing{.fail_at = 1};
    buffer<column_run> runs{failing.source()};
    CHECK(find_column_runs("ab", read.marks.view(), {}, {}, columns_of_text::no_form, runs) == error::out_of_memory);
}
