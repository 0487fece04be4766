// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/shaped_glyph.hpp>

using namespace typemesh;

TEST_CASE("flags of a glyph join and are found again", "[layout]")
{
    constexpr glyph_flags all[] = {glyph_flags::unsafe_to_break, glyph_flags::tatweel, glyph_flags::missing,
                                   glyph_flags::sideways, glyph_flags::combined};
    for (const glyph_flags a : all)
        for (const glyph_flags b : all) {
            CHECK(has(a | b, a));
            CHECK(has(a | b, b));
            CHECK(has(a, b) == (a == b));
            CHECK_FALSE(has(glyph_flags::none, a));
        }
    CHECK(shaped_glyph{}.flags == glyph_flags::none);
}
