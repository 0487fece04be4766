// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_item_shaper.hpp"
#include "toy_shaper.hpp"

#include <typemesh/layout/shaper.hpp>

using namespace typemesh;

// Only what gives advances is one.
static_assert(shaper<test::toy_item_shaper>);
static_assert(!shaper<test::toy_shaper>);
static_assert(!shaper<test::toy_item_shaper>);

TEST_CASE("an item shaper appends, its clusters count from the text's start, its level decides", "[layout]")
{
    test::toy_item_shaper font;
    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(font.shape("xAVi", {.first = 1, .last = 3}, {}, glyphs));
    REQUIRE_FALSE(font.shape("xAVi", {.first = 1, .last = 4, .level = 1}, {}, glyphs));
    REQUIRE(glyphs.size() == 5);
    for (const auto& [at, cluster] : {std::pair{0, 1u}, {1, 2u}, {2, 3u}, {3, 2u}, {4, 1u}})
        CHECK(glyphs[static_cast<std::size_t>(at)].cluster == cluster);
}
