// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/layout/impl/text_columns.hpp>

#include <string>

using namespace typemesh;

TEST_CASE("what is combined is one grapheme between tabs and breaks, and no line ends in it", "[paragraph][columns]")
{
    test::toy_shaper font;
    const std::u16string text = u"ab a\u0301 c\td\r\ne fg";
    text_analysis found = test::analysed(text);
    const text_analysis plain = test::analysed(text);
    const style_span span[] = {{1, 13, {.column = column_style::combined}}};
    style_spans styles;
    REQUIRE_FALSE(styles.read(span, found, 1));
    text_columns columns;
    REQUIRE_FALSE(columns.find(font, text, {.direction = direction::top_to_bottom}, styles, found));
    REQUIRE(columns.runs().size() == 3);
    CHECK(columns.metrics().middle == 250.0);
    CHECK(columns.metrics().em == 1000.0);
    for (std::size_t u = 0; u < text.size(); ++u) {
        const bool inside = u > 1 && u < 13 && u != 7 && u != 8 && u != 9 && u != 11;
        CHECK(has(found.marks[u], text_mark::grapheme) == (has(plain.marks[u], text_mark::grapheme) && !inside));
        CHECK(has(found.marks[u], text_mark::may_break) == (has(plain.marks[u], text_mark::may_break) && !inside));
        CHECK(has(found.marks[u], text_mark::must_break) == has(plain.marks[u], text_mark::must_break));
    }
}

TEST_CASE("whatever ends a line stands alone within what is combined", "[paragraph][columns]")
{
    test::toy_shaper font;
    const style_span span[] = {{0, 3, {.column = column_style::combined}}};
    for (const char16_t mark : {u'\t', u'\n', u'\u0085', u'\u2029', u'\x1C', u'\x1D', u'\x1E'}) {
        const std::u16string text{u'1', mark, u'2'};
        text_analysis found = test::analysed(text);
        style_spans styles;
        REQUIRE_FALSE(styles.read(span, found, 1));
        text_columns columns;
        REQUIRE_FALSE(columns.find(font, text, {.direction = direction::top_to_bottom}, styles, found));
        CHECK(has(found.marks[1], text_mark::grapheme));
        CHECK(has(found.marks[2], text_mark::grapheme));
    }
}

TEST_CASE("lines have no columns", "[paragraph][columns]")
{
    test::toy_shaper font;
    text_analysis found = test::analysed("ab");
    text_columns columns;
    REQUIRE_FALSE(columns.find(font, "ab", {.direction = direction::top_to_bottom}, style_spans{}, found));
    CHECK(columns.runs().size() == 1);
    REQUIRE_FALSE(columns.find(font, "ab", {}, style_spans{}, found));
    CHECK(columns.runs().empty());

    test::counting_memory failing{.fail_at = 1};
    text_columns poor{failing.source()};
    CHECK(poor.find(font, "ab", {.direction = direction::top_to_bottom}, style_spans{}, found) == error::out_of_memory);
}
