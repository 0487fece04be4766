// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <typemesh/layout/inline_box.hpp>
#include <typemesh/layout/inline_box_place.hpp>
#include <typemesh/layout/layout.hpp>

#include <random>

using namespace typemesh;

namespace {

std::vector<inline_box_place> places_of(const glyph_run& run)
{
    std::vector<inline_box_place> all;
    each_inline_box(run, [&](const inline_box_place& p) { all.push_back(p); });
    return all;
}

}  // namespace

TEST_CASE("lines may end on both sides of a box, and are as high as it needs", "[layout]")
{
    const inline_box boxes[] = {{.unit = 2, .width = 1.2, .ascent = 1.5, .descent = 0.6}, {.unit = 5, .ascent = 0.2}};
    const std::u16string text = u"ab\uFFFCcd\uFFFC";
    test::laid_paragraph<> p{text, {.width = 1.3}, {.boxes = boxes}};
    REQUIRE(p.words.lines().size() == 4);
    const std::uint32_t firsts[] = {0, 2, 3, 5};
    for (std::size_t k = 0; k < 4; ++k) CHECK(p.words.lines()[k].first == firsts[k]);
    CHECK(p.words.lines()[1].metrics.ascender == 1500.0);
    CHECK(p.words.lines()[1].metrics.descender == -600.0);
    CHECK(p.words.lines()[3].metrics.ascender == 700.0);
    CHECK(p.run.lines[1].advance == 1200.0);
    p.again({.width = 2.5});
    CHECK(p.words.lines().size() == 2);
    CHECK(p.run.missing == 0);
    const std::u16string glued = u"ab\u00A0\uFFFC\u2060cd";  // glue holds a box as it holds letters
    const inline_box box{.unit = 3};
    const test::laid_paragraph<> whole{glued, {.width = 1.3, .wrap = wrap_mode::word}, {.boxes = {&box, 1}}};
    CHECK(whole.words.lines().size() == 1);
}

TEST_CASE("a text without boxes draws U+FFFC as any other character", "[layout]")
{
    const test::laid_paragraph<> p{u"a\uFFFC"};
    CHECK(p.run.glyphs[1].id == 0xFFFC);
    CHECK(places_of(p.run).empty());
}

TEST_CASE("a box has the rise of its style, and not its size", "[layout]")
{
    const std::u16string text = u"a\uFFFCb";
    const inline_box box{.unit = 1, .width = 2.0, .ascent = 0.8, .descent = 0.2};
    const style_span big{0, 3, {.size = 3.0, .rise = 0.25, .style = style_id{4}}};
    const test::laid_paragraph<> p{text, {}, {.styles = {&big, 1}, .boxes = {&box, 1}}};
    const auto places = places_of(p.run);
    REQUIRE(places.size() == 1);
    CHECK(places[0].map.xx == Approx(2.0));
    CHECK(places[0].map.yy == Approx(1.0));
    CHECK(places[0].map.dx == Approx(1.5));
    CHECK(places[0].map.dy == Approx(0.25 - 0.2));
    CHECK(p.style(1).style == style_id{4});
    CHECK(p.run.glyphs[2].origin.x == Approx(3500.0));
}

TEST_CASE("a box stands upright in the middle of a column", "[layout]")
{
    const std::u16string text = u"\u6F22\uFFFC\u5B57";
    const inline_box box{.unit = 1, .width = 2.0, .ascent = 0.8, .descent = 0.4};
    const test::laid_paragraph<> p{text, {}, {.direction = direction::top_to_bottom, .boxes = {&box, 1}}};
    const auto places = places_of(p.run);
    REQUIRE(places.size() == 1);
    const double step = -1e-3 * (p.run.glyphs[2].origin.y - p.run.glyphs[0].origin.y);
    CHECK(step == Approx(0.5 + 1.2));
    CHECK(places[0].map.xx == Approx(2.0));
    CHECK(places[0].map.dx == Approx(-1.0));
    CHECK(places[0].map.yy == Approx(1.2));
    CHECK(places[0].map.dy + 1.2 == Approx(1e-3 * p.run.glyphs[1].origin.y));
    CHECK(p.words.lines()[0].metrics.ascender == 1000.0);
    CHECK(p.words.lines()[0].metrics.descender == -1000.0);
}
