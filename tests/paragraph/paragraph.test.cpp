// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_shaper.hpp"

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

struct laid {
    toy_shaper font;
    paragraph<toy_shaper> words{font};
    glyph_run run;

    explicit laid(text_view text, const layout_options& options = {}, const shape_options& how = {})
    {
        REQUIRE(words.set(text, how));
        again(options);
    }
    void again(const layout_options& options) { REQUIRE(words.lay_out(options, run)); }

    /// A line as letters, from left to right; other glyphs are '?'.
    [[nodiscard]] std::string line(std::size_t k) const
    {
        std::string shown;
        for (const placed_glyph& g : run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count))
            shown += g.id < 0x80 ? static_cast<char>(g.id) : '?';
        return shown;
    }
    [[nodiscard]] std::vector<std::string> lines() const
    {
        std::vector<std::string> all;
        for (std::size_t k = 0; k < run.lines.size(); ++k) all.push_back(line(k));
        return all;
    }
};

using line_texts = std::vector<std::string>;

}  // namespace

namespace {

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
    toy_shaper font;
    paragraph<toy_shaper> words{font};
    glyph_run run;
    REQUIRE(words.set("one two"));
    REQUIRE(words.lay_out({.width = 2.0}, run));
    paragraph<toy_shaper> others{std::move(words)};
    CHECK(others.lines().size() == 2);
    for (const wrap_mode wrap : {wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme}) {
        REQUIRE(words.lay_out({.width = 1.0, .wrap = wrap, .ellipsis = ".."}, run));
        CHECK(run.glyphs.empty());
        CHECK(words.lines().empty());
        CHECK(words.widths().widest == 0.0);
    }
    REQUIRE(words.set("one two"));
    REQUIRE(words.lay_out({.width = 2.0}, run));
    CHECK(words.lines().size() == 2);
}

TEST_CASE("a paragraph's text fills lines of a width", "[paragraph]")
{
    laid p{"one two three", {.width = 4.0}};
    CHECK(p.lines() == line_texts{"one two ", "three"});
    CHECK(p.run.lines[0].advance == 3250.0);
    CHECK(p.run.lines[1].origin == point{0.0, -1000.0});
    CHECK(p.run.units_per_em == 1000.0);
    p.again({.width = 3.2});
    CHECK(p.lines() == line_texts{"one ", "two ", "three"});
    p.again({.width = 2.0});
    CHECK(p.lines() == line_texts{"one ", "two ", "thre", "e"});
    p.again({.width = 2.0, .wrap = wrap_mode::word});
    CHECK(p.lines() == line_texts{"one ", "two ", "three"});
    p.again({.width = 2.0, .wrap = wrap_mode::none});
    CHECK(p.lines() == line_texts{"one two three"});
    p.again({.width = 2.6, .wrap = wrap_mode::grapheme});
    CHECK(p.lines() == line_texts{"one t", "wo th", "ree"});
    p.again({});
    CHECK(p.lines() == line_texts{"one two three"});
}

TEST_CASE("every cluster is drawn exactly once, at any width and way of wrapping", "[paragraph]")
{
    laid p{mixed};
    std::map<cluster_id, int> shaped;
    for (std::uint32_t c = 0; c < p.words.shaped().cluster_count(); ++c)
        if (p.words.shaped().cluster(c).glyph_count != 0) shaped[p.words.shaped().cluster(c).first] = 0;
    for (const wrap_mode wrap : {wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme})
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
    REQUIRE(p.lines() == line_texts{"????", "??"});
    std::vector<cluster_id> clusters;
    for (const placed_glyph& g : p.run.glyphs) clusters.push_back(g.cluster);
    CHECK(clusters == std::vector<cluster_id>{2, 2, 1, 0, 4, 3});
    CHECK(p.run.glyphs[0].id == 0x2010);
    CHECK(p.run.glyphs[3].origin.x == p.run.lines[0].origin.x + 1000.0);
}

TEST_CASE("no line ends between a space and a mark upon it", "[paragraph]")
{
    CHECK(laid{u"ab \u0301cd", {.width = 1.2, .wrap = wrap_mode::word}}.lines() == line_texts{"ab ?cd"});
}

TEST_CASE("a text that ends with a break has an empty last line, however it is wrapped", "[paragraph]")
{
    for (const wrap_mode wrap : {wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme}) {
        CHECK(laid{"ab\n", {.wrap = wrap}}.lines() == line_texts{"ab", ""});
        CHECK(laid{"ab\n\n", {.wrap = wrap}}.lines() == line_texts{"ab", "", ""});
    }
    CHECK(laid{"ab\n", {.width = 1.0, .indent = 2.0}}.lines() == line_texts{"a", "b", ""});
}

TEST_CASE("a layout does not depend on those before it", "[paragraph]")
{
    laid often{mixed};
    for (const double width : {30.0, 3.0, 0.1, 5.0, 2.0, 3.0}) {
        for (const wrap_mode wrap : {wrap_mode::word_or_grapheme, wrap_mode::grapheme, wrap_mode::word}) {
            const layout_options options{.width = width, .wrap = wrap, .ellipsis = ".."};
            often.again(options);
            const laid once{mixed, options};
            REQUIRE(often.run.glyphs.size() == once.run.glyphs.size());
            for (std::size_t i = 0; i < once.run.glyphs.size(); ++i) {
                CHECK(often.run.glyphs[i].id == once.run.glyphs[i].id);
                CHECK(often.run.glyphs[i].origin == once.run.glyphs[i].origin);
            }
        }
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
        right.again({.width = 4.0, .align = align});
        CHECK(right.run.lines[0].origin.x == boxed);
        CHECK(right.run.glyphs[0].origin.x == boxed);
        right.again({.align = align});
        CHECK(right.run.lines[0].origin.x == free);
        left.again({.width = 4.0, .align = align});
        CHECK(left.run.lines[0].origin.x == back);
        CHECK(left.run.glyphs[0].origin.x == back);
        left.again({.align = align});
        CHECK(left.run.lines[0].origin.x == back_free);
    }
}

TEST_CASE("white space at a line's end hangs beyond the width, on the side where the line ends", "[paragraph]")
{
    const laid right{"ab   cd", {.width = 1.0, .align = alignment::right}};
    CHECK(right.line(0) == "ab   ");
    CHECK(right.run.glyphs[1].origin.x == 500.0);
    CHECK(right.run.glyphs[2].origin.x == 1000.0);
    const laid left{u"\u05D0\u05D1   \u05D2", {.width = 1.0}};
    CHECK(left.run.lines[0].glyph_count == 5);
    CHECK(left.run.glyphs[0].origin.x == -750.0);
    CHECK(left.run.glyphs[3].origin.x == 0.0);
}

TEST_CASE("justified lines fill the width by their spaces, but for a paragraph's last", "[paragraph]")
{
    const laid p{"a b cd e f\ng hi", {.width = 3.2, .align = alignment::justify}};
    CHECK(p.lines() == line_texts{"a b cd ", "e f", "g hi"});
    CHECK(p.run.lines[0].advance == 3200.0);
    CHECK(p.run.lines[1].advance == 1250.0);
    CHECK(p.run.lines[2].advance == 1750.0);
    CHECK(p.run.glyphs[2].origin.x - p.run.glyphs[0].origin.x == p.run.glyphs[4].origin.x - p.run.glyphs[2].origin.x);
}

TEST_CASE("first lines of paragraphs are indented at their start", "[paragraph]")
{
    const laid p{"ab cd\nef\xE2\x80\xA8gh", {.width = 1.5, .indent = 0.25}};
    CHECK(p.lines() == line_texts{"ab ", "cd", "ef", "gh"});
    for (const auto& [k, x] : {std::pair{0, 250.0}, {1, 0.0}, {2, 250.0}, {3, 0.0}})
        CHECK(p.run.lines[static_cast<std::size_t>(k)].origin.x == x);
    const laid left{u"\u05D0\u05D1", {.width = 2.0, .indent = 0.25}};
    CHECK(left.run.lines[0].origin.x == 750.0);
}

TEST_CASE("tabs lead to stops, in the direction of the paragraph", "[paragraph]")
{
    const double stops[] = {0.75};
    const laid p{"a\tb\tc", {.tab_stops = stops}};
    CHECK(p.run.glyphs[1].origin.x == 750.0);
    CHECK(p.run.glyphs[2].origin.x == 2000.0);
    const laid left{u"\u05D0\tb", {.width = 4.0, .tab_stops = stops}};
    CHECK(left.run.glyphs[1].origin.x == 3500.0);
    CHECK(left.run.glyphs[0].origin.x == 4000.0 - 750.0 - 500.0);
    CHECK(laid{"AV\tb"}.run.glyphs[2].origin.x == 2000.0);  // 1000 is nearer than half a digit
    const laid none{"a\tb", {.tab_width = 0.0}};
    CHECK(none.run.glyphs[1].origin.x == 500.0);
}

TEST_CASE("soft hyphens show where a line ends and nowhere else", "[paragraph]")
{
    laid p{
        "ab\xC2\xAD"
        "cd\xC2\xAD"
        "ef",
        {.width = 1.6}};
    CHECK(p.run.lines.size() == 3);
    CHECK(p.run.lines[0].advance == 1500.0);
    CHECK(p.run.glyphs[p.run.lines[0].glyph_count - 1].id == 0x2010);
    p.again({});
    for (const placed_glyph& g : p.run.glyphs) CHECK(g.id != 0x2010);
    CHECK(p.run.lines[0].advance == 3000.0);
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

TEST_CASE("into the width that it was measured at a text fits, whatever is rounded", "[paragraph]")
{
    toy_shaper font;
    paragraph words{font};
    glyph_run run;
    for (int k = 1; k < 200; ++k) {
        REQUIRE(words.set("one two three\nfour and more words", {.letter_spacing = 0.01 * k}));
        REQUIRE(words.lay_out({.width = words.widths().widest}, run));
        CHECK(run.lines.size() == 2);
        REQUIRE(words.lay_out({.width = words.widths().narrowest}, run));
        std::size_t lines = run.lines.size();
        CHECK(lines == 7);
        double width = 0.0;
        for (const text_line& line : run.lines) width = line.advance > width ? line.advance : width;
        REQUIRE(words.lay_out({.width = width / font.units_per_em(), .max_lines = 7, .ellipsis = ".."}, run));
        CHECK(run.lines.size() == lines);
        for (const placed_glyph& g : run.glyphs) CHECK(g.id != '.');
    }
}

TEST_CASE("what is dropped leaves an ellipsis at the end, in the middle or at the start", "[paragraph]")
{
    laid p{"one two three\nfour", {.width = 4.0, .max_lines = 1, .ellipsis = ".."}};
    CHECK(p.lines() == line_texts{"one tw.."});
    p.again({.width = 3.3, .max_lines = 2, .ellipsis = ".."});
    CHECK(p.lines() == line_texts{"one two ", "thre.."});
    p.again({.width = 3.3, .max_lines = 2});
    CHECK(p.lines() == line_texts{"one two ", "three"});
    p.again({.width = 4.0, .wrap = wrap_mode::none, .ellipsis = ".."});
    CHECK(p.lines() == line_texts{"one tw..", "four"});
    p.again({.width = 4.0, .wrap = wrap_mode::none, .ellipsis = "..", .elide = ellipsis_place::start});
    CHECK(p.lines() == line_texts{"..three", "four"});
    p.again({.width = 4.0, .wrap = wrap_mode::none, .ellipsis = "..", .elide = ellipsis_place::middle});
    CHECK(p.lines() == line_texts{"one..ree", "four"});
    p.again({.width = 9.0, .wrap = wrap_mode::none, .ellipsis = ".."});
    CHECK(p.lines() == line_texts{"one two three", "four"});
    p.again({.width = 0.7, .wrap = wrap_mode::none, .ellipsis = ".."});
    CHECK(p.line(0) == "..");  // nothing else fits, nor does it
    for (const char* end : {"\n", "\n\n", "\n \n"}) {
        const laid empty{std::string{"one"} + end, {.max_lines = 1, .ellipsis = ".."}};
        CHECK(empty.line(0) == "one");  // nothing is dropped but empty lines
    }
    const laid left{u"\u05D0\u05D1\u05D2", {.width = 2.0, .wrap = wrap_mode::none, .ellipsis = ".."}};
    CHECK(left.line(0) == "???");
    const laid cut{u"\u05D0\u05D1\u05D2\u05D3\u05D4", {.width = 2.0, .wrap = wrap_mode::none, .ellipsis = ".."}};
    CHECK(cut.line(0) == "..??");
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
    laid nothing{""};
    REQUIRE(nothing.run.lines.size() == 1);
    CHECK(nothing.run.glyphs.empty());
    CHECK(nothing.words.widths().widest == 0.0);
    const laid spaces{"   ", {.width = 0.1, .align = alignment::right}};
    REQUIRE(spaces.run.lines.size() == 1);
    CHECK(spaces.run.lines[0].advance == 0.0);
    CHECK(spaces.run.lines[0].origin.x == 100.0);
    const laid breaks{"\r\n\n\xE2\x80\xA8"};
    CHECK(breaks.run.lines.size() == 4);
    const laid wide{"wide", {.width = 0.1}};
    CHECK(wide.lines() == line_texts{"w", "i", "d", "e"});
    const laid tabs{"\t\t", {.width = 0.5}};
    CHECK(tabs.run.lines.size() == 1);
}

TEST_CASE("information separators end paragraphs, and are not drawn", "[paragraph]")
{
    const laid p{
        "ab\x1C"
        "cd\x1D\x1E",
        {.indent = 0.5}};
    CHECK(p.lines() == line_texts{"ab", "cd", "", ""});
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

TEST_CASE("widths tell how narrow and how wide a text may be", "[paragraph]")
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
    CHECK(p.lines() == line_texts{"one ", "two"});
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
        CHECK(column.run.glyph_styles[down.glyph_style].map == (upright ? affine{} : quarter_turn));
        const text_place here = column.words.laid().caret_from({0.0, down.origin.y / 1000.0 - 0.001});
        const text_place there = line.words.laid().caret_from({along.origin.x / 1000.0 + 0.001, 0.0});
        CHECK(here.unit == there.unit);
        CHECK(here.inside);
    }
}

TEST_CASE("a column whose first letter is Hebrew is read upwards, unless all of it is upright", "[paragraph]")
{
    shape_options how{.direction = direction::top_to_bottom};
    CHECK(laid(u"\u05D0\u05D1 ab", {.align = alignment::left}, how).line(0) == "ab ??");
    how.columns.latin = column_latin::upright;
    const laid upright{u"\u05D0\u05D1 ab", {}, how};
    CHECK(upright.line(0) == "?? ab");
    CHECK(upright.run.glyphs[0].id == 0x05D0);
}

TEST_CASE("a combined number is one grapheme, an em high, and no line ends in it", "[paragraph]")
{
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 3;
    laid p{u"\u4E16123\u754C", {}, how};
    CHECK(p.run.lines[0].advance == 2000.0);
    const affine squeezed = p.run.glyph_styles[p.run.glyphs[1].glyph_style].map;
    CHECK(squeezed == affine{.xx = 1000.0 / 1500.0});
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

TEST_CASE("a style that ends within a combined number is that of all of it, and is counted", "[paragraph][styles]")
{
    toy_shaper font;
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 2;
    for (const std::uint32_t digit : {1u, 2u}) {
        paragraph words{font};
        const style_span span[] = {{digit, digit + 1, {.style = style_id{5}}}};
        how.styles = span;
        glyph_run run;
        REQUIRE(words.set(u"\u4E1612\u754C", how));
        REQUIRE(words.lay_out({}, run));
        CHECK(words.shaped().styles.moved() == 1);
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(run.glyph_styles[run.glyphs[i].glyph_style].style == style_id{i == 1 || i == 2 ? 5u : 0u});
    }
}

TEST_CASE("a paragraph refuses what makes no sense, and is empty then", "[paragraph]")
{
    toy_shaper font;
    paragraph words{font};
    glyph_run run;
    REQUIRE(words.set("ab"));
    CHECK(words.lay_out({.width = 0.0}, run) == error::bad_option);
    CHECK(run.lines.empty());
    CHECK(words.lines().empty());
    REQUIRE(words.lay_out({}, run));
    CHECK(words.set("ab", {.letter_spacing = std::numeric_limits<double>::quiet_NaN()}) == error::bad_option);
    const error refused = words.set("ab!").error();
    CHECK(refused == error::font_library_failed);
    CHECK(refused.cluster == 2);
    REQUIRE(words.lay_out({}, run));
    CHECK(run.glyphs.empty());
    CHECK(run.lines.empty());
    CHECK(words.widths().widest == 0.0);
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
    laid p{u"ab \u0E20\u0E32\u0E29\u0E32 cd \u0E9E\u0EB2", {.width = 3.0}};
    CHECK(p.run.unbroken == 2);
    CHECK(p.run.first_unbroken == 3);
    p.again({.width = 3.0, .wrap = wrap_mode::word});
    CHECK(p.run.unbroken == 2);
    p.again({});
    CHECK(p.run.unbroken == 0);
    for (const wrap_mode wrap : {wrap_mode::none, wrap_mode::grapheme}) {
        p.again({.width = 3.0, .wrap = wrap});
        CHECK(p.run.unbroken == 0);
        CHECK(p.run.first_unbroken == no_cluster);
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
    const auto use = [](memory source) {
        toy_shaper font;
        paragraph<toy_shaper> words{font, source};
        glyph_run run{source};
        error e = words.set(mixed).error();
        if (!e) e = words.lay_out({.width = 1.0, .wrap = wrap_mode::word_or_grapheme, .ellipsis = ".."}, run).error();
        if (!e) e = words.lay_out({.width = 3.0, .max_lines = 2, .ellipsis = ".."}, run).error();
        if (e) CHECK(e == error::out_of_memory);
        return e;
    };
    test::counting_memory counted;
    REQUIRE_FALSE(use(counted.source()));
    for (std::size_t at = 1; at <= counted.requests; ++at) {
        test::counting_memory failing{.fail_at = at};
        CHECK(use(failing.source()) == error::out_of_memory);
    }
}

TEST_CASE("a layout for which memory fails leaves nothing behind for the next one", "[paragraph]")
{
    const layout_options options{.width = 1.0, .ellipsis = ".."};
    const laid fresh{mixed, options};
    toy_shaper font;
    test::counting_memory counted;
    {
        paragraph<toy_shaper> words{font, counted.source()};
        glyph_run run;
        REQUIRE(words.set(mixed));
        counted.requests = 0;
        REQUIRE(words.lay_out(options, run));
    }
    const std::size_t all = counted.requests;
    REQUIRE(all > 2);
    for (std::size_t at = 1; at <= all; ++at) {
        test::counting_memory failing;
        paragraph<toy_shaper> words{font, failing.source()};
        glyph_run run;
        REQUIRE(words.set(mixed));
        failing.fail_at = failing.requests + at;
        CHECK(words.lay_out(options, run) == error::out_of_memory);
        failing.fail_at = 0;
        for (int k = 0; k < 2; ++k) {
            REQUIRE(words.lay_out({.width = 2.0}, run));
            REQUIRE(words.lay_out(options, run));
        }
        REQUIRE(run.glyphs.size() == fresh.run.glyphs.size());
        bool same_glyphs = true;
        for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
            const placed_glyph &a = run.glyphs[i], &b = fresh.run.glyphs[i];
            same_glyphs = same_glyphs && a.id == b.id && a.cluster == b.cluster && a.origin == b.origin;
        }
        CHECK(same_glyphs);
    }
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
    std::vector<double> a_unit;
    for (const std::size_t size : {1000u, 6000u}) {
        std::string text;
        while (text.size() < size) text += "abcd efghijk lmnop qr ";
        toy_shaper font;
        font.all_unsafe = true;
        paragraph words{font};
        glyph_run run;
        REQUIRE(words.set(text));
        for (const wrap_mode wrap : {wrap_mode::word, wrap_mode::grapheme})
            REQUIRE(words.lay_out({.width = 9.0, .wrap = wrap}, run));
        CHECK(run.glyphs.size() == text.size());
        a_unit.push_back(static_cast<double>(font.units) / static_cast<double>(text.size()));
    }
    CHECK(a_unit[1] < 1.05 * a_unit[0]);
}

TEST_CASE("styles say how parts of a column stand", "[paragraph][columns][styles]")
{
    toy_shaper font;
    paragraph words{font};
    glyph_run run;
    const style_span spans[] = {{0, 1, {.column = column_style::sideways}},
                                {2, 4, {.column = column_style::upright}},
                                {4, 8, {.size = 2.0, .column = column_style::combined}}};
    REQUIRE(words.set(u"\u4E16abc2024", {.direction = direction::top_to_bottom, .styles = spans}));
    REQUIRE(words.lay_out({}, run));
    REQUIRE(run.glyphs.size() == 8);
    const auto map = [&](std::size_t i) { return run.glyph_styles[run.glyphs[i].glyph_style].map; };
    CHECK(map(0) == quarter_turn);
    CHECK(map(1) == quarter_turn);
    CHECK(map(2) == affine{});
    CHECK(map(3) == affine{});
    for (std::size_t i = 4; i < 8; ++i)
        CHECK(map(i) == affine{.xx = 1.0, .yy = 2.0});  // four halves in one em of size 2
    CHECK(run.lines[0].advance == 4 * 500.0 + 2000.0);
}
