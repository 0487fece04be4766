// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

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

template <class Font = test::toy_shaper>
std::vector<line_metrics> line_heights(text_view text, const std::vector<style_span>& spans,
                                       const layout_options& options = {})
{
    const test::laid_paragraph<Font> p{text, options, {.styles = spans}};
    std::vector<line_metrics> all;
    for (const laid_line& line : p.words.lines()) all.push_back(line.metrics);
    return all;
}

bool reaches(const line_metrics& m, double up, double down)
{
    return std::fabs(m.ascender - up) < 1e-9 && std::fabs(m.descender - down) < 1e-9;
}

}  // namespace

TEST_CASE("a line is as high as its largest letters, or as the font says", "[paragraph][styles]")
{
    const std::vector<style_span> large{{1, 2, {.size = 2.0}}, {6, 7, {.size = 0.5, .rise = 0.8}}};
    const auto lines = line_heights("abc\ndefg\nh", large);
    REQUIRE(lines.size() == 3);
    CHECK(reaches(lines[0], 1400.0, -400.0));
    CHECK(reaches(lines[1], 800.0 + 350.0, -200.0));
    CHECK(reaches(lines[2], 700.0, -200.0));
    for (const line_metrics& m : line_heights("abc\ndefg\nh", large, {.boxes = line_box::uniform}))
        CHECK(reaches(m, 700.0, -200.0));
    const auto empty = line_heights("a\n\nb", {{2, 3, {.size = 3.0}}});  // a line with nothing but its large end
    REQUIRE(empty.size() == 3);
    CHECK(reaches(empty[1], 2100.0, -600.0));
    CHECK(reaches(line_heights("", {})[0], 700.0, -200.0));
}

TEST_CASE("a line is as high as its faces", "[paragraph][styles]")
{
    const auto lines = line_heights<two_heights>("ab\nAb\nA", {});
    REQUIRE(lines.size() == 3);
    CHECK(reaches(lines[0], 700.0, -200.0));
    CHECK(reaches(lines[1], 900.0, -400.0));
    CHECK(reaches(lines[2], 900.0, -400.0));
    CHECK(reaches(line_heights<two_heights>("Ab", {}, {.boxes = line_box::uniform})[0], 700.0, -200.0));
}

TEST_CASE("baselines are as far apart as their lines ask for", "[paragraph][styles]")
{
    const style_span large[] = {{2, 3, {.size = 2.0}}};
    const test::laid_paragraph<> p{"a\nb\nc", {}, {.styles = large}};
    const auto lines = p.run.lines.view();
    REQUIRE(lines.size() == 3);
    CHECK(std::fabs(lines[1].origin.y - -(200.0 + 1400.0 + 150.0)) < 1e-9);
    CHECK(std::fabs(lines[2].origin.y - (lines[1].origin.y - (400.0 + 700.0 + 150.0))) < 1e-9);
    CHECK(std::fabs(p.laid().line_box(1).height() - 1.8) < 1e-9);
}
