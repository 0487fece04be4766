// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/text_style.hpp>

using namespace typemesh;

TEST_CASE("a set of decorations knows what is in it", "[paragraph][styles]")
{
    constexpr decoration both = decoration::underline | decoration::overline;
    static_assert(has(both, decoration::underline) && has(both, decoration::overline));
    CHECK_FALSE(has(both, decoration::strike_through));
    CHECK_FALSE(has(decoration::none, both));
}

TEST_CASE("styles are shaped alike where only their painting differs", "[paragraph][styles]")
{
    const feature ones[] = {{"smcp", 1}}, others[] = {{"smcp", 1}}, zeros[] = {{"smcp", 0}};
    const text_style plain;
    CHECK(shaped_alike(
        plain,
        {.word_spacing = 1.0, .rise = 0.5, .slant = 0.2, .decorations = decoration::underline, .style = style_id{7}}));
    const text_style others_shaped[] = {
        {.face = 1},        {.size = 2.0},      {.letter_spacing = 0.1},
        {.features = ones}, {.language = "tr"}, {.position = script_position::subscript}};
    for (const text_style& style : others_shaped) CHECK_FALSE(shaped_alike(plain, style));
    CHECK(shaped_alike({.features = ones}, {.features = others}));
    CHECK_FALSE(shaped_alike({.features = ones}, {.features = zeros}));
}
