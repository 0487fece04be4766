// SPDX-License-Identifier: MIT
#include "support/each_failure.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/unicode/utf.hpp>

#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::toy_shaper;

glyph_run set(text_view text, const layout_options& options = {}, const shape_options& how = {}, toy_shaper font = {})
{
    glyph_run run;
    REQUIRE(layout(font, text, how, options, run));
    return run;
}

}  // namespace

TEST_CASE("a text has one line more than it has breaks, and breaks leave no glyph", "[layout]")
{
    struct expected {
        const char* text;
        std::vector<std::uint32_t> glyphs;  // of each line
    };
    for (const auto& [text, glyphs] : {expected{"", {0}},
                                       {"ab", {2}},
                                       {"\n", {0, 0}},
                                       {"ab\ncd", {2, 2}},
                                       {"ab\r\ncd", {2, 2}},
                                       {"a\rb", {1, 1}},
                                       {"a\n\nb\n", {1, 0, 1, 0}},
                                       {"a\xE2\x80\xA8"
                                        "b",
                                        {1, 1}},
                                       {"\n\r", {0, 0, 0}}}) {
        INFO(text);
        const glyph_run run = set(text);
        REQUIRE(run.lines.size() == glyphs.size());
        std::uint32_t first = 0;
        for (std::size_t i = 0; i < glyphs.size(); ++i) {
            CHECK(run.lines[i].first_glyph == first);
            CHECK(run.lines[i].glyph_count == glyphs[i]);
            CHECK(run.lines[i].advance == 500.0 * glyphs[i]);
            first += glyphs[i];
        }
        CHECK(run.glyphs.size() == first);
        for (const placed_glyph& g : run.glyphs) CHECK((g.id >= 'a' && g.id <= 'd'));
    }
}

TEST_CASE("baselines are the font's line distance times the spacing apart, downwards from 0", "[layout]")
{
    const double spacing = GENERATE(1.0, 1.5, 0.0, -2.0);
    const glyph_run run = set("a\nb\n\nc", {.line_spacing = spacing});
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(run.lines[i].origin == point{0.0, -1000.0 * spacing * static_cast<double>(i)});
    CHECK(run.glyphs[2].origin == point{0.0, -3000.0 * spacing});
    CHECK(run.units_per_em == 1000.0);
}

TEST_CASE("a font without line metrics is set one em apart", "[layout]")
{
    const glyph_run run = set("a\nb", {}, {}, toy_shaper{{0.0, 0.0, 0.0}});
    CHECK(run.lines[1].origin == point{0.0, -1000.0});
}

TEST_CASE("every line is aligned to x = 0 by itself, every column to y = 0, its glyphs with it", "[layout]")
{
    for (const auto& [align, at] :
         {std::pair{alignment::left, 0.0}, {alignment::centre, 0.5}, {alignment::right, 1.0}}) {
        const glyph_run run = set("abc\nd", {.align = align});
        CHECK(run.lines[0].origin == point{-1500.0 * at, 0.0});
        CHECK(run.lines[1].origin == point{-500.0 * at, -1000.0});
        CHECK(run.glyphs[2].origin == point{1000.0 - 1500.0 * at, 0.0});
        CHECK(run.glyphs[3].origin == point{-500.0 * at, -1000.0});

        const glyph_run down =
            set("abc\nd", {.align = align},
                {.direction = direction::top_to_bottom, .columns = {.latin = column_latin::upright}});
        CHECK(down.lines[0].advance == 1500.0);
        CHECK(down.lines[0].origin == point{0.0, 1500.0 * at});
        CHECK(down.lines[1].origin == point{-1250.0, 500.0 * at});  // to the left, by line_reach_of()
        CHECK(down.glyphs[2].origin == point{0.0, 1500.0 * at - 1000.0});
    }
}

TEST_CASE("clusters count units of the whole text in its own encoding", "[layout]")
{
    const auto clusters = [](text_view text) {
        std::vector<cluster_id> all;
        for (const placed_glyph& g : set(text).glyphs) all.push_back(g.cluster);
        return all;
    };
    CHECK(clusters("\xC3\xA9\n\xF0\x9F\x98\x80z") == std::vector<cluster_id>{0, 3, 7});
    CHECK(clusters(u"\u00E9\n\U0001F600z") == std::vector<cluster_id>{0, 2, 4});
    CHECK(clusters(u8"é\nz") == std::vector<cluster_id>{0, 3});
}

TEST_CASE("layout empties the run first, and leaves it empty on failure", "[layout]")
{
    toy_shaper font;
    glyph_run run = set("before\nthat");
    run.missing = 3;
    run.first_missing = 1;
    REQUIRE(layout(font, "x", {}, {}, run));
    CHECK(run.glyphs.size() == 1);
    CHECK(run.missing == 0);
    CHECK(run.first_missing == no_cluster);

    const error refused = layout(font, "ok\nnot!", {}, {}, run).error();
    CHECK(refused == error::font_library_failed);
    CHECK(refused.cluster == 6);
    CHECK(run.glyphs.empty());
    CHECK(run.lines.empty());
}

TEST_CASE("a line spacing that is no number is refused", "[layout]")
{
    toy_shaper font;
    glyph_run run;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()})
        CHECK(layout(font, "x", {}, {.line_spacing = bad}, run) == error::bad_option);
}

TEST_CASE("a text of 2^32 units is refused before it is read", "[layout]")
{
    toy_shaper font;
    glyph_run run;
    if constexpr (sizeof(std::size_t) > 4) {
        const char one = 'x';
        const std::string_view claimed{&one, static_cast<std::size_t>(std::uint64_t{1} << 32)};
        CHECK(layout(font, claimed, {}, {}, run) == error::too_large);
    }
}

TEST_CASE("layout reports a memory that gives nothing, wherever it stops", "[layout]")
{
    const std::string text = std::string(100, '\n') + "abc";
    const std::size_t needed = test::check_each_failure([&text](memory source) {
        toy_shaper font;
        glyph_run run{source};
        const error e = layout(font, text, {}, {}, run).error();
        CHECK(run.lines.empty() == bool(e));
        return e;
    });
    CHECK(needed > 1);
}

TEST_CASE("A plain_layout allocates nothing once it is warm", "[layout]")
{
    test::counting_memory counted;
    toy_shaper font;
    plain_layout lay_out{counted.source()};
    glyph_run run{counted.source()};
    REQUIRE(lay_out(font, u"some\nlines \u05D0\tof text", {}, {}, run));
    const std::size_t before = counted.requests;
    REQUIRE(lay_out(font, u"lines \tof\u05D0 text\nsome", {}, {}, run));
    CHECK(counted.requests == before);
}

TEST_CASE("Plain text refuses what needs a line breaker, by its name", "[layout]")
{
    toy_shaper font;
    glyph_run run;
    const auto refused = [&](const layout_options& options) {
        const error e = layout(font, "some words", {}, options, run).error();
        CHECK(e == error::needs_paragraph);
        return std::string{e.option};
    };
    CHECK(refused({.width = 5.0}) == "width");
    CHECK(refused({.ellipsis = "..."}) == "ellipsis");
    CHECK(layout(font, "a", {}, {.width = 0.0}, run) == error::bad_option);
    CHECK(layout(font, "a", {.letter_spacing = std::numeric_limits<double>::infinity()}, {}, run) == error::bad_option);

    // A box without wrapping aligns.
    REQUIRE(layout(font, "ab", {}, {.width = 5.0, .wrap = wrap_mode::none, .align = alignment::right}, run));
    CHECK(run.lines[0].origin == point{4000.0, 0.0});
}

TEST_CASE("A style changes its part of a plain text", "[layout]")
{
    const style_span spans[] = {{1, 2, {.size = 2.0, .decorations = decoration::underline, .style = style_id{7}}}};
    const glyph_run run = set("abc", {}, {.styles = spans});
    REQUIRE(run.glyphs.size() == 4);  // and a bar
    CHECK(run.glyph_styles[run.glyphs[1].glyph_style] ==
          glyph_style{.map = {.xx = 2.0, .yy = 2.0}, .style = style_id{7}});
    CHECK(run.glyphs[2].origin == point{1500.0, 0.0});
    CHECK(run.lines[0].advance == 2000.0);
}

TEST_CASE("A line knows how much white space hangs at its end", "[layout]")
{
    const style_span spans[] = {{0, 3, {.letter_spacing = -1.5}}, {3, 4, {.word_spacing = 2.0}}};
    toy_shaper font;
    glyph_run run;
    REQUIRE(layout(font, "abc ", {.styles = spans}, {}, run));  // letters that go back
    CHECK(run.lines[0].advance == 0.0);
    CHECK(run.lines[0].hanging == 2250.0);
    for (const char* text : {"ab", "ab  ", "\xD7\x90\xD7\x91 "}) {
        REQUIRE(layout(font, text, {}, {.indent = 0.7}, run));
        CHECK(run.lines[0].advance == 1000.0);
        CHECK(run.lines[0].hanging == (text[2] == ' ' ? 500.0 : text[2] == 0 ? 0.0 : 250.0));
    }
}
