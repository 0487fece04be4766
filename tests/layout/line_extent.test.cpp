// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/paragraph.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// The toy font with a second face, for capitals, that is higher and hangs lower.
struct two_heights : test::toy_shaper {
    static std::uint32_t face_count() noexcept { return 2; }
    using toy_shaper::metrics;
    line_metrics metrics(direction, std::uint32_t face) const noexcept
    {
        return face == 0 ? lines : line_metrics{900.0, -400.0, 0.0};
    }
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
    {
        const std::size_t before = glyphs.size();
        if (error e = toy_shaper::shape(text, item, how, glyphs)) return e;
        for (shaped_glyph& g : glyphs.view().subspan(before)) g.face = g.id >= 'A' && g.id <= 'Z' ? 1 : 0;
        return {};
    }
};

template <class Font>
std::vector<line_metrics> line_heights(Font& font, text_view text, const std::vector<style_span>& spans,
                                       const layout_options& options = {})
{
    paragraph<Font> words{font};
    REQUIRE(words.set(text, {.styles = spans}));
    glyph_run run;
    REQUIRE(words.lay_out(options, run));
    std::vector<line_metrics> all;
    for (const laid_line& line : words.lines()) all.push_back(line.metrics);
    return all;
}

bool reaches(const line_metrics& m, double up, double down)
{
    return std::fabs(m.ascender - up) < 1e-9 && std::fabs(m.descender - down) < 1e-9;
}

}  // namespace

TEST_CASE("a line is as high as its largest letters, or as the font says", "[paragraph][styles]")
{
    test::toy_shaper font;
    const std::vector<style_span> large{{1, 2, {.size = 2.0}}, {6, 7, {.size = 0.5, .rise = 0.8}}};
    const auto lines = line_heights(font, "abc\ndefg\nh", large);
    REQUIRE(lines.size() == 3);
    CHECK(reaches(lines[0], 1400.0, -400.0));
    CHECK(reaches(lines[1], 800.0 + 350.0, -200.0));
    CHECK(reaches(lines[2], 700.0, -200.0));
    for (const line_metrics& m : line_heights(font, "abc\ndefg\nh", large, {.boxes = line_box::uniform}))
        CHECK(reaches(m, 700.0, -200.0));
    const auto empty = line_heights(font, "a\n\nb", {{2, 3, {.size = 3.0}}});  // a line with nothing but its large end
    REQUIRE(empty.size() == 3);
    CHECK(reaches(empty[1], 2100.0, -600.0));
    CHECK(reaches(line_heights(font, "", {})[0], 700.0, -200.0));
}

TEST_CASE("a line is as high as its faces", "[paragraph][styles]")
{
    two_heights font;
    const auto lines = line_heights(font, "ab\nAb\nA", {});
    REQUIRE(lines.size() == 3);
    CHECK(reaches(lines[0], 700.0, -200.0));
    CHECK(reaches(lines[1], 900.0, -400.0));
    CHECK(reaches(lines[2], 900.0, -400.0));
    CHECK(reaches(line_heights(font, "Ab", {}, {.boxes = line_box::uniform})[0], 700.0, -200.0));
}

TEST_CASE("baselines are as far apart as their lines ask for", "[paragraph][styles]")
{
    test::toy_shaper font;
    paragraph<test::toy_shaper> words{font};
    const style_span large[] = {{2, 3, {.size = 2.0}}};
    REQUIRE(words.set("a\nb\nc", {.styles = large}));
    glyph_run run;
    REQUIRE(words.lay_out({}, run));
    REQUIRE(run.lines.size() == 3);
    CHECK(std::fabs(run.lines[1].origin.y - -(200.0 + 1400.0 + 150.0)) < 1e-9);
    CHECK(std::fabs(run.lines[2].origin.y - (run.lines[1].origin.y - (400.0 + 700.0 + 150.0))) < 1e-9);
    CHECK(std::fabs(words.laid().line_box(1).height() - 1.8) < 1e-9);
}
