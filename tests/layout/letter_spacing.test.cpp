// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "toy_shaper.hpp"

#include <typemesh/layout/layout.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::toy_shaper;

glyph_run laid_by(text_view text, const layout_options& options, direction d = direction::automatic)
{
    toy_shaper font;
    glyph_run run;
    shape_options how;
    how.direction = d;
    REQUIRE(layout(font, text, how, options, run));
    return run;
}

/// How far each glyph of a line stands from where it would without letter spacing, in em, along the line.
std::vector<double> shifts(text_view text, double spacing, direction d = direction::automatic)
{
    const glyph_run plain = laid_by(text, {}, d), spaced = laid_by(text, {.letter_spacing = spacing}, d);
    REQUIRE(plain.glyphs.size() == spaced.glyphs.size());
    std::vector<double> out;
    for (std::size_t i = 0; i < plain.glyphs.size(); ++i) {
        CHECK(plain.glyphs[i].id == spaced.glyphs[i].id);
        const point by = spaced.glyphs[i].origin - plain.glyphs[i].origin;
        const bool down = d == direction::top_to_bottom;
        CHECK((down ? by.x : by.y) == 0.0);
        out.push_back((down ? -by.y : by.x) / 1000.0);
    }
    CHECK(spaced.lines[0].advance - plain.lines[0].advance == 1000.0 * (out.empty() ? 0.0 : out.back()));
    return out;
}

const std::string hebrew = "\xD7\x90\xD7\x91\xD7\x92", arabic = "\xD8\xA8\xD9\x8A\xD8\xAA";

}  // namespace

TEST_CASE("n letters of a line have n - 1 distances between them", "[layout][letter_spacing]")
{
    const double spacing = GENERATE(0.25, 1.5, -0.125);
    const std::string text = GENERATE(std::string{"Hamburg"}, std::string{"a b"}, hebrew);
    const direction d = GENERATE(direction::automatic, direction::top_to_bottom);
    const std::vector<double> by = shifts(text, spacing, d);
    for (std::size_t i = 0; i < by.size(); ++i) CHECK(by[i] == spacing * static_cast<double>(i));
    CHECK(shifts("", spacing, d).empty());
}

TEST_CASE("a letter keeps its marks, and what is not drawn takes no distance", "[layout][letter_spacing]")
{
    CHECK(shifts("a\xCC\x81\xCC\xA3z", 0.25) == std::vector<double>{0.0, 0.0, 0.0, 0.25});
    // a word joiner, a soft hyphen; in front, between and behind
    CHECK(shifts("\xE2\x81\xA0"
                 "a\xC2\xADz\xE2\x81\xA0",
                 0.25) == std::vector<double>{0.0, 0.0, 0.0, 0.25, 0.25});
}

TEST_CASE("letters that are written joined stay together, their words do not", "[layout][letter_spacing]")
{
    CHECK(shifts(arabic, 0.25) == std::vector<double>{0.0, 0.0, 0.0});
    CHECK(shifts(arabic + " " + arabic, 0.25) == std::vector<double>{0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 0.5});
    CHECK(is_written_joined(0x0628));
    CHECK(is_written_joined(0x07CA));
    CHECK(is_written_joined(0x1820));
    CHECK(is_written_joined(0x1E900));
    CHECK_FALSE(is_written_joined('a'));
    CHECK_FALSE(is_written_joined(0x05D0));
    CHECK_FALSE(is_written_joined(0xFEFF));
    CHECK_FALSE(is_written_joined(0x4E00));
}

TEST_CASE("each segment between tabs is spaced by itself, and stops stay where they are", "[layout][letter_spacing]")
{
    const layout_options narrow{.letter_spacing = 0.1};
    const glyph_run run = laid_by("abc\tdef", narrow);  // 1500 + 2 x 100 units, then a stop after each 2000
    CHECK(run.glyphs[2].origin == point{1200.0, 0.0});
    CHECK(run.glyphs[3].origin == point{2000.0, 0.0});
    CHECK(run.glyphs[5].origin == point{3200.0, 0.0});
    const glyph_run wide = laid_by("abc\tdef", {.letter_spacing = 0.5});  // 2500 units
    CHECK(wide.glyphs[3].origin == point{4000.0, 0.0});
}

TEST_CASE("spaced lines are aligned by their new length", "[layout][letter_spacing]")
{
    const glyph_run run = laid_by("abc\nz", {.align = alignment::right, .letter_spacing = 0.25});
    CHECK(run.lines[0].advance == 2000.0);
    CHECK(run.glyphs[0].origin == point{-2000.0, 0.0});
    CHECK(run.glyphs[2].origin == point{-500.0, 0.0});
    CHECK(run.lines[1].advance == 500.0);
    CHECK(laid_by("abc", {.letter_spacing = -5.0}).lines[0].advance == 0.0);
}

TEST_CASE("a shaper is told to leave out ligatures where letters are spaced, and nowhere else",
          "[layout][letter_spacing]")
{
    toy_shaper font;
    glyph_run run;
    REQUIRE(layout(font, "a\tb", {}, {.letter_spacing = 0.1}, run));
    CHECK(std::count(font.ligatures.begin(), font.ligatures.end(), false) == 2);  // and the tab's space, of any kind
    font.ligatures.clear();
    REQUIRE(layout(font, "a\tb", {}, {}, run));
    CHECK(std::count(font.ligatures.begin(), font.ligatures.end(), false) == 0);
}

TEST_CASE("a letter spacing that is no number is refused by its name", "[layout][letter_spacing]")
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        toy_shaper font;
        glyph_run run;
        const error e = layout(font, "x", {}, {.letter_spacing = bad}, run).error();
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option} == "letter_spacing");
    }
}
