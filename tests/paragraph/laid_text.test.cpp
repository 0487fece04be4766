// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

const std::u16string mixed_lines = u"AV fix, \u05D0\u05D1 12 \u05D2 and\n\ta\u0301b fi \u05D3\u05D4\n";

using laid_out = test::laid_paragraph<>;

bool is_at(const caret& c, std::uint32_t line, double x, double y)
{
    return c.line == line && std::fabs(c.at.x - x) < 1e-12 && std::fabs(c.at.y - y) < 1e-12;
}

double width_of(const laid_out& p, std::uint32_t first, std::uint32_t last)
{
    double width = 0.0;
    for (const box& b : p.boxes(first, last)) width += b.width();
    return width;
}

double width_of_units(const laid_out& p, std::uint32_t first, std::uint32_t last)
{
    double width = 0.0;
    for (; first < last; ++first) width += width_of(p, first, first + 1);
    return width;
}

/// Sixteen letters of which an ellipsis of 1.5 replaces nine.
laid_out elided(ellipsis_place place)
{
    return laid_out{"abcdefghijklmnop", {.width = 5.0, .wrap = wrap_mode::none, .ellipsis = "...", .elide = place}};
}

constexpr struct {
    ellipsis_place place;
    std::uint32_t first, last;  // of what is dropped
    double at;                  // of the ellipsis
} elided_letters[] = {
    {ellipsis_place::start, 0, 9, 0.0}, {ellipsis_place::middle, 3, 12, 1.5}, {ellipsis_place::end, 7, 16, 3.5}};

}  // namespace

TEST_CASE("a caret stands before its grapheme, and upstream after the one before", "[paragraph]")
{
    const laid_out p{"ab cd", {.width = 1.5}};
    CHECK(is_at(p.laid().caret_at(0), 0, 0.0, 0.0));
    CHECK(is_at(p.laid().caret_at(2), 0, 1.0, 0.0));
    CHECK(is_at(p.laid().caret_at(3), 1, 0.0, -1.0));
    CHECK(is_at(p.laid().caret_at(3, affinity::upstream), 0, 1.25, 0.0));  // behind the space, which hangs
    CHECK(is_at(p.laid().caret_at(5), 1, 1.0, -1.0));
    CHECK(is_at(p.laid().caret_at(99), 1, 1.0, -1.0));
    const laid_out ligature{u"fia\u0301"};
    CHECK(is_at(ligature.laid().caret_at(1), 0, 0.35, 0.0));
    CHECK(is_at(ligature.laid().caret_at(3), 0, 0.7, 0.0));  // in the midst of a grapheme
}

TEST_CASE("a line's last letter ends where its letter spacing has been taken away", "[paragraph]")
{
    for (const text_view text : {text_view{"ab "}, text_view{u"\u05D0\u05D1 "}}) {
        const laid_out p{text, {.width = 9.0, .align = alignment::left}, {.letter_spacing = 0.1}};
        const bool back = p.words.lines()[0].level != 0;
        for (const affinity side : {affinity::downstream, affinity::upstream})
            CHECK(is_at(p.laid().caret_at(2, side), 0, back ? 0.0 : 1.1, 0.0));
    }
}

TEST_CASE("where directions meet, a place has two carets", "[paragraph]")
{
    const laid_out p{u"ab\u05D0\u05D1"};
    CHECK(is_at(p.laid().caret_at(2), 0, 2.0, 0.0));
    CHECK(p.laid().caret_at(2).to_the_left);
    CHECK(is_at(p.laid().caret_at(2, affinity::upstream), 0, 1.0, 0.0));
    CHECK_FALSE(p.laid().caret_at(2, affinity::upstream).to_the_left);
    CHECK(is_at(p.laid().caret_at(4), 0, 1.0, 0.0));
}

TEST_CASE("after a line break a caret stands in the next line", "[paragraph]")
{
    for (const affinity side : {affinity::downstream, affinity::upstream}) {
        CHECK(is_at(laid_out{"ab\ncd"}.laid().caret_at(3, side), 1, 0.0, -1.0));
        CHECK(is_at(laid_out{""}.laid().caret_at(0, side), 0, 0.0, 0.0));
        for (const text_view text :
             {text_view{u"ab\n"}, text_view{u"ab\r\n"}, text_view{u"ab\u0085"}, text_view{u"ab\u2028"},
              text_view{u"ab\u2029"}, text_view{u"ab\u001C"}, text_view{"ab\n"}, text_view{"ab\r\n"},
              text_view{"ab\xC2\x85"}, text_view{"ab\xE2\x80\xA8"}, text_view{"ab\xE2\x80\xA9"}, text_view{"ab\x1E"}})
            CHECK(is_at(laid_out{text}.laid().caret_at(static_cast<std::uint32_t>(text.size()), side), 1, 0.0, -1.0));
    }
}

TEST_CASE("a caret's own point leads back to it", "[paragraph]")
{
    struct place {
        std::uint32_t unit;
        affinity side;
        caret at;

        bool is_same(const caret& other) const
        {
            return at.line == other.line && std::fabs(at.at.x - other.at.x) < 1e-9;
        }
    };
    std::size_t alone = 0;  // places that no other caret has
    for (const double width : {100.0, 5.0, 2.0, 0.6})
        for (const alignment align : {alignment::start, alignment::justify, alignment::centre}) {
            const laid_out p{mixed_lines, {.width = width, .align = align}};
            const laid_text laid = p.laid();
            std::vector<place> all;
            for (std::uint32_t unit = 0; unit <= mixed_lines.size(); ++unit) {
                if (unit < mixed_lines.size() && !has(p.words.shaped().analysis.marks[unit], text_mark::grapheme))
                    continue;
                for (const affinity side : {affinity::downstream, affinity::upstream})
                    all.push_back({unit, side, laid.caret_at(unit, side)});
            }
            for (const place& one : all) {
                const text_place found = laid.caret_from(one.at.at);
                CHECK(one.is_same(laid.caret_at(found.unit, found.side)));
                std::size_t units = 0, places = 0;
                for (const place& other : all) {
                    units += other.is_same(one.at) && other.unit != one.unit ? 1u : 0u;
                    places += other.is_same(one.at) ? 1u : 0u;
                }
                if (units == 0) CHECK(found.unit == one.unit);
                if (places == 1) CHECK((found.unit == one.unit && found.side == one.side));
                alone += places == 1 ? 1u : 0u;
            }
        }
    CHECK(alone > 50);
}

TEST_CASE("a point in a line's box is in that line, however low the next one is", "[paragraph]")
{
    const style_span large[] = {{0, 1, {.size = 3.0}}};
    const laid_out p{"A\nb", {}, {.styles = large}};
    CHECK(p.laid().caret_from(p.laid().caret_at(0).at).unit == 0);  // the middle of the next line is nearer
    CHECK(p.laid().caret_from({0.1, -0.5}).unit == 0);
    CHECK(p.laid().caret_from({0.1, -1.0}).unit == 2);
}

TEST_CASE("a point is nearest to one side of a grapheme, and in a line or not", "[paragraph]")
{
    const laid_out p{u"ab \u05D0\u05D1"};
    CHECK(p.laid().caret_from({0.2, 0.1}).unit == 0);
    CHECK(p.laid().caret_from({0.3, 0.1}).unit == 1);
    CHECK(p.laid().caret_from({0.3, 0.1}).inside);
    CHECK_FALSE(p.laid().caret_from({0.3, 5.0}).inside);
    CHECK(p.laid().caret_from({9.0, 0.0}).unit == 3);   // the right end, where the Hebrew begins
    CHECK(p.laid().caret_from({1.35, 0.0}).unit == 5);  // and its left, where it ends
    CHECK(p.laid().caret_from({-9.0, 0.0}).unit == 0);
}

TEST_CASE("boxes cover what is selected, stretch by stretch", "[paragraph]")
{
    const laid_out p{u"ab \u05D0\u05D1 cd"};
    REQUIRE(p.boxes(0, 8).size() == 1);
    CHECK(p.boxes(0, 8)[0].low == point{0.0, -0.2});
    CHECK(p.boxes(0, 8)[0].high == point{3.5, 0.7});
    REQUIRE(p.boxes(1, 4).size() == 2);  // "b " and the right one of the Hebrew letters
    CHECK(p.boxes(1, 4)[0].high.x == 1.25);
    CHECK(p.boxes(1, 4)[1].low.x == 1.75);
    CHECK(p.boxes(3, 3).empty());

    // Whatever is selected, its boxes are as wide as its clusters.
    const laid_out wrapped{mixed_lines, {.width = 4.0}};
    for (std::uint32_t first = 0; first < mixed_lines.size(); ++first)
        for (std::uint32_t last = first + 1; last <= mixed_lines.size(); ++last)
            CHECK(std::fabs(width_of(wrapped, first, last) - width_of_units(wrapped, first, last)) < 1e-9);
}

TEST_CASE("boxes have no holes where kashida fills a line", "[paragraph]")
{
    const std::u16string text = u"\u0628\u0628\u0628 \u0628\u0628 \u0628 xxxxxxxxxx";
    const laid_out p{text, {.width = 5.7, .align = alignment::justify, .justify = justification::kashida}};
    const std::vector<box> all = p.boxes(0, 8);
    REQUIRE(all.size() == 1);
    CHECK(all[0].low.x == 0.0);
    CHECK(std::fabs(all[0].high.x - 5.7) < 1e-12);
    CHECK(std::fabs(width_of_units(p, 0, 8) - all[0].width()) < 1e-9);
}

TEST_CASE("what an ellipsis has dropped is selected as the ellipsis, which stands for nothing else", "[paragraph]")
{
    const auto check_unit = [](const laid_out& p, std::uint32_t unit, double width) {
        INFO(unit);
        const std::vector<box> boxes = p.boxes(unit, unit + 1);
        REQUIRE(boxes.size() == 1);
        CHECK(boxes[0].width() == Approx(width));
        return boxes[0].low.x;
    };
    for (const auto& [place, first, last, at] : elided_letters) {
        const laid_out p = elided(place);
        for (std::uint32_t unit = 0; unit < 16; ++unit) {
            const bool dropped = unit >= first && unit < last;
            const double left = check_unit(p, unit, dropped ? 1.5 : 0.5);
            if (dropped) CHECK(left == Approx(at));
        }
        CHECK(p.boxes(0, 16).size() == 1);
    }
    // All that the last line cannot show, line breaks too.
    const laid_out lines{"one two\nthree", {.width = 3.0, .max_lines = 1, .ellipsis = ".."}};
    for (std::uint32_t unit = 4; unit < 13; ++unit) check_unit(lines, unit, 1.0);
}

TEST_CASE("white space that an ellipsis replaces is dropped with what follows it", "[paragraph]")
{
    const laid_out p{"one two three four",
                     {.width = 4.3, .wrap = wrap_mode::none, .ellipsis = "..", .elide = ellipsis_place::middle}};
    REQUIRE(p.run.glyphs.size() == 3 + 2 + 3);  // one..our
    CHECK(p.run.glyphs[3].cluster == 4);
    for (const std::uint32_t unit : {3u, 4u, 14u}) CHECK(is_at(p.laid().caret_at(unit), 0, 1.5, 0.0));
    CHECK(is_at(p.laid().caret_at(15), 0, 2.5, 0.0));
    const std::vector<box> boxes = p.boxes(3, 4);
    REQUIRE(boxes.size() == 1);
    CHECK(boxes[0].low.x == Approx(1.5));
    CHECK(boxes[0].high.x == Approx(2.5));
}

TEST_CASE("carets in what an ellipsis has dropped stand at the ellipsis", "[paragraph]")
{
    for (const auto& [place, first, last, at] : elided_letters) {
        const laid_out p = elided(place);
        for (std::uint32_t unit = first; unit < last; ++unit) {
            CHECK(is_at(p.laid().caret_at(unit), 0, at, 0.0));
            CHECK(is_at(p.laid().caret_at(unit + 1, affinity::upstream), 0, at + 1.5, 0.0));
        }
        CHECK(is_at(p.laid().caret_at(16), 0, 5.0, 0.0));
    }
    const laid_out filled{
        u"\u0628\u0628 \u0628\u0628 x y z",
        {.width = 2.9, .align = alignment::justify, .justify = justification::kashida, .max_lines = 1}};
    CHECK(filled.count(0x640) > 0);  // strokes, which are no ellipsis
    for (std::uint32_t unit = 6; unit < 11; ++unit)
        CHECK(filled.laid().caret_at(unit).at == filled.laid().caret_at(11).at);
}

TEST_CASE("lines have boxes, columns too", "[paragraph]")
{
    const laid_out p{"ab cd", {.width = 2.0, .align = alignment::right}};
    CHECK(length(p.laid().line_box(1).low - point{1.0, -1.2}) < 1e-12);
    CHECK(length(p.laid().line_box(1).high - point{2.0, -0.3}) < 1e-12);
    CHECK(p.laid().line_of(2) == 0);
    CHECK(p.laid().line_of(3) == 1);

    const laid_out down{"abc", {}, {.direction = direction::top_to_bottom}};
    CHECK(down.laid().line_box(0).low == point{-0.45, -1.5});
    CHECK(down.laid().caret_at(1).at == point{0.0, -0.5});
    CHECK(down.laid().caret_from({0.1, -0.6}).unit == 1);
}

TEST_CASE("until its text is laid out a paragraph has no lines or boxes, and its carets stand at 0", "[paragraph]")
{
    test::toy_shaper font;
    paragraph<test::toy_shaper> words{font};
    glyph_run run;
    const auto has_none = [&words] {
        CHECK(words.lines().empty());
        CHECK(words.laid().line_box(0).empty());
        CHECK(is_at(words.laid().caret_at(3), 0, 0.0, 0.0));
        CHECK((words.laid().caret_from({2, 0}).unit == 0 && !words.laid().caret_from({2, 0}).inside));
        words.laid().boxes_of(0, 9, [](const box&) { FAIL("a box of no line"); });
    };
    has_none();
    REQUIRE(words.set("some text"));
    has_none();
    REQUIRE(words.lay_out({}, run));
    CHECK(words.laid().caret_at(3).at.x > 0.0);
    REQUIRE(words.set("another"));
    has_none();
    REQUIRE(words.lay_out({}, run));
    REQUIRE_FALSE(words.lay_out({.width = -1.0}, run));
    has_none();
}

TEST_CASE("a point finds its grapheme in a cluster", "[paragraph]")
{
    for (const layout_options& how : {layout_options{}, layout_options{.width = 3.0}}) {
        const laid_out p{mixed_lines, how};
        for (std::uint32_t unit = 0; unit < mixed_lines.size(); ++unit)
            for (const box& b : p.boxes(unit, unit + 1)) {
                const text_range found = p.laid().grapheme_at(unit, 0.5 * (b.low + b.high));
                CHECK(found.holds(unit));
                CHECK(found.last > found.first);
            }
    }
    const laid_out ligature{u"xfia\u0301"};
    CHECK(ligature.laid().grapheme_at(1, {0.6, 0.0}).first == 1);  // f, the i is the same cluster
    CHECK(ligature.laid().grapheme_at(1, {1.1, 0.0}).first == 2);
    CHECK(ligature.laid().grapheme_at(2, {-9.0, 0.0}).first == 1);
    CHECK(ligature.laid().grapheme_at(3, {0.0, 0.0}).last == 5);
    CHECK(ligature.laid().grapheme_at(99, {}).last == 0);
    CHECK_FALSE(ligature.laid().in_columns());
    const laid_out elided{"abcdef", {.width = 2.0, .max_lines = 1, .ellipsis = "."}};
    CHECK(elided.laid().grapheme_at(5, {1.9, 0.0}).last == 6);
    CHECK(laid_out{""}.laid().grapheme_at(0, {}).last == 0);
}
