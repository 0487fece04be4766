// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/text/lone_worker.hpp>

#include <vector>

using namespace typemesh;

TEST_CASE("a lone worker goes through all tasks in order, with what it was given, and stops at an error",
          "[text][workers]")
{
    test::toy_font font;
    glyph_builder builder;
    glyph_store store{heap()};
    no_observer nobody;
    lone_worker<test::toy_font, no_observer> worker{font, builder, store, nobody};
    CHECK(worker.units_per_em() == 1000.0);
    CHECK(worker.begin_plan() == nullptr);

    std::vector<std::size_t> seen;
    const auto task = [&](std::size_t k, test::toy_font& f, glyph_builder& b, glyph_store& s, no_observer& o) noexcept {
        CHECK((&f == &font && &b == &builder && &s == &store && &o == &nobody));
        seen.push_back(k);
        return k == 3 ? error{error::bad_option} : error{};
    };
    CHECK(!worker.each(3, task));
    CHECK(seen == std::vector<std::size_t>{0, 1, 2});
    CHECK(worker.each(9, task) == error::bad_option);
    CHECK(seen == std::vector<std::size_t>{0, 1, 2, 0, 1, 2, 3});
}

TEST_CASE("a lone worker lays a text out as layout() does", "[text][workers]")
{
    test::toy_font font;
    glyph_builder builder;
    glyph_store store{heap()};
    no_observer nobody;
    lone_worker<test::toy_font, no_observer> worker{font, builder, store, nobody};
    glyph_run made, wanted;
    CHECK(!worker.layout(font, "oE\nx", {}, {}, made));
    CHECK(!layout(font, "oE\nx", {}, {}, wanted));
    REQUIRE(made.glyphs.size() == wanted.glyphs.size());
    CHECK(made.lines.size() == 2);
    for (std::size_t i = 0; i < made.glyphs.size(); ++i) {
        CHECK(made.glyphs[i].id == wanted.glyphs[i].id);
        CHECK(made.glyphs[i].origin == wanted.glyphs[i].origin);
    }
}
