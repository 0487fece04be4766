// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/column_glyphs.hpp>

#include <cmath>
#include <vector>

using namespace typemesh;

TEST_CASE("a quarter turn is exact, and clockwise", "[layout][columns]")
{
    CHECK(quarter_turn({0.1, 0.7}) == point{0.7, -0.1});
    point p{0.1, 0.7};
    for (int i = 0; i < 4; ++i) p = quarter_turn(p);
    CHECK(p == point{0.1, 0.7});
}

TEST_CASE("glyphs on their side are a line's glyphs, turned about its pen and centred on the column",
          "[layout][columns]")
{
    std::vector<shaped_glyph> glyphs(3);
    const point offsets[] = {{0.0, 0.0}, {-20.0, 310.0}, {7.5, -40.0}};
    for (std::size_t i = 0; i < 3; ++i)
        glyphs[i].advance = 100.0 * static_cast<double>(i), glyphs[i].offset = offsets[i];
    const std::vector<shaped_glyph> before = glyphs;
    turn_glyphs(glyphs, {.middle = 250.0});
    double pen = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(same(glyphs[i].advance, before[i].advance));
        CHECK(glyphs[i].flags == glyph_flags::sideways);
        const point in_line = point{pen, -250.0} + before[i].offset,
                    in_column = point{0.0, 0.0 - pen} + glyphs[i].offset;
        CHECK(in_column == quarter_turn(in_line));
        pen += glyphs[i].advance;
    }
}

TEST_CASE("combined glyphs fill an em at most, stand in its middle, and are one cluster", "[layout][columns]")
{
    const double width = GENERATE(200.0, 499.0, 500.0, 501.0, 1200.0);
    std::vector<shaped_glyph> glyphs(2);
    for (std::size_t i = 0; i < 2; ++i) glyphs[i].advance = width, glyphs[i].cluster = static_cast<cluster_id>(7 + i);
    glyphs[1].offset = {10.0, 30.0};
    const double squeeze = combine_glyphs(glyphs, {380.0, 1000.0}, 7);
    CHECK(squeeze <= 1.0);
    CHECK((squeeze < 1.0) == (width > 500.0));
    CHECK(glyphs[0].advance + glyphs[1].advance == 1000.0);
    double pen = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(glyphs[i].cluster == 7);
        CHECK(glyphs[i].flags == glyph_flags::combined);
        const double left = glyphs[i].offset.x - squeeze * (i == 1 ? 10.0 : 0.0), right = left + squeeze * width;
        CHECK(left >= -500.0 - 1e-9);
        CHECK(right <= 500.0 + 1e-9);
        CHECK(pen - glyphs[i].offset.y - 380.0 == (i == 1 ? 470.0 : 500.0));  // the middle line of the em
        pen += glyphs[i].advance;
    }
    CHECK(glyphs[0].offset.x + glyphs[1].offset.x == Approx(squeeze * (10.0 - width)));
    CHECK(same(combine_glyphs({}, {380.0, 1000.0}, 0), 1.0));
}

TEST_CASE("combined glyphs have the wanted gap between them, of half their em at most", "[layout][columns]")
{
    for (const double gap : {-50.0, 0.0, 60.0, 200.0, 400.0})
        for (const double width : {100.0, 500.0, 700.0}) {
            std::vector<shaped_glyph> glyphs(4);
            for (std::size_t i = 0; i < 4; ++i) glyphs[i].advance = i == 1 ? 0.0 : width;  // that one is a mark
            const double squeeze = combine_glyphs(glyphs, {380.0, 1000.0, gap}, 0);
            const double between = std::fmin(std::fmax(gap, 0.0), 250.0);
            CHECK(glyphs[2].offset.x - glyphs[0].offset.x == Approx(squeeze * width + between));
            CHECK(glyphs[3].offset.x - glyphs[2].offset.x == Approx(squeeze * width + between));
            CHECK(glyphs[0].offset.x == Approx(-0.5 * (3 * squeeze * width + 2 * between)));
            CHECK(glyphs[0].offset.x >= -500.0 - 1e-9);
            CHECK((squeeze < 1.0) == (3 * width + 2 * between > 1000.0));
        }
}

TEST_CASE("glyphs are placed and drawn as their item stands", "[layout][columns]")
{
    std::vector<shaped_glyph> glyphs(1);
    glyphs[0].advance = 2000.0;
    glyphs[0].offset = {1.0, 2.0};
    CHECK(place_in_column(glyphs, {.orientation = glyph_orientation::upright}, {0.0, 1000.0}) == affine{});
    CHECK(glyphs[0].offset == point{1.0, 2.0});
    CHECK(place_in_column(glyphs, {.orientation = glyph_orientation::sideways}, {0.0, 1000.0}) == quarter_turn);
    CHECK(glyphs[0].offset == point{2.0, -1.0});
    CHECK(place_in_column(glyphs, {.first = 3, .orientation = glyph_orientation::combined}, {0.0, 1000.0}) ==
          affine{.xx = 0.5});
    CHECK(glyphs[0].cluster == 3);
}

TEST_CASE("items follow each other in a run, in a line or a column", "[layout][columns]")
{
    const bool down = GENERATE(false, true);
    glyph_run run;
    point pen{1.0, 2.0};
    std::vector<shaped_glyph> glyphs(2);
    glyphs[0] = {5, 7, 300.0, {10.0, 20.0}, 3, glyph_flags::missing};
    glyphs[1] = {6, 8, 200.0};
    const text_item item{.orientation = down ? glyph_orientation::upright : glyph_orientation::horizontal};
    REQUIRE_FALSE(place_item(glyphs, item, {0.0, 1000.0}, pen, run));
    CHECK(pen == (down ? point{1.0, -498.0} : point{501.0, 2.0}));
    REQUIRE(run.glyphs.size() == 2);
    CHECK(run.glyphs[0].origin == point{11.0, 22.0});
    CHECK(run.glyphs[0].cluster == 7);
    CHECK(run.glyphs[0].missing);
    CHECK(run.missing == 1);
    CHECK(run.glyph_styles[run.glyphs[0].glyph_style].face == 3);
    CHECK(run.glyphs[1].origin == (down ? point{1.0, -298.0} : point{301.0, 2.0}));
    CHECK(run.glyphs[1].glyph_style == 0);
}
