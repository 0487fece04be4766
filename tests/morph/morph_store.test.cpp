// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/morph_store.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a section is found if it contains the whole stretch", "[morph]")
{
    morph_store store;
    for (const axis_coordinate c : {7, -100, 0, 50, 100}) REQUIRE(store.keys.push_back(c));
    REQUIRE(store.sections.push_back({0, 2, 0, 0}));
    REQUIRE(store.sections.push_back({2, 3, 0, 0}));
    morph_glyph g;
    g.first_key = 1, g.keys = 4, g.first_section = 0, g.sections = 2;
    CHECK(store.section_over(g, -100, 50) == &store.sections[0]);
    CHECK(store.section_over(g, 50, 100) == &store.sections[1]);
    CHECK(store.section_over(g, 0, 100) == nullptr);
    CHECK(store.section_over(g, -101, 0) == nullptr);
}
