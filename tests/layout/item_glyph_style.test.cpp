// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/column_glyphs.hpp>
#include <typemesh/layout/impl/item_glyph_style.hpp>

using namespace typemesh;

TEST_CASE("a glyph looks as its face has it, as large and slanted as its style wants", "[paragraph][styles]")
{
    CHECK(glyph_style_of({}, {}, {}, {}) == glyph_style{});
    CHECK(glyph_style_of({}, {}, {}, {.face = 3}) == glyph_style{.face = 3});
    CHECK(glyph_style_of({}, {}, {.style = style_id{4}}, {}) == glyph_style{.style = style_id{4}});
    CHECK(glyph_style_of({}, {.scale = 2.0}, {.slant = 0.25}, {}) ==
          glyph_style{.map = {.xx = 2.0, .xy = 0.5, .yy = 2.0}});
    CHECK(glyph_style_of({}, {.lift = 5.0}, {.rise = 1.0}, {}) == glyph_style{});
}

TEST_CASE("a glyph in a column looks as it stands, whatever its item does", "[paragraph][columns]")
{
    const text_item item{.orientation = glyph_orientation::combined, .squeeze = 0.5};
    CHECK(glyph_style_of(item, {}, {}, {.face = 2}) ==
          glyph_style{.face = 2});  // an ellipsis behind a number has room of its own
    CHECK(glyph_style_of(item, {}, {}, {.face = 2, .flags = glyph_flags::sideways}) ==
          glyph_style{.face = 2, .map = quarter_turn});
    CHECK(glyph_style_of(item, {}, {}, {.face = 2, .flags = glyph_flags::combined}) ==
          glyph_style{.face = 2, .map = {.xx = 0.5}});
    const glyph_style leaning = glyph_style_of(item, {.scale = 2.0}, {.slant = 0.25}, {.flags = glyph_flags::sideways});
    const affine upright{.xx = 2.0, .xy = 0.5, .yy = 2.0};
    for (const point p : {point{1.0, 0.0}, point{0.0, 1.0}, point{3.0, 7.0}})
        CHECK(leaning.map(p) == quarter_turn(upright(p)));
}
