// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/layout/impl/shaper_ref.hpp>
#include <typemesh/layout/layout.hpp>

using namespace typemesh;

TEST_CASE("a text is laid out by a shaper's reference as by the shaper", "[layout]")
{
    test::toy_font font;
    shaper_ref refers{&font, shaper_ref::table<test::toy_font>::of};
    for (const direction way : {direction::left_to_right, direction::top_to_bottom}) {
        glyph_run own, by_ref;
        const shape_options how{.direction = way};
        REQUIRE(layout(font, "oE\nx", how, {}, own));
        REQUIRE(layout(refers, "oE\nx", how, {}, by_ref));
        REQUIRE(own.glyphs.size() == by_ref.glyphs.size());
        for (std::size_t i = 0; i < own.glyphs.size(); ++i) {
            CHECK(own.glyphs[i].id == by_ref.glyphs[i].id);
            CHECK(own.glyphs[i].origin == by_ref.glyphs[i].origin);
        }
        CHECK(own.lines[1].origin == by_ref.lines[1].origin);
    }
}
