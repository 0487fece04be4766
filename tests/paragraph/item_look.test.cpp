// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/paragraph/item_look.hpp>

using namespace typemesh;

TEST_CASE("a glyph looks as its face has it, as large and slanted as its style wants", "[paragraph][styles]")
{
    CHECK(look_of({}, {}, {}) == look{});
    CHECK(look_of({}, {}, {.face = 3}) == look{.face = 3});
    CHECK(look_of({}, {.style = style_id{4}}, {}) == look{.style = style_id{4}});
    CHECK(look_of({.scale = 2.0}, {.slant = 0.25}, {}) == look{.map = {.xx = 2.0, .xy = 0.5, .yy = 2.0}});
    CHECK(look_of({.lift = 5.0}, {.rise = 1.0}, {}) == look{});
}
