// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/layout/impl/itemise.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

std::vector<text_item> items_of(text_view text, const std::vector<std::uint32_t>& cuts = {},
                                const std::vector<column_run>& columns = {})
{
    buffer<text_item> items;
    REQUIRE_FALSE(itemise(text, test::analysed(text), cuts, columns, items));
    return {items.begin(), items.end()};
}

}  // namespace

TEST_CASE("items cover the text in order, each of one level and one script", "[paragraph]")
{
    const std::u16string text = u"Ab \u05D0\u05D1 12 \u03B1\u03B2\t\u0628\r\n\r\u2028x\n";
    const text_analysis found = test::analysed(text);
    std::uint32_t at = 0;
    for (const text_item& item : items_of(text)) {
        CHECK(item.first == at);
        REQUIRE(item.last > item.first);
        at = item.last;
        for (std::uint32_t i = item.first; i < item.last; ++i) CHECK(found.levels[i] == item.level);
        const std::size_t silent = silent_at(text, item.first);
        if (silent != 0) CHECK(item.last - item.first == silent);
        for (std::uint32_t i = item.first + 1; silent == 0 && i < item.last; ++i) CHECK(silent_at(text, i) == 0);
    }
    CHECK(at == text.size());
}

TEST_CASE("text is cut where its direction or its script changes, and round tabs and breaks", "[paragraph]")
{
    CHECK(items_of("").empty());
    CHECK(items_of("plain text, one item (of 2 words)!").size() == 1);
    CHECK(items_of("a\tb").size() == 3);
    CHECK(items_of("a\r\nb").size() == 3);
    CHECK(items_of(u"a\u05D0b").size() == 3);
    const auto greek = items_of(u"ab \u03B1\u03B2");
    REQUIRE(greek.size() == 2);
    CHECK(greek[0].script == script_tag("Latn"));
    CHECK(greek[1].script == script_tag("Grek"));
    const auto number = items_of(u"\u0628 12");
    REQUIRE(number.size() == 2);
    CHECK(number[0].level == 1);
    CHECK(number[1].level == 2);
}

TEST_CASE("what ends a paragraph is an item of its own, and so is a tab", "[paragraph]")
{
    for (const char16_t* mark :
         {u"\t", u"\n", u"\v", u"\f", u"\r\n", u"\u0085", u"\u2028", u"\u2029", u"\u001C", u"\u001D", u"\u001E"}) {
        const std::u16string text = std::u16string{u"a"}.append(mark).append(u"b");
        CHECK(items_of(text).size() == 3);
        CHECK(silent_at(text, 1) == text.size() - 2);
    }
    CHECK(silent_at(u"\u001F", 0) == 0);
}

TEST_CASE("items end only where graphemes do", "[paragraph]")
{
    const auto latin = items_of(u"ba\u093Fc");  // a Devanagari sign upon a Latin letter: of the letter's script
    REQUIRE(latin.size() == 1);
    CHECK(latin[0].script == script_tag("Latn"));
    const auto hebrew = items_of(u"\u05D0\u093Fa");  // one that is read to the right upon a letter that is not
    REQUIRE(hebrew.size() == 2);
    CHECK(hebrew[0].last == 2);
    CHECK(hebrew[0].level == 1);
    CHECK(hebrew[1].level % 2 == 0);
}

TEST_CASE("text is cut where the caller wants it, after the grapheme if need be", "[paragraph]")
{
    const auto items = items_of(u"ab\u0301c d", {0, 1, 2, 4, 4, 9});
    REQUIRE(items.size() == 4);
    for (const auto& [k, last] : {std::pair<std::size_t, std::uint32_t>{0, 1}, {1, 3}, {2, 4}, {3, 6}})
        CHECK(items[k].last == last);
}

TEST_CASE("in a column that is read down nothing is read upwards, and letters of both directions are one item",
          "[paragraph]")
{
    const auto items = items_of(u"a\u05D0\u05D1 12 \u05D2b", {}, {{0, 9, glyph_orientation::upright, true}});
    REQUIRE(items.size() == 3);  // the scripts
    for (const text_item& item : items) {
        CHECK_FALSE(item.to_the_left());
        CHECK(item.orientation == glyph_orientation::upright);
    }
    CHECK(items[1].last == 8);
}

TEST_CASE("items end where a column turns, and keep their levels", "[paragraph]")
{
    constexpr auto up = glyph_orientation::upright, side = glyph_orientation::sideways;
    const auto items = items_of(u"\u4E16a\u05D0b\u4E16", {}, {{0, 1, up}, {1, 4, side}, {4, 5, up}});
    REQUIRE(items.size() == 5);
    const glyph_orientation wanted[] = {up, side, side, side, up};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(items[k].orientation == wanted[k]);
        CHECK(items[k].to_the_left() == (k == 2));
    }
}

TEST_CASE("what is combined is one item, except for tabs and breaks", "[paragraph]")
{
    constexpr auto one = glyph_orientation::combined;
    const auto items = items_of(u"a\u05D0\u0628b1c\t2", {2}, {{0, 4, one, true}, {4, 8, one, true}});
    REQUIRE(items.size() == 4);
    const std::uint32_t ends[] = {4, 6, 7, 8};
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(items[k].last == ends[k]);
        CHECK(items[k].orientation == one);
    }
}

TEST_CASE("itemise reports a memory that gives nothing", "[paragraph]")
{
    test::counting_memory failing{.fail_at = 1};
    buffer<text_item> items{failing.source()};
    CHECK(itemise("ab", test::analysed("ab"), {}, {}, items) == error::out_of_memory);
}
