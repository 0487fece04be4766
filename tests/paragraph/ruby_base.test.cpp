// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/impl/ruby_base.hpp>

#include <string_view>

using namespace typemesh;

TEST_CASE("kana are found in both encodings, before and behind a place", "[paragraph][ruby]")
{
    const text_view wide{u"\u3042a\u30FC\U00020000"}, narrow{
                                                          "\xE3\x81\x82"
                                                          "a\xE3\x83\xBC"};
    CHECK(detail::kana_at(wide, 0));
    CHECK(detail::kana_before(wide, 1));
    CHECK_FALSE(detail::kana_before(wide, 0));
    CHECK_FALSE(detail::kana_at(wide, 1));
    CHECK_FALSE(detail::kana_before(wide, 2));
    CHECK(detail::kana_before(wide, 3));
    CHECK_FALSE(detail::kana_before(wide, 5));
    CHECK_FALSE(detail::kana_at(wide, 5));
    CHECK(detail::kana_at(narrow, 0));
    CHECK(detail::kana_before(narrow, 3));
    CHECK_FALSE(detail::kana_before(narrow, 4));
    CHECK(detail::kana_before(narrow, 7));
}

TEST_CASE("the text of a ruby has no white space at its ends and no spacing behind it", "[paragraph][ruby]")
{
    const test::laid_paragraph<> p{u"a bc d", {}, {.letter_spacing = 0.1}};
    const detail::ruby_base base = detail::find_ruby_base(p.laid(), {1, 5});
    CHECK(base.parts == 1);
    CHECK(base.from == Approx(600.0 + 350.0));
    CHECK(base.to == Approx(600.0 + 350.0 + 600.0 + 500.0));
    CHECK(detail::find_ruby_base(p.laid(), {1, 2}).parts == 0);
    CHECK(detail::find_ruby_base(p.laid(), {2, 2}).parts == 0);
}

TEST_CASE("a text of two directions has one box if it is shown in one piece, and otherwise several",
          "[paragraph][ruby]")
{
    const test::laid_paragraph<> p{u"ab\u05D0\u05D1\u05D2 cd"};  // a b gimel bet alef c d
    const auto parts = [&](std::uint32_t first, std::uint32_t last) {
        return detail::find_ruby_base(p.laid(), {first, last}).parts;
    };
    CHECK(parts(0, 5) == 1);
    CHECK(parts(2, 4) == 1);
    CHECK(parts(1, 3) == 2);  // b, and alef behind the others
    CHECK(parts(1, 5) == 1);
    CHECK(parts(4, 8) == 2);
    const detail::ruby_base base = detail::find_ruby_base(p.laid(), {2, 4});
    CHECK(base.from == Approx(1500.0));
    CHECK(base.to == Approx(2500.0));
}

TEST_CASE("an excess is shared as far as there is room", "[paragraph][ruby]")
{
    detail::ruby_base base;
    CHECK(base.reach_before(4.0, 3.0, 3.0) == 2.0);
    CHECK(base.reach_before(4.0, 1.0, 3.0) == 1.0);
    CHECK(base.reach_before(4.0, 4.0, 1.0) == 3.0);
    CHECK(base.reach_before(4.0, 1.0, 1.0) == 2.0);  // there is no room anyway
    base.begins_line = base.kana_behind = true;
    CHECK(base.reach_before(4.0, 0.0, 2.0) == 0.0);
    base = {};
    base.ends_line = base.kana_before = true;
    CHECK(base.reach_before(4.0, 2.0, 0.0) == 4.0);
}
