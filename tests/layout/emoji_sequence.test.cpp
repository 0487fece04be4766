// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/emoji_sequence.hpp>

#include <string>
#include <string_view>

using namespace typemesh;

namespace {

/// Whether an emoji has fallen apart of which these characters are drawn as they are alone.
bool apart(std::u16string_view text, std::u32string_view drawn)
{
    const auto is_drawn = [&](char32_t c) noexcept { return drawn.find(c) != std::u32string_view::npos; };
    return has_fallen_apart(text, 0, text.size(), is_drawn);
}

}  // namespace

TEST_CASE("an emoji has fallen apart if one of its further parts is drawn as it is alone", "[emoji_sequence]")
{
    CHECK(apart(u"\U0001F1E9\U0001F1EA", U"\U0001F1E9\U0001F1EA"));  // a flag
    CHECK(apart(u"\U0001F44D\U0001F3FD", U"\U0001F44D\U0001F3FD"));  // a skin tone
    CHECK(apart(u"\U0001F468\u200D\U0001F469\u200D\U0001F467", U"\U0001F468\U0001F469\U0001F467"));
    CHECK(apart(u"\U0001F468\u200D\U0001F469\u200D\U0001F467", U"\U0001F467"));  // two of the three are one
    CHECK(apart(u"\U0001F3F3\uFE0F\u200D\U0001F308", U"\U0001F3F3\U0001F308"));
    CHECK(apart(u"\U0001F469\U0001F3FD\u200D\u2695\uFE0F", U"\u2695"));
    CHECK(apart(u"\U0001F3F4\U000E0067\U000E0062\U000E007F", U"\U0001F3F4"));  // the black flag of a flag with tags
}

TEST_CASE("an emoji that is drawn whole has not fallen apart, and neither has other text", "[emoji_sequence]")
{
    CHECK_FALSE(apart(u"\U0001F1E9\U0001F1EA", U""));
    CHECK_FALSE(apart(u"\U0001F468\u200D\U0001F469\u200D\U0001F467", U""));
    CHECK_FALSE(apart(u"\U0001F468\u200D\U0001F469", U"\U0001F468"));  // a base that two glyphs are laid upon
    CHECK_FALSE(apart(u"\U0001F3F4\U000E0067\U000E0062\U000E007F", U""));
    for (const char16_t* alone :
         {u"\U0001F1E9", u"\U0001F44D", u"\u2764\uFE0F", u"\U0001F3FD", u"1\uFE0F\u20E3", u"a\u0301",
          u"\U0001F468\u200D", u"\u200D\U0001F468", u"\u0E01\u0E34", u"", u"\xD83D"})
        CHECK_FALSE(apart(alone, U"\U0001F1E9\U0001F44D\u2764\U0001F3FD1\u20E3a\u0301\U0001F468\u200D\u0E01\u0E34"));
}
