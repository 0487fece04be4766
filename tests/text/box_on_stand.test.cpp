// SPDX-License-Identifier: MIT

// What stands beside letters, on a path: inline boxes, rubies, backgrounds and underlines.

#include "support/laid_paragraph.hpp"

#include <typemesh/bend/plane_path.hpp>
#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/paragraph/ruby_writer.hpp>
#include <typemesh/text/box_on_stand.hpp>
#include <typemesh/text/on_path.hpp>

#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

std::vector<glyph_stand> stands_of(const on_path& way, const glyph_run& run)
{
    std::vector<glyph_stand> all(run.glyphs.size());
    REQUIRE_FALSE(way.place(run, run.units_per_em, all.data()));
    return all;
}

bool near(point a, point b) { return std::fabs(a.x - b.x) < 1e-9 && std::fabs(a.y - b.y) < 1e-9; }

}  // namespace

TEST_CASE("a box on a ring touches it with the middle of its baseline, and along a line it stays", "[text]")
{
    const std::u16string text = u"ab\uFFFCcd";
    const inline_box box{.unit = 2, .width = 1.5, .ascent = 1.0, .descent = 0.25};
    const test::laid_paragraph<> p{text, {.align = alignment::left}, {.boxes = {&box, 1}}};
    for (const double radius : {1.0, 2.5}) {
        plane_path ring;
        ring.circle({0, 0}, radius);
        for (const path_side side : {path_side::left, path_side::right}) {
            const auto stands = stands_of({&ring, {.side = side}}, p.run);
            std::size_t boxes = 0;
            each_inline_box(p.run, [&](const inline_box_place& b) {
                ++boxes;
                const affine map = box_on_stand(b, p.run, stands[b.glyph]);
                const point foot = map({0.5, 0.2}), left = map({0.0, 0.2}), top = map({0.5, 1.0});  // 0.25 of 1.25
                CHECK(std::hypot(foot.x, foot.y) == Approx(radius));
                CHECK(std::hypot(left.x, left.y) == Approx(std::hypot(radius, 0.75)));  // on the tangent
                const bool outside = side == path_side::left;
                CHECK(std::hypot(top.x, top.y) == Approx(std::fabs(radius + (outside ? 1.0 : -1.0))));
                CHECK(map.xx * map.yy - map.xy * map.yx == Approx(1.5 * 1.25));  // rigid
            });
            CHECK(boxes == 1);
        }
    }
    plane_path line;
    line.move({0, 0});
    line.line({9, 0});
    const auto flat = stands_of({&line, {}}, p.run);
    each_inline_box(p.run, [&](const inline_box_place& b) {
        const affine map = box_on_stand(b, p.run, flat[b.glyph]);
        CHECK(near(map({0, 0}), b.map({0, 0})));
        CHECK(near(map({1, 1}), b.map({1, 1})));
    });
}

TEST_CASE("the letters of a ruby turn where their middles are above the path", "[text]")
{
    test::laid_paragraph<> p{u"abcdef", {.align = alignment::left}};
    const ruby_span spans[] = {{1, 4, u"xyz", {}}};
    ruby_writer rubies;
    REQUIRE(rubies.write(p.font, p.laid(), spans, {.size = 0.5}, p.run));
    plane_path ring;
    ring.circle({0, 0}, 3.0);
    const auto stands = stands_of({&ring, {}}, p.run);
    const text_line& ruby = p.run.lines[1];
    REQUIRE(ruby.glyph_count == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const placed_glyph& g = p.run.glyphs[ruby.first_glyph + i];
        CHECK(as_double(g.to_middle) == Approx(125.0));  // half of half of 500
        const glyph_stand& s = stands[ruby.first_glyph + i];
        const double turn = 1e-3 * (g.origin.x + 125.0) / 3.0;  // from the lowest point, clockwise
        CHECK(near(s.right, {-std::cos(turn), std::sin(turn)}));
        const point middle = 1e-3 * (s.origin + 125.0 * s.right);
        CHECK(std::hypot(middle.x, middle.y) == Approx(3.0 + 1e-3 * g.origin.y));
        CHECK_FALSE(s.warped);
    }
    const placed_glyph& c = p.run.glyphs[2];
    CHECK(near(stands[ruby.first_glyph + 1].right, stands[2].right));  // y is above c, which is the middle of bcd
    CHECK(c.cluster == 2);
}

TEST_CASE("backgrounds and underlines on a path are warped, and letters between them are turned", "[text]")
{
    const style_span under{1, 4, {.decorations = decoration::underline}};
    test::laid_paragraph<> p{u"abcdef", {.align = alignment::left}, {.styles = {&under, 1}}};
    highlight_writer backgrounds;
    const text_highlight span{0, 3, style_id{2}};
    REQUIRE(backgrounds.write(p.font, p.laid(), {&span, 1}, {.radius = 0.2}, p.run));
    plane_path ring;
    ring.circle({0, 0}, 3.0);
    const auto stands = stands_of({&ring, {}}, p.run);
    REQUIRE(p.run.glyphs.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(stands[i].warped == (i == 0 || i == 7));
        CHECK_FALSE(stands[i].left_out);
    }
    CHECK(as_double(p.run.glyphs[0].to_middle) == Approx(750.0));
    CHECK(as_double(p.run.glyphs[7].to_middle) == Approx(750.0));
    CHECK_FALSE(p.run.is_column(p.run.lines[0]));
    test::laid_paragraph<> column{u"abcdef", {}, {.direction = direction::top_to_bottom, .styles = {&under, 1}}};
    REQUIRE(backgrounds.write(column.font, column.laid(), {&span, 1}, {}, column.run));
    CHECK(column.run.is_column(column.run.lines[0]));
    std::vector<glyph_stand> all(column.run.glyphs.size());
    CHECK((on_path{&ring, {}}.place(column.run, 1000.0, all.data()) == error::bad_option));
}
