// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/paragraph.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using test::toy_shaper;

namespace {

const std::u16string mixed =
    u"AVATAR of the fifth office, \u05D0\u05D1 12 \u05D2\u05D3 and fi\u00ADfi\n\ta\u0301\u0302b\t\u0628\u0628 "
    u"\u0662\u0663.\r\nx  \n";

using laid = test::laid_paragraph<>;
using line_texts = std::vector<std::u16string>;

constexpr wrap_mode all_wraps[] = {wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme};

struct expected_lines {
    layout_options how;
    line_texts lines;
};

void check_lines(laid& p, const std::vector<expected_lines>& cases)
{
    for (std::size_t k = 0; k < cases.size(); ++k) {
        INFO("row " << k);
        p.again(cases[k].how);
        CHECK(p.lines() == cases[k].lines);
    }
}

template <class Text>
concept can_be_set = requires(paragraph<toy_shaper>& p, Text&& text, std::span<const style_span> spans) {
    p.set(static_cast<Text&&>(text));
    p.set(static_cast<Text&&>(text), {.styles = spans});
};

}  // namespace

static_assert(can_be_set<text_view> && can_be_set<const char (&)[4]> && can_be_set<std::u16string_view>);
static_assert(can_be_set<std::string&> && can_be_set<const std::u16string&>);
static_assert(!can_be_set<std::string> && !can_be_set<const std::u8string> && !can_be_set<std::u16string>);

TEST_CASE("a paragraph that has been moved from has no text until it gets one", "[paragraph]")
{
    laid p{"one two", {.width = 2.0}};
    paragraph<toy_shaper> others{std::move(p.words)};
    CHECK(others.lines().size() == 2);
    for (const wrap_mode wrap : {wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme}) {
        p.again({.width = 1.0, .wrap = wrap, .ellipsis = ".."});
        CHECK(p.run.glyphs.empty());
        CHECK(p.words.lines().empty());
        CHECK(p.words.widths().widest == 0.0);
    }
    REQUIRE(p.words.set("one two"));
    p.again({.width = 2.0});
    CHECK(p.words.lines().size() == 2);
}

TEST_CASE("a paragraph's text fills lines of a width", "[paragraph]")
{
    laid p{"one two three", {.width = 4.0}};
    CHECK(p.run.lines[0].advance == 3250.0);
    CHECK(p.run.lines[1].origin == point{0.0, -1000.0});
    CHECK(p.run.units_per_em == 1000.0);
    check_lines(p, {{{.width = 4.0}, {u"one two ", u"three"}},
                    {{.width = 3.2}, {u"one ", u"two ", u"three"}},
                    {{.width = 2.0}, {u"one ", u"two ", u"thre", u"e"}},
                    {{.width = 2.0, .wrap = wrap_mode::word}, {u"one ", u"two ", u"three"}},
                    {{.width = 2.0, .wrap = wrap_mode::none}, {u"one two three"}},
                    {{.width = 2.6, .wrap = wrap_mode::grapheme}, {u"one t", u"wo th", u"ree"}},
                    {{}, {u"one two three"}}});
}

TEST_CASE("every cluster is drawn exactly once, at any width and way of wrapping", "[paragraph]")
{
    laid p{mixed};
    std::map<cluster_id, int> shaped;
    for (std::uint32_t c = 0; c < p.words.shaped().cluster_count(); ++c)
        if (p.words.shaped().cluster(c).glyph_count != 0) shaped[p.words.shaped().cluster(c).first] = 0;
    for (const wrap_mode wrap : all_wraps)
        for (double width = 0.1; width < 30.0; width *= 1.25) {
            p.again({.width = width, .wrap = wrap});
            std::uint32_t at = 0, glyph = 0;
            for (std::size_t k = 0; k < p.run.lines.size(); ++k) {
                const laid_line& line = p.words.lines()[k];
                CHECK(line.first == at);
                at = line.last;
                CHECK(p.run.lines[k].first_glyph == glyph);
                glyph += p.run.lines[k].glyph_count;
            }
            CHECK(at == mixed.size());
            CHECK(glyph == p.run.glyphs.size());
            std::map<cluster_id, int> times;
            std::map<std::pair<cluster_id, glyph_id>, int> each;  // a letter's marks are of its cluster
            for (const placed_glyph& g : p.run.glyphs) {
                ++times[g.cluster];
                CHECK(++each[{g.cluster, g.id}] == 1);
            }
            for (const auto& [cluster, unused] : shaped) CHECK(times.count(cluster) == 1);
        }
}

TEST_CASE("a line that is read to the left ends with its hyphen on the left", "[paragraph]")
{
    laid p{u"\u0627\u062F\u00AD\u062F\u0627", {.width = 1.6}};
    REQUIRE(p.lines() == line_texts{u"\u2010\u00AD\u062F\u0627", u"\u0627\u062F"});
    std::vector<cluster_id> clusters;
    for (const placed_glyph& g : p.run.glyphs) clusters.push_back(g.cluster);
    CHECK(clusters == std::vector<cluster_id>{2, 2, 1, 0, 4, 3});
    CHECK(p.run.glyphs[0].id == 0x2010);
    CHECK(p.run.glyphs[3].origin.x == p.run.lines[0].origin.x + 1000.0);
}

TEST_CASE("no line ends between a space and a mark on it", "[paragraph]")
{
    CHECK(laid{u"ab \u0301cd", {.width = 1.2, .wrap = wrap_mode::word}}.lines() == line_texts{u"ab \u0301cd"});
}

TEST_CASE("a text that ends with a break has an empty last line, however it is wrapped", "[paragraph]")
{
    for (const wrap_mode wrap : all_wraps) {
        CHECK(laid{"ab\n", {.wrap = wrap}}.lines() == line_texts{u"ab", u""});
        CHECK(laid{"ab\n\n", {.wrap = wrap}}.lines() == line_texts{u"ab", u"", u""});
    }
    CHECK(laid{"ab\n", {.width = 1.0, .indent = 2.0}}.lines() == line_texts{u"a", u"b", u""});
}

TEST_CASE("a layout does not depend on those before it", "[paragraph]")
{
    laid often{mixed};
    for (const double width : {30.0, 3.0, 0.1, 5.0, 2.0, 3.0})
        for (const wrap_mode wrap : {wrap_mode::word_or_grapheme, wrap_mode::grapheme, wrap_mode::word}) {
            CAPTURE(width, static_cast<int>(wrap));
            const layout_options options{.width = width, .wrap = wrap, .ellipsis = ".."};
            often.again(options);
            CHECK(test::same_glyphs(often.run, laid{mixed, options}.run));
        }
}

TEST_CASE("lines are set to any side of the width, or of x = 0", "[paragraph]")
{
    struct expected {
        alignment align;
        double boxed, free, left, left_free;  // x of a line that is read to the right, to the left
    };
    using a = alignment;
    laid right{"abc"}, left{u"\u05D0\u05D1\u05D2"};
    for (const auto& [align, boxed, free, back, back_free] : {expected{a::start, 0.0, 0.0, 2500.0, -1500.0},
                                                              {a::end, 2500.0, -1500.0, 0.0, 0.0},
                                                              {a::left, 0.0, 0.0, 0.0, 0.0},
                                                              {a::centre, 1250.0, -750.0, 1250.0, -750.0},
                                                              {a::right, 2500.0, -1500.0, 2500.0, -1500.0},
                                                              {a::justify, 0.0, 0.0, 2500.0, -1500.0}}) {
        for (laid* p : {&right, &left}) {
            p->again({.width = 4.0, .align = align});
            CHECK(p->run.lines[0].origin.x == (p == &right ? boxed : back));
            CHECK(p->run.glyphs[0].origin.x == (p == &right ? boxed : back));
            p->again({.align = align});
            CHECK(p->run.lines[0].origin.x == (p == &right ? free : back_free));
        }
    }
}

TEST_CASE("white space at a line's end hangs beyond the width, on the side where the line ends", "[paragraph]")
{
    const laid right{"ab   cd", {.width = 1.0, .align = alignment::right}};
    CHECK(right.line(0) == u"ab   ");
    CHECK(right.places() == std::vector{0.0, 500.0, 1000.0, 1250.0, 1500.0, 0.0, 500.0});
    const laid left{u"\u05D0\u05D1   \u05D2", {.width = 1.0}};
    CHECK(left.run.lines[0].glyph_count == 5);
    CHECK(left.places() == std::vector{-750.0, -500.0, -250.0, 0.0, 500.0, 500.0});
}

TEST_CASE("justified lines fill the width by their spaces, except a paragraph's last", "[paragraph]")
{
    const laid p{"a b cd e f\ng hi", {.width = 3.2, .align = alignment::justify}};
    CHECK(p.lines() == line_texts{u"a b cd ", u"e f", u"g hi"});
    CHECK(p.advances() == std::vector{3200.0, 1250.0, 1750.0});
    const std::vector<double> x = p.places();
    CHECK(x[2] - x[0] == x[4] - x[2]);
}

TEST_CASE("first lines of paragraphs are indented at their start", "[paragraph]")
{
    const laid p{"ab cd\nef\xE2\x80\xA8gh", {.width = 1.5, .indent = 0.25}};
    CHECK(p.lines() == line_texts{u"ab ", u"cd", u"ef", u"gh"});
    for (std::size_t k = 0; k < 4; ++k) CHECK(p.run.lines[k].origin.x == (k % 2 == 0 ? 250.0 : 0.0));
    CHECK(laid{u"\u05D0\u05D1", {.width = 2.0, .indent = 0.25}}.run.lines[0].origin.x == 750.0);
}

TEST_CASE("tabs lead to stops, in the direction of the paragraph", "[paragraph]")
{
    const double stops[] = {0.75};
    CHECK(laid{"a\tb\tc", {.tab_stops = stops}}.places() == std::vector{0.0, 750.0, 2000.0});
    CHECK(laid{u"\u05D0\tb", {.width = 4.0, .tab_stops = stops}}.places() ==
          std::vector{4000.0 - 750.0 - 500.0, 3500.0});
    CHECK(laid{"AV\tb"}.places()[2] == 2000.0);  // 1000 is nearer than half a digit
    CHECK(laid{"a\tb", {.tab_width = 0.0}}.places()[1] == 500.0);
}

TEST_CASE("soft hyphens show where a line ends and nowhere else", "[paragraph]")
{
    laid p{
        "ab\xC2\xAD"
        "cd\xC2\xAD"
        "ef",
        {.width = 1.6}};
    CHECK(p.run.lines.size() == 3);
    CHECK(p.advances()[0] == 1500.0);
    CHECK(p.glyphs_of(0).back().id == 0x2010);
    p.again({});
    CHECK(p.count(0x2010) == 0);
    CHECK(p.advances() == std::vector{3000.0});
}

TEST_CASE("a hyphen never sticks out of a line in which something else fits", "[paragraph]")
{
    laid p{
        "abcd\xC2\xAD"
        "efgh"};
    for (double width = 0.5; width < 5.0; width += 0.25) {
        p.again({.width = width});
        for (const text_line& line : p.run.lines) CHECK(line.advance <= 1000.0 * width);
    }
    p.again({.width = 2.0});
    CHECK(p.run.lines.size() == 2);
}

TEST_CASE("a text fits into the width that was measured for it, whatever is rounded", "[paragraph]")
{
    laid p{""};
    for (int k = 1; k < 200; ++k) {
        CAPTURE(k);
        REQUIRE(p.words.set("one two three\nfour and more words", {.letter_spacing = 0.01 * k}));
        p.again({.width = p.words.widths().widest});
        CHECK(p.run.lines.size() == 2);
        p.again({.width = p.words.widths().narrowest});
        CHECK(p.run.lines.size() == 7);
        double width = 0.0;
        for (const text_line& line : p.run.lines) width = (std::max)(width, line.advance);
        p.again({.width = width / 1000.0, .max_lines = 7, .ellipsis = ".."});
        CHECK(p.run.lines.size() == 7);
        CHECK(p.count('.') == 0);
    }
}

TEST_CASE("what is dropped leaves an ellipsis at the end, in the middle or at the start", "[paragraph]")
{
    constexpr wrap_mode none = wrap_mode::none;
    laid p{"one two three\nfour"};
    check_lines(
        p, {{{.width = 4.0, .max_lines = 1, .ellipsis = ".."}, {u"one tw.."}},
            {{.width = 3.3, .max_lines = 2, .ellipsis = ".."}, {u"one two ", u"thre.."}},
            {{.width = 3.3, .max_lines = 2}, {u"one two ", u"three"}},
            {{.width = 4.0, .wrap = none, .ellipsis = ".."}, {u"one tw..", u"four"}},
            {{.width = 4.0, .wrap = none, .ellipsis = "..", .elide = ellipsis_place::start}, {u"..three", u"four"}},
            {{.width = 4.0, .wrap = none, .ellipsis = "..", .elide = ellipsis_place::middle}, {u"one..ree", u"four"}},
            {{.width = 9.0, .wrap = none, .ellipsis = ".."}, {u"one two three", u"four"}}});
    p.again({.width = 0.7, .wrap = none, .ellipsis = ".."});
    CHECK(p.line(0) == u"..");                       // nothing else fits, nor does it
    for (const char* end : {"\n", "\n\n", "\n \n"})  // nothing is dropped but empty lines
        CHECK(laid{std::string{"one"} + end, {.max_lines = 1, .ellipsis = ".."}}.line(0) == u"one");
    const layout_options narrow{.width = 2.0, .wrap = none, .ellipsis = ".."};
    CHECK(laid{u"\u05D0\u05D1\u05D2", narrow}.line(0) == u"\u05D2\u05D1\u05D0");
    CHECK(laid{u"\u05D0\u05D1\u05D2\u05D3\u05D4", narrow}.line(0) == u"..\u05D1\u05D0");
}

TEST_CASE("an elided line is never wider than its room, if the ellipsis fits", "[paragraph]")
{
    laid p{mixed};
    for (const ellipsis_place place : {ellipsis_place::end, ellipsis_place::middle, ellipsis_place::start})
        for (double width = 1.1; width < 20.0; width *= 1.2)
            for (const wrap_mode wrap : {wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme})
                for (const std::uint32_t most : {1u, 2u, 3u, 100u})
                    for (const double tab : {0.0, 4.0}) {
                        p.again({.width = width,
                                 .wrap = wrap,
                                 .max_lines = most,
                                 .ellipsis = "..",
                                 .elide = place,
                                 .tab_width = tab});
                        CHECK(p.run.lines.size() <= most);
                        for (const text_line& line : p.run.lines) CHECK(line.advance <= 1000.0 * width + 1e-9);
                    }
}

TEST_CASE("text without words has lines, too", "[paragraph]")
{
    const laid nothing{""}, spaces{"   ", {.width = 0.1, .align = alignment::right}};
    REQUIRE(nothing.run.lines.size() == 1);
    CHECK(nothing.run.glyphs.empty());
    CHECK(nothing.words.widths().widest == 0.0);
    REQUIRE(spaces.run.lines.size() == 1);
    CHECK(spaces.run.lines[0].advance == 0.0);
    CHECK(spaces.run.lines[0].origin.x == 100.0);
    CHECK(laid{"\r\n\n\xE2\x80\xA8"}.run.lines.size() == 4);
    CHECK(laid{"wide", {.width = 0.1}}.lines() == line_texts{u"w", u"i", u"d", u"e"});
    CHECK(laid{"\t\t", {.width = 0.5}}.run.lines.size() == 1);
}

TEST_CASE("information separators end paragraphs, and are not drawn", "[paragraph]")
{
    const laid p{
        "ab\x1C"
        "cd\x1D\x1E",
        {.indent = 0.5}};
    CHECK(p.lines() == line_texts{u"ab", u"cd", u"", u""});
    CHECK(p.run.lines[1].origin.x == 500.0);
}

TEST_CASE("text for which the font gives no glyphs is laid out, too", "[paragraph]")
{
    laid p{"ab\n\x7F\n\x7F"};
    REQUIRE(p.run.lines.size() == 3);
    CHECK(p.run.glyphs.size() == 2);
    CHECK(p.words.lines()[2].last == 6);
    const caret end = p.words.laid().caret_at(6);
    CHECK(end.line == 2);
    CHECK(end.at == point{0.0, -2.0});
}

TEST_CASE("a paragraph knows how narrow and how wide its text may be", "[paragraph]")
{
    laid p{"one two three\nfour"};
    CHECK(p.words.widths().narrowest == 2.5);
    CHECK(p.words.widths().widest == 6.0);
    p.again({.width = 6.0});
    CHECK(p.run.lines.size() == 2);
    p.again({.width = 5.999});
    CHECK(p.run.lines.size() == 3);
    REQUIRE(p.words.set("one two", {.letter_spacing = 0.1}));  // without the distance behind the last letter
    CHECK(p.words.widths().narrowest == 1.7);
    p.again({.width = 1.7});
    CHECK(p.lines() == line_texts{u"one ", u"two"});
}

TEST_CASE("a text is measured as it is laid out, without writing it", "[paragraph]")
{
    laid p{mixed};
    for (const double width : {2.0, 5.0, 30.0}) {
        const layout_options options{.width = width, .max_lines = 7, .ellipsis = "..", .indent = 0.25};
        const auto size = p.words.measure(options);
        REQUIRE(size);
        const std::size_t lines = p.words.lines().size();
        const box last = p.words.laid().line_box(lines - 1);
        p.again(options);
        CHECK(p.run.lines.size() == lines);
        CHECK(p.words.laid().line_box(lines - 1).high.x == last.high.x);
        CHECK(size->height == 1.0 * static_cast<double>(lines - 1) + 0.9);
        double longest = 0.0;
        for (std::size_t k = 0; k < lines; ++k)
            longest = std::max(longest, (p.run.lines[k].origin.x + p.run.lines[k].advance) / 1000.0);
        if (width > 20.0) CHECK(size->width == p.words.measure({.width = size->width, .indent = 0.25})->width);
        CHECK(size->width <= width);
    }
    CHECK(p.words.measure({.width = -1.0}).error() == error::bad_option);
    CHECK(p.words.lines().empty());
    paragraph nothing{p.font};
    CHECK(nothing.measure({})->height == 0.0);
}

TEST_CASE("columns run down and are as high as the width", "[paragraph]")
{
    shape_options how{.direction = direction::top_to_bottom};
    for (const bool upright : {false, true}) {
        how.columns.latin = upright ? column_latin::upright : column_latin::sideways;
        const laid p{u"ab \u05D0", {.width = 1.2}, how};
        REQUIRE(p.run.lines.size() == 2);
        const double middle = upright ? 0.0 : -250.0;  // half-way between ascender and descender
        CHECK(p.run.glyphs[1].origin == point{middle, -500.0});
        CHECK(p.run.glyphs[3].origin == point{middle - (700.0 + 450.0 + 100.0), 0.0});  // line_reach_of()
    }
}

TEST_CASE("columns of Mongolian go to the right, others to the left, or as the caller wants", "[paragraph][columns]")
{
    const double apart = 700.0 + 450.0 + 100.0;  // line_reach_of()
    for (const char16_t* text : {u"\u182E\u1823 \u1829", u"ab \u05D0"})
        for (const column_progress progress :
             {column_progress::automatic, column_progress::leftwards, column_progress::rightwards}) {
            shape_options how{.direction = direction::top_to_bottom};
            how.columns.progress = progress;
            const bool right = progress == column_progress::rightwards ||
                               (progress == column_progress::automatic && text[0] == 0x182E);
            laid p{text, {.width = 1.2}, how};
            REQUIRE(p.run.lines.size() == 2);
            CHECK(p.run.lines[1].origin == point{right ? apart : -apart, 0.0});
            const box first = p.words.laid().line_box(0), second = p.words.laid().line_box(1);
            CHECK((right ? second.low.x - first.high.x : first.low.x - second.high.x) == Approx(0.1));
            p.again({.width = 1.2, .anchor = vertical_anchor::top});
            CHECK((right ? p.words.laid().line_box(0).low.x : p.words.laid().line_box(0).high.x) ==
                  Approx(0.0).margin(1e-9));
        }
}

TEST_CASE("in a column letters on their side are read as in a line that is turned", "[paragraph]")
{
    const std::u16string text = u"\u4E16ab \u05D0\u05D1\u05D2 c\u754C";
    const laid column{text, {}, {.direction = direction::top_to_bottom}}, line{text};
    REQUIRE(column.run.glyphs.size() == line.run.glyphs.size());
    CHECK(column.run.lines[0].advance == line.run.lines[0].advance);
    for (std::size_t i = 0; i < line.run.glyphs.size(); ++i) {
        const placed_glyph &down = column.run.glyphs[i], &along = line.run.glyphs[i];
        CHECK(down.id == along.id);
        CHECK(down.cluster == along.cluster);
        CHECK(down.origin.y == 0.0 - along.origin.x);
        const bool upright = down.id == 0x4E16 || down.id == 0x754C;
        CHECK(column.style(i).map == (upright ? affine{} : quarter_turn));
        const text_place here = column.words.laid().caret_from({0.0, down.origin.y / 1000.0 - 0.001});
        const text_place there = line.words.laid().caret_from({along.origin.x / 1000.0 + 0.001, 0.0});
        CHECK(here.unit == there.unit);
        CHECK(here.inside);
    }
}

TEST_CASE("a column whose first letter is Hebrew is read upwards, unless all of it is upright", "[paragraph]")
{
    shape_options how{.direction = direction::top_to_bottom};
    CHECK(laid(u"\u05D0\u05D1 ab", {.align = alignment::left}, how).line(0) == u"ab \u05D1\u05D0");
    how.columns.latin = column_latin::upright;
    const laid upright{u"\u05D0\u05D1 ab", {}, how};
    CHECK(upright.line(0) == u"\u05D0\u05D1 ab");
}

TEST_CASE("a combined number is one grapheme, an em high, and no line ends in it", "[paragraph]")
{
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 3;
    laid p{u"\u4E16123\u754C", {}, how};
    CHECK(p.run.lines[0].advance == 2000.0);
    CHECK(p.style(1).map == affine{.xx = 1000.0 / 1500.0});
    CHECK(p.run.glyphs[1].origin.x == -500.0);
    CHECK(p.run.glyphs[4].glyph_style == 0);
    CHECK(p.words.laid().caret_at(2).at == p.words.laid().caret_at(1).at);
    CHECK(p.words.laid().caret_from({0.0, -1.4}).unit == 4);
    p.again({.width = 0.1, .wrap = wrap_mode::grapheme});
    CHECK(p.run.lines.size() == 3);
    CHECK(p.words.lines()[1].first == 1);
    CHECK(p.words.lines()[1].last == 4);
    p.again({.width = 1.8, .ellipsis = u"\u2026"});
    CHECK(p.run.lines.size() == 2);
}

TEST_CASE("a style that ends within a combined number is the style of all of it, and is counted", "[paragraph][styles]")
{
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 2;
    for (const std::uint32_t digit : {1u, 2u}) {
        const style_span span[] = {{digit, digit + 1, {.style = style_id{5}}}};
        how.styles = span;
        const laid p{u"\u4E1612\u754C", {}, how};
        CHECK(p.words.shaped().styles.moved() == 1);
        for (std::size_t i = 0; i < 4; ++i) CHECK(p.style(i).style == style_id{i == 1 || i == 2 ? 5u : 0u});
    }
}

TEST_CASE("a paragraph refuses what makes no sense, and is empty then", "[paragraph]")
{
    laid p{"ab"};
    CHECK(p.words.lay_out({.width = 0.0}, p.run) == error::bad_option);
    CHECK(p.run.lines.empty());
    CHECK(p.words.lines().empty());
    p.again({});
    CHECK(p.words.set("ab", {.letter_spacing = std::numeric_limits<double>::quiet_NaN()}) == error::bad_option);
    const error refused = p.words.set("ab!").error();
    CHECK(refused == error::font_library_failed);
    CHECK(refused.cluster == 2);
    p.again({});
    CHECK(p.run.glyphs.empty());
    CHECK(p.run.lines.empty());
    CHECK(p.words.widths().widest == 0.0);
}

TEST_CASE("a paragraph is empty after a text that was refused, even if there is no memory for more", "[paragraph]")
{
    test::counting_memory counted;
    toy_shaper font;
    paragraph<toy_shaper> words{font, counted.source()};
    glyph_run run;
    const std::string text{"a text of words"}, refused{"a text of more words than before, with a mark!"};
    REQUIRE(words.set(text));
    counted.fail_at = counted.requests + 1;
    CHECK_FALSE(words.set(refused));
    REQUIRE(words.lay_out({.width = 1.0}, run));
    CHECK(run.glyphs.empty());
    CHECK(run.lines.empty());
    CHECK(words.shaped().text().empty());
    CHECK(words.shaped().cluster_count() == 0);
    CHECK(words.shaped().items().empty());
}

TEST_CASE("a paragraph reports where its text is invalid or its font lacks a glyph", "[paragraph]")
{
    const laid p{u"ab\xD800 \uFFFF"};
    CHECK(p.run.invalid_units == 1);
    CHECK(p.run.first_invalid_unit == 2);
    CHECK(p.run.missing == 1);
    CHECK(p.run.first_missing == 4);
}

TEST_CASE("a paragraph reports words that only a dictionary finds, where lines have a width to end at", "[paragraph]")
{
    laid p{u"ab \u0E20\u0E32\u0E29\u0E32 cd \u0E9E\u0EB2"};
    CHECK(p.run.unbroken == 0);
    for (const wrap_mode wrap : all_wraps) {
        const bool words = wrap == wrap_mode::word || wrap == wrap_mode::word_or_grapheme;
        p.again({.width = 3.0, .wrap = wrap});
        CHECK(p.run.unbroken == (words ? 2 : 0));
        CHECK(p.run.first_unbroken == (words ? 3 : no_cluster));
    }
}

TEST_CASE("laying out again allocates nothing, and shapes nothing but the shortest lines", "[paragraph]")
{
    test::counting_memory counted;
    toy_shaper font;
    paragraph<toy_shaper> words{font, counted.source()};
    glyph_run run{counted.source()};
    REQUIRE(words.set(mixed));
    const auto all = [&] {
        for (const double width : {3.0, 7.0, 1.0, 40.0})
            for (const alignment align : {alignment::start, alignment::justify})
                for (const wrap_mode wrap : {wrap_mode::word_or_grapheme, wrap_mode::grapheme})
                    REQUIRE(words.lay_out({.width = width, .wrap = wrap, .align = align}, run));
    };
    all();
    const std::size_t before = counted.requests;
    all();
    CHECK(counted.requests == before);
    // Of glyphs, only those of lines are shaped that are so short that what changes at their two ends meets.
    const std::size_t calls = font.calls;
    for (const double width : {7.0, 40.0}) REQUIRE(words.lay_out({.width = width}, run));
    CHECK(font.calls == calls);
}

TEST_CASE("a paragraph survives a memory that gives nothing, wherever it stops", "[paragraph]")
{
    test::check_each_failure([](memory source) {
        toy_shaper font;
        paragraph<toy_shaper> words{font, source};
        glyph_run run{source};
        error e = words.set(mixed).error();
        if (!e) e = words.lay_out({.width = 1.0, .wrap = wrap_mode::word_or_grapheme, .ellipsis = ".."}, run).error();
        if (!e) e = words.lay_out({.width = 3.0, .max_lines = 2, .ellipsis = ".."}, run).error();
        return e;
    });
}

TEST_CASE("a layout for which memory fails has no effect on the next one", "[paragraph]")
{
    const layout_options options{.width = 1.0, .ellipsis = ".."};
    const laid fresh{mixed, options};
    toy_shaper font;
    std::size_t failures = 0;
    for (bool failed = true; failed; ++failures) {
        test::counting_memory failing;
        paragraph<toy_shaper> words{font, failing.source()};
        glyph_run run;
        REQUIRE(words.set(mixed));
        failing.fail_at = failing.requests + failures + 1;
        const error e = words.lay_out(options, run).error();
        failed = failing.requests >= failing.fail_at;
        CHECK(e.code == (failed ? error::out_of_memory : error::none));
        failing.fail_at = 0;
        for (int k = 0; k < 2; ++k) {
            REQUIRE(words.lay_out({.width = 2.0}, run));
            REQUIRE(words.lay_out(options, run));
        }
        CHECK(test::same_glyphs(run, fresh.run));
    }
    CHECK(failures > 3);
}

TEST_CASE("a text of any length is shaped once, and lines end in linear time", "[paragraph]")
{
    // Counted are the units that the shaper sees; places that are unsafe are shaped twice more, each with few neighbours.
    std::vector<double> a_unit;
    for (const std::size_t size : {1000u, 10000u, 100000u}) {
        std::u16string text;
        while (text.size() < size) text += u"AVATAR of the fifth office, \u05D0\u05D1 12 \u05D2\u05D3 ";
        laid p{text};
        a_unit.push_back(static_cast<double>(p.font.units) / static_cast<double>(text.size()));
        p.again({.width = 20.0});
        CHECK(p.font.units <= 2 * text.size());
    }
    for (const double units : a_unit) CHECK(std::fabs(units - a_unit[0]) < 0.05);
}

TEST_CASE("where no place is safe, a line's end is still shaped with few neighbours", "[paragraph]")
{
    struct unsafe_shaper : toy_shaper {
        unsafe_shaper() { all_unsafe = true; }
    };
    std::vector<double> a_unit;
    for (const std::size_t size : {1000u, 6000u}) {
        std::string text;
        while (text.size() < size) text += "abcd efghijk lmnop qr ";
        test::laid_paragraph<unsafe_shaper> p{text, {.width = 9.0, .wrap = wrap_mode::word}};
        p.again({.width = 9.0, .wrap = wrap_mode::grapheme});
        CHECK(p.run.glyphs.size() == text.size());
        a_unit.push_back(static_cast<double>(p.font.units) / static_cast<double>(text.size()));
    }
    CHECK(a_unit[1] < 1.05 * a_unit[0]);
}

TEST_CASE("styles say how parts of a column stand", "[paragraph][columns][styles]")
{
    const style_span spans[] = {{0, 1, {.column = column_style::sideways}},
                                {2, 4, {.column = column_style::upright}},
                                {4, 8, {.size = 2.0, .column = column_style::combined}}};
    const laid p{u"\u4E16abc2024", {}, {.direction = direction::top_to_bottom, .styles = spans}};
    REQUIRE(p.run.glyphs.size() == 8);
    for (std::size_t i = 0; i < 8; ++i)  // the number: four halves in one em of size 2
        CHECK(p.style(i).map == (i < 2 ? quarter_turn : i < 4 ? affine{} : affine{.xx = 1.0, .yy = 2.0}));
    CHECK(p.run.lines[0].advance == 4 * 500.0 + 2000.0);
}
