// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/glyph_style.hpp>

using namespace typemesh;

TEST_CASE("glyph styles are equal where face, map and style are", "[layout]")
{
    const glyph_style all{.face = 1, .map = {.xy = 0.2}, .style = style_id{3}};
    CHECK(glyph_style{} == glyph_style{.face = 0, .map = {.xx = 1.0, .yy = 1.0}, .style = style_id{0}});
    CHECK(all == glyph_style{all});
    glyph_style other = all;
    other.face = 0;
    CHECK_FALSE(other == all);
    other = all;
    other.map.dy = 1.0;
    CHECK_FALSE(other == all);
    other = all;
    other.style = no_style;
    CHECK_FALSE(other == all);
}
