// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/glyph_shape.hpp>

using namespace typemesh;

TEST_CASE("shapes are equal where glyph, face and map are", "[layout]")
{
    const glyph_shape all{.id = 7, .face = 1, .map = {.xy = 0.2}};
    CHECK(all == glyph_shape{all});
    CHECK(hash_of(all) == hash_of(glyph_shape{all}));
    const glyph_shape others[] = {
        {.id = 8, .face = 1, .map = {.xy = 0.2}}, {.id = 7, .face = 0, .map = {.xy = 0.2}}, {.id = 7, .face = 1}, {}};
    for (const glyph_shape& other : others) {
        CHECK_FALSE(other == all);
        CHECK(hash_of(other) != hash_of(all));
    }
    CHECK(hash_of(glyph_shape{.id = 7, .map = {.dx = -0.0}}) == hash_of(glyph_shape{.id = 7}));
}
