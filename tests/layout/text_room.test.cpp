// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <typemesh/layout/text_room.hpp>

using namespace typemesh;

namespace {

std::vector<double> spread(text_view text, const text_room& room, direction way = direction::automatic)
{
    return test::laid_paragraph<>{text, {}, {.direction = way, .rooms = {&room, 1}}}.places();
}

}  // namespace

TEST_CASE("a room spreads ideographs with half a gap at both ends, and words as a whole", "[layout]")
{
    // Letters are 500 wide.
    CHECK(spread(u"a\u6F22\u5B57b", {1, 3, 1.5}) == std::vector<double>{0.0, 625.0, 1375.0, 2000.0});
    CHECK(spread(u"abcd", {1, 3, 1.5}) == std::vector<double>{0.0, 750.0, 1250.0, 2000.0});
    CHECK(spread(u"ab\u6F22d", {1, 3, 1.5}) == std::vector<double>{0.0, 625.0, 1375.0, 2000.0});
    CHECK(spread(u"abcd", {1, 3, 0.9}) == std::vector<double>{0.0, 500.0, 1000.0, 1500.0});  // it is wide enough
    CHECK(spread(u"a b c", {1, 4, 1.5}) == std::vector<double>{0.0, 500.0, 1250.0, 2250.0, 2500.0});  // not the spaces
    const auto hebrew =
        spread(u"\u05D0\u05D1\u05D2\u05D3", {1, 3, 1.5});  // from left to right: dalet, gimel, bet, alef
    CHECK(hebrew == std::vector<double>{-2500.0, -1750.0, -1250.0, -500.0});
    const text_room room{1, 3, 1.5};
    const test::laid_paragraph<> column{
        u"a\u6F22\u5B57b", {}, {.direction = direction::top_to_bottom, .rooms = {&room, 1}}};
    const test::laid_paragraph<> plain{u"a\u6F22\u5B57b", {}, {.direction = direction::top_to_bottom}};
    const double down[] = {0.0, 125.0, 375.0, 500.0};
    for (std::size_t i = 0; i < 4; ++i) CHECK(column.run.glyphs[i].origin.y == plain.run.glyphs[i].origin.y - down[i]);
}

TEST_CASE("no line ends inside a room, however narrow the lines are, and its line is higher", "[layout]")
{
    const text_room room{2, 5, 1.0, 0.4};
    const std::u16string text = u"\u6F22\u6F22\u5B57\u5B57\u5B57\u6F22\u6F22";
    for (const wrap_mode wrap : {wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme})
        for (const double width : {0.1, 0.6, 1.1, 1.6}) {
            const test::laid_paragraph<> p{text, {.width = width, .wrap = wrap}, {.rooms = {&room, 1}}};
            std::size_t with = 0;
            for (const laid_line& line : p.words.lines()) {
                CHECK_FALSE((line.first > 2 && line.first < 5));
                const bool high = line.first <= 2 && line.last >= 5;
                with += high ? 1u : 0u;
                CHECK(line.metrics.ascender == (high ? 1100.0 : 700.0));
                CHECK(line.metrics.descender == -200.0);
            }
            CHECK(with == 1);
            CHECK(p.words.lines().size() >= 3);
        }
    const test::laid_paragraph<> even{text, {.boxes = line_box::uniform}, {.rooms = {&room, 1}}};
    CHECK(even.words.lines()[0].metrics.ascender == 700.0);
    const test::laid_paragraph<> elided{text, {.width = 1.7, .max_lines = 1, .ellipsis = u"."}, {.rooms = {&room, 1}}};
    CHECK(elided.lines()[0] == u"\u6F22\u6F22.");
}
