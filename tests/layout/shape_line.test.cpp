// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

double advance_of(char32_t c) { return c == ' ' ? 250.0 : 300.0 + 10.0 * static_cast<double>(c % 32); }

/// Every code point is a glyph of that number; '?' and the space are missing. Lines are set in one direction, that of
/// their letters where none is asked for; letters of both are refused, and so are numbers in lines to the left.
struct one_way_shaper {
    double space = advance_of(' ');
    std::vector<direction> asked{};

    double units_per_em() const noexcept { return 1000.0; }
    line_metrics metrics(direction) const noexcept { return {700.0, -200.0, 100.0}; }
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& how,
                        glyph_run& run) noexcept
    {
        asked.push_back(how.direction);
        const line_reading found = read_line(text, first, last);
        const bool down = how.direction == direction::top_to_bottom;
        const bool right = found.to_the_right != line_reading::nowhere;
        const bool left = found.to_the_left != line_reading::nowhere;
        if (!down && right && left)
            return error{error::needs_shaping}.at(
                no_glyph, static_cast<cluster_id>((std::max)(found.to_the_right, found.to_the_left)));
        const std::size_t number = find_number(text, first, last);
        if (!down && left && number != line_reading::nowhere)
            return error{error::needs_shaping}.at(no_glyph, static_cast<cluster_id>(number));
        const bool neutral = !left && !right && number == line_reading::nowhere;
        const bool leftward = !down && (left || (neutral && how.direction == direction::right_to_left));

        std::vector<code_point> characters;
        std::vector<cluster_id> places;
        for (std::size_t i = first; i < last; i = characters.back().next) {
            characters.push_back(decode(text, i, last));
            places.push_back(static_cast<cluster_id>(i));
        }
        if (leftward) {
            std::reverse(characters.begin(), characters.end());
            std::reverse(places.begin(), places.end());
        }
        double pen = 0.0;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const char32_t c = characters[i].value;
            const bool missing = c == '?' || c == ' ';
            run.missing += missing ? 1 : 0;
            if (missing && places[i] < run.first_missing) run.first_missing = places[i];
            const point at = down ? point{0.0, -pen} : point{pen, 0.0};
            const placed_glyph g{static_cast<glyph_id>(c), places[i], at, missing};
            if (!run.glyphs.push_back(g)) return error::out_of_memory;
            pen += c == ' ' ? space : advance_of(c);
        }
        return down ? point{0.0, -pen} : point{pen, 0.0};
    }
};
static_assert(shaper<one_way_shaper>);

/// One line, from an empty run.
struct line_set {
    glyph_run run;
    point way;
};

line_set set(text_view text, double tab_width = 4.0, direction d = direction::automatic, one_way_shaper font = {})
{
    line_set made;
    shape_options how;
    how.direction = d;
    const auto way = shape_line(font, text, 0, text.size(), how, {.tab_width = tab_width}, made.run);
    REQUIRE(way);
    made.way = *way;
    return made;
}

/// Where a line's characters should stand: the pen before each, from the line's start, in the order of the text.
std::vector<double> pens(const std::u32string& text, double stop, double& end)
{
    std::vector<double> out;
    end = 0.0;
    for (const char32_t c : text) {
        if (c == '\t') {
            double next = 0.0;
            while (next <= end) next += stop;
            end = next - end < advance_of('0') / 2 ? next + stop : next;
        } else {
            out.push_back(end);
            end += advance_of(c);
        }
    }
    return out;
}

std::string utf8(const std::u32string& text)
{
    std::string out;
    for (const char32_t c : text) {
        if (c < 0x80)
            out += static_cast<char>(c);
        else
            out += {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
    }
    return out;
}

const std::u32string samples[] = {U"a\tb",   U"\tab",      U"ab\t",     U"\t",
                                  U"\t\t\t", U"a\t\tb\tc", U"a b\tc d", U"abcdefgh\tabc\t\tz\t"};

}  // namespace

TEST_CASE("a tab leads on to the next tab stop and leaves no glyph", "[layout][tab]")
{
    for (const std::u32string& text : samples) {
        for (const double width : {4.0, 8.0, 2.5, 0.25}) {
            double end = 0.0;
            const auto expected = pens(text, width * advance_of(' '), end);
            const line_set made = set(utf8(text), width);
            CHECK(made.way.x == Approx(end));
            CHECK(made.way.y == 0.0);
            REQUIRE(made.run.glyphs.size() == expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                CHECK(made.run.glyphs[i].origin.x == Approx(expected[i]));
                CHECK(made.run.glyphs[i].id == static_cast<glyph_id>(text[made.run.glyphs[i].cluster]));
                CHECK(made.run.glyphs[i].id != '\t');
            }
        }
    }
    CHECK(set("a\tb").run.missing == 0);  // not the tab, nor the space that was measured
    CHECK(set("a\t? b").run.missing == 2);
    CHECK(set("a\t? b").run.first_missing == 2);
}

TEST_CASE("a pen that stands on a tab stop goes on to the next", "[layout][tab]")
{
    CHECK(set("    \ta").run.glyphs[4].origin.x == 2000.0);
    CHECK(set("   \ta").run.glyphs[3].origin.x == 1000.0);
    CHECK(set("\t\ta").run.glyphs[0].origin.x == 2000.0);
}

TEST_CASE("a stop that is nearer than half a digit is passed over", "[layout][tab]")
{
    const double digit = advance_of('0'), space = advance_of(' ');
    for (double pen = 1.0; pen < 4.0 * digit; pen += 1.0) {  // a stop of one letter's width, a little more each time
        const double apart = advance_of('a') + pen;
        const line_set p = set("a\tb", apart / space);
        const double at = p.run.glyphs[1].origin.x;
        CHECK(std::fabs(at - (pen < digit / 2 ? 2.0 : 1.0) * apart) < 1e-6);
    }
}

TEST_CASE("columns of lines stand below one another", "[layout][tab]")
{
    one_way_shaper font;
    glyph_run run;
    REQUIRE(layout(font, "a\t1\nabc\t2\n\t3", {}, {.line_spacing = 1.0, .tab_width = 6.0}, run));
    std::vector<double> columns;
    for (const placed_glyph& g : run.glyphs)
        if (g.id >= '1' && g.id <= '3') columns.push_back(g.origin.x);
    CHECK(columns == std::vector<double>{1500.0, 1500.0, 1500.0});
}

TEST_CASE("a line to the left is the mirror image of the same line to the right", "[layout][tab]")
{
    for (const std::u32string& text : samples) {
        std::u32string hebrew = text;  // of letters with the same advances
        for (char32_t& c : hebrew)
            if (c > ' ') c = 0x05C0 + c % 32;
        for (const direction d : {direction::automatic, direction::right_to_left}) {
            const line_set right = set(utf8(text), 4.0, direction::left_to_right), left = set(utf8(hebrew), 4.0, d);
            if (d == direction::automatic && text.find_first_not_of(U"\t ") == std::u32string::npos) continue;
            CHECK(left.way.x == Approx(right.way.x));
            const std::size_t n = right.run.glyphs.size();
            REQUIRE(left.run.glyphs.size() == n);
            for (std::size_t i = 0; i < n; ++i) {
                const placed_glyph &r = right.run.glyphs[i], &l = left.run.glyphs[n - 1 - i];
                CHECK(l.id % 32 == r.id % 32);
                CHECK(l.origin.x == Approx(right.way.x - r.origin.x - advance_of(r.id)).margin(1e-9));
                if (i + 1 < n) CHECK(left.run.glyphs[i].origin.x < left.run.glyphs[i + 1].origin.x);
            }
        }
    }
}

TEST_CASE("columns of text run down from stop to stop", "[layout][tab]")
{
    for (const std::u32string& text : samples) {
        const line_set right = set(utf8(text)), down = set(utf8(text), 4.0, direction::top_to_bottom);
        CHECK(down.way == point{0.0, -right.way.x});
        REQUIRE(down.run.glyphs.size() == right.run.glyphs.size());
        for (std::size_t i = 0; i < right.run.glyphs.size(); ++i)
            CHECK(down.run.glyphs[i].origin == point{0.0, -right.run.glyphs[i].origin.x});
    }
}

TEST_CASE("between tabs letters are read in their own direction, and in the line's order", "[layout][tab]")
{
    const std::string hebrew = utf8(U"\u05D0\u05D1");
    const auto ids = [](const line_set& l) {
        std::u32string out;
        for (const placed_glyph& g : l.run.glyphs) out += static_cast<char32_t>(g.id);
        return out;
    };
    CHECK(ids(set("ab\t" + hebrew)) == U"ab\u05D1\u05D0");
    CHECK(ids(set(hebrew + "\tab")) == U"ab\u05D1\u05D0");
    CHECK(ids(set(hebrew + "\t42\t(;")) == U";(42\u05D1\u05D0");
    CHECK(ids(set("(;\tab")) == U"(;ab");
    for (const direction d : {direction::left_to_right, direction::right_to_left}) {
        const std::u32string expected = d == direction::left_to_right ? U"ab\u05D1\u05D0" : U"\u05D1\u05D0ab";
        CHECK(ids(set("ab\t" + hebrew, 4.0, d)) == expected);
    }
    CHECK(ids(set("ab\tcd", 4.0, direction::right_to_left)) == U"cdab");

    // Every segment's direction is the line's, for what is neither: a full stop behind Latin in a Hebrew line.
    for (const auto& [text, d] : {std::pair{hebrew + "\tab", direction::right_to_left},
                                  {"ab\t" + hebrew, direction::left_to_right},
                                  {"\t42\t", direction::automatic}}) {
        one_way_shaper font;
        glyph_run run;
        REQUIRE(shape_line(font, text, 0, text.size(), {}, {}, run));
        for (std::size_t k = 2; k < font.asked.size(); ++k) CHECK(font.asked[k] == d);  // the first are of " " and "0"
    }

    one_way_shaper font;
    glyph_run run;
    const std::string mixed = "ab\tc" + hebrew;
    const auto way = shape_line(font, mixed, 0, mixed.size(), {}, {}, run);
    REQUIRE_FALSE(way);
    CHECK(way.error() == error::needs_shaping);
    CHECK(way.error().cluster == 4);
}

TEST_CASE("a line without tabs is the shaper's own, and so is one whose tabs are characters", "[layout][tab]")
{
    struct line {
        const char* text;
        double tab_width;
    };
    for (const auto& [text, tab_width] : {line{"ab c", 4.0}, line{"ab c", 0.0}, line{"a\tb", 0.0}}) {
        one_way_shaper font;
        glyph_run run, expected;
        const std::size_t size = std::string{text}.size();
        const auto way = shape_line(font, text, 0, size, {}, {.tab_width = tab_width}, run);
        CHECK(font.asked.size() == 1);
        CHECK(*way == *font.shape(text, 0, size, {}, expected));
        CHECK(run.missing == expected.missing);
        REQUIRE(run.glyphs.size() == size);
        REQUIRE(expected.glyphs.size() == size);
        for (std::size_t i = 0; i < size; ++i) CHECK(run.glyphs[i].origin == expected.glyphs[i].origin);
    }
}

TEST_CASE("where a space moves the pen nowhere, a tab does not", "[layout][tab]")
{
    for (const double space : {0.0, -250.0}) {
        one_way_shaper font;
        font.space = space;
        CHECK(set("a\t\tb", 4.0, direction::automatic, font).run.glyphs[1].origin.x == advance_of('a'));
    }
}

TEST_CASE("tabs count in a line's length, by which it is aligned", "[layout][tab]")
{
    for (const auto align : {alignment::left, alignment::centre, alignment::right}) {
        one_way_shaper font;
        glyph_run run;
        REQUIRE(layout(font, "a\tb\t", {}, {.align = align}, run));
        CHECK(run.lines[0].advance == 2000.0);
        const double start = align == alignment::left ? 0.0 : align == alignment::centre ? -1000.0 : -2000.0;
        CHECK(run.lines[0].origin.x == start);
        CHECK(run.glyphs[1].origin.x == start + 1000.0);
    }
}

TEST_CASE("a width of tabs out of range is refused by its name", "[layout][tab]")
{
    one_way_shaper font;
    glyph_run run;
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const error e = layout(font, "a", {}, {.tab_width = bad}, run).error();
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option} == "tab_width");
    }
}
