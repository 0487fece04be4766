// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"

#include <typemesh/layout/impl/white_space.hpp>

using namespace typemesh;

TEST_CASE("white space is blank unless it carries a mark that is drawn", "[paragraph]")
{
    const std::pair<std::u16string, bool> cases[] = {
        {u" ", true},       {u"\u3000", true},   {u" \u200D", true},        {u" \u200F", true},
        {u" \uFE0F", true}, {u" \u0301", false}, {u" \u200D\u0301", false}, {u"a", false}};
    for (const auto& [text, blank] : cases)
        CHECK(is_blank(text, test::analysed(text).marks.view(), 0, text.size()) == blank);
}

TEST_CASE("a grapheme ends where the next one begins, or the text does", "[paragraph]")
{
    const text_analysis found = test::analysed(u"a\u0301\u0301b");
    CHECK(grapheme_end(found.marks.view(), 0) == 3);
    CHECK(grapheme_end(found.marks.view(), 1) == 3);
    CHECK(grapheme_end(found.marks.view(), 3) == 4);
}
