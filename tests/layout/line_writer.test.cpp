// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/layout/impl/line_writer.hpp>

#include <utility>

using namespace typemesh;
using test::shaped_paragraph;

TEST_CASE("glyphs of a slice follow each other, in either direction", "[paragraph]")
{
    shaped_paragraph p{u"ab \u05D0\u05D1 "};
    glyph_run run;
    line_writer writer{p.shaped, run};
    // The second item's clusters: to the left as they are, to the right at another level.
    const line_slice left{.first = 3, .last = 5, .level = 1}, right{.first = 3, .last = 5, .level = 0};
    REQUIRE_FALSE(writer.write(left, {10.0, 20.0}, 5.0));
    REQUIRE_FALSE(writer.write(right, {10.0, 20.0}, 5.0));
    REQUIRE(run.glyphs.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(run.glyphs[i].origin == point{i % 2 == 0 ? 15.0 : 515.0, 20.0});
    CHECK(run.glyphs[0].cluster == 4);
    CHECK(run.glyphs[2].cluster == 3);
}

TEST_CASE("glyphs that follow each other are written as cluster by cluster", "[paragraph]")
{
    shaped_paragraph p{u"AV fi \u05D0\u05D1a\u0301 12 \u05D2\tb\x7F "};
    const auto& words = p.pieces.words();
    for (const double stretch : {0.0, 50.0})
        for (const std::uint8_t level : {std::uint8_t{0}, std::uint8_t{1}}) {
            line_slices line;
            REQUIRE_FALSE(append_pieces(line, p.pieces, {words, 0, words.pieces.size()}, p.shaped, p.font));
            REQUIRE(line.finish(p.shaped, level, 0.0, {}));
            line.slices()[0].stretch = stretch;
            line.find_glyphs(p.shaped);
            CHECK(line.slices()[0].together == is_zero(stretch));
            std::size_t together = 0;
            for (line_slice s : line.slices()) {
                glyph_run fast, slow;
                together += s.together ? 1u : 0u;
                REQUIRE_FALSE(line_writer{p.shaped, fast}.write(s, {3.0, 4.0}, 7.0));
                s.together = false;
                REQUIRE_FALSE(line_writer{p.shaped, slow}.write(s, {3.0, 4.0}, 7.0));
                REQUIRE(fast.glyphs.size() == slow.glyphs.size());
                for (std::size_t i = 0; i < fast.glyphs.size(); ++i) {
                    CHECK(fast.glyphs[i].cluster == slow.glyphs[i].cluster);
                    CHECK(fast.glyphs[i].origin == slow.glyphs[i].origin);
                }
            }
            CHECK(together > 3);
        }
}

TEST_CASE("stretched spaces move what follows them", "[paragraph]")
{
    shaped_paragraph p{"a b c"};
    glyph_run run;
    line_writer writer{p.shaped, run};
    REQUIRE_FALSE(writer.write({.first = 0, .last = 5, .stretch = 30.0}, {}, 0.0));
    for (const auto& [i, x] : {std::pair<std::size_t, double>{1, 500.0}, {2, 780.0}, {3, 1280.0}, {4, 1560.0}})
        CHECK(run.glyphs[i].origin.x == x);
}

TEST_CASE("spaces are narrowed as they are stretched", "[paragraph]")
{
    shaped_paragraph p{"a b"};
    glyph_run run;
    line_writer writer{p.shaped, run};
    REQUIRE_FALSE(writer.write({.first = 0, .last = 3, .stretch = -30.0}, {}, 0.0));
    CHECK(run.glyphs[2].origin.x == 720.0);
}

TEST_CASE("letters are spread where they are not joined, each with its distance after it", "[paragraph]")
{
    for (const auto& [text, second] : {std::pair{u"ab", 530.0}, {u"\u0628\u0628", 500.0}, {u"\u05D0\u05D1", 530.0}}) {
        shaped_paragraph p{text};
        const bool back = text[0] != u'a';
        glyph_run run;
        line_writer writer{p.shaped, run};
        REQUIRE_FALSE(writer.write({.first = 0, .last = 2, .level = back, .spread = 30.0}, {}, 0.0));
        CHECK(run.glyphs[0].origin.x == (back ? 30.0 : 0.0));
        CHECK(run.glyphs[1].origin.x - run.glyphs[0].origin.x == second);
    }
}

TEST_CASE("a line writer counts what is missing, columns run down", "[paragraph]")
{
    shaped_paragraph p{u"\u4E16\uFFFFb", direction::top_to_bottom};
    glyph_run run;
    line_writer writer{p.shaped, run};
    REQUIRE_FALSE(writer.write({.first = 0, .last = 3}, {7.0, 0.0}, 100.0));
    CHECK(run.missing == 1);
    CHECK(run.first_missing == 1);
    CHECK(run.glyphs[1].missing);
    CHECK(run.glyphs[1].origin.y == -600.0);
    CHECK(run.glyphs[2].origin == point{7.0 - 250.0, -1100.0});
}
