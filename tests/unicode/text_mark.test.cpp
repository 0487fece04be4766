// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/text_mark.hpp>

using namespace typemesh;

TEST_CASE("a set of text marks has each of its marks and no other", "[marks]")
{
    constexpr text_mark all[] = {text_mark::character, text_mark::grapheme, text_mark::may_break, text_mark::must_break,
                                 text_mark::space,     text_mark::trailing, text_mark::separator};
    for (const text_mark a : all)
        for (const text_mark b : all) {
            CHECK(has(a, b) == (a == b));
            CHECK(has(a | b, a));
            CHECK(has(a | b, b));
            CHECK_FALSE(has(text_mark::none, a));
        }
}
