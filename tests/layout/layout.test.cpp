// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "toy_shaper.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/unicode/utf.hpp>

#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::toy_shaper;

glyph_run set(text_view text, const layout_options& options = {}, direction d = direction::automatic,
              toy_shaper font = {})
{
    glyph_run run;
    shape_options how;
    how.direction = d;
    REQUIRE(layout(font, text, how, options, run));
    return run;
}

bool equal(point a, point b) { return a == b; }

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

TEST_CASE("the shaper sees every line whole and alone", "[layout]")
{
    toy_shaper font;
    glyph_run run;
    REQUIRE(layout(font, "one two\r\n\nthree", {}, {}, run));
    CHECK(font.seen == std::vector<std::string>{"one two", "three"});  // an empty line needs no shaping
}

TEST_CASE("baselines are the font's line distance times the spacing apart, downwards from 0", "[layout]")
{
    const double spacing = GENERATE(1.0, 1.5, 0.0, -2.0);
    const glyph_run run = set("a\nb\n\nc", {.line_spacing = spacing});
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(equal(run.lines[i].origin, {0.0, -1000.0 * spacing * static_cast<double>(i)}));
    CHECK(equal(run.glyphs[2].origin, {0.0, -3000.0 * spacing}));
    CHECK(run.units_per_em == 1000.0);
}

TEST_CASE("a font without line metrics is set one em apart", "[layout]")
{
    const glyph_run run = set("a\nb", {}, direction::automatic, toy_shaper{{0.0, 0.0, 0.0}});
    CHECK(equal(run.lines[1].origin, {0.0, -1000.0}));
}

TEST_CASE("every line is aligned to x = 0 by itself, its glyphs with it", "[layout]")
{
    const char* text = "abc\nd";
    for (const auto& [align, at] :
         {std::pair{alignment::left, 0.0}, {alignment::centre, 0.5}, {alignment::right, 1.0}}) {
        const glyph_run run = set(text, {.align = align});
        CHECK(equal(run.lines[0].origin, {-1500.0 * at, 0.0}));
        CHECK(equal(run.lines[1].origin, {-500.0 * at, -1000.0}));
        CHECK(equal(run.glyphs[2].origin, {1000.0 - 1500.0 * at, 0.0}));
        CHECK(equal(run.glyphs[3].origin, {-500.0 * at, -1000.0}));
    }
}

TEST_CASE("columns run down, the next to the left, aligned to y = 0", "[layout]")
{
    for (const auto& [align, at] :
         {std::pair{alignment::left, 0.0}, {alignment::centre, 0.5}, {alignment::right, 1.0}}) {
        const glyph_run run = set("abc\nd", {.align = align}, direction::top_to_bottom);
        CHECK(run.lines[0].advance == 1500.0);
        CHECK(equal(run.lines[0].origin, {0.0, 1500.0 * at}));
        CHECK(equal(run.lines[1].origin, {-1250.0, 500.0 * at}));  // line_reach_of()
        CHECK(equal(run.glyphs[2].origin, {0.0, 1500.0 * at - 1000.0}));
    }
}

TEST_CASE("a pen that went backwards makes a line of advance 0", "[layout]")
{
    toy_shaper font;
    font.advance = -10.0;
    const glyph_run run = set("ab", {.align = alignment::right}, direction::automatic, font);
    CHECK(run.lines[0].advance == 0.0);
    CHECK(equal(run.lines[0].origin, {0.0, 0.0}));
}

TEST_CASE("clusters count units of the whole text in its own encoding", "[layout]")
{
    const glyph_run eight = set("\xC3\xA9\n\xF0\x9F\x98\x80z");
    REQUIRE(eight.glyphs.size() == 3);
    CHECK(eight.glyphs[1].cluster == 3);
    CHECK(eight.glyphs[2].cluster == 7);

    const glyph_run sixteen = set(std::u16string_view{u"\u00E9\n\U0001F600z"});
    REQUIRE(sixteen.glyphs.size() == 3);
    CHECK(sixteen.glyphs[1].cluster == 2);
    CHECK(sixteen.glyphs[2].cluster == 4);

    const glyph_run typed = set(std::u8string_view{u8"é\nz"});
    CHECK(typed.glyphs[1].cluster == 3);
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
    CHECK(refused == error::needs_shaping);
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
    const std::string text(100, '\n');
    test::counting_memory counted;
    {
        toy_shaper font;
        glyph_run run{counted.source()};
        REQUIRE(layout(font, text + "abc", {}, {}, run));
    }
    const std::size_t needed = counted.requests;
    REQUIRE(needed > 1);
    for (std::size_t at = 1; at <= needed; ++at) {
        test::counting_memory failing{.fail_at = at};
        {
            toy_shaper font;
            glyph_run run{failing.source()};
            CHECK(layout(font, text + "abc", {}, {}, run) == error::out_of_memory);
            CHECK(run.lines.empty());
        }
        CHECK(failing.bytes_held == 0);
    }
}

TEST_CASE("layout allocates nothing once its run is warm", "[layout]")
{
    test::counting_memory counted;
    toy_shaper font;
    glyph_run run{counted.source()};
    REQUIRE(layout(font, "some\nlines of text", {}, {}, run));
    const std::size_t before = counted.requests;
    REQUIRE(layout(font, "lines of text\nsome", {}, {}, run));
    CHECK(counted.requests == before);
}
