// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/paragraph/item_look.hpp>

using namespace typemesh;

TEST_CASE("a glyph looks as its face has it", "[paragraph]")
{
    CHECK(look_of({}, {}) == look{});
    CHECK(look_of({}, {.face = 3}) == look{.face = 3});
}
