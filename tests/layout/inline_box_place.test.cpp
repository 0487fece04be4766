// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <typemesh/layout/inline_box_place.hpp>
#include <typemesh/layout/layout.hpp>

#include <cmath>
#include <random>

using namespace typemesh;

namespace {

/// Letters of two directions, spaces and boxes; no letters that are kerned or joined.
struct boxed_text {
    std::u16string text;
    std::vector<inline_box> boxes;

    explicit boxed_text(std::mt19937& random)
    {
        const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
        constexpr char16_t letters[] = u"abcd \u05D0\u05D1\u05D2\u6F22\uFFFC1";
        for (std::uint32_t n = 1 + below(12); n > 0; --n) text += letters[below(11)];
        for (std::uint32_t u = 0; u < text.size(); ++u)
            if (text[u] == u'\xFFFC') boxes.push_back({u, 0.125 * below(20), 0.25 * below(6), 0.25 * below(3)});
        if (below(2) != 0) std::reverse(boxes.begin(), boxes.end());
    }
};

double width_of_glyph(const placed_glyph& g, const boxed_text& t)
{
    for (const inline_box& b : t.boxes)
        if (b.unit == g.cluster) return 1000.0 * b.width;
    return g.id == ' ' ? 250.0 : 500.0;
}

}  // namespace

TEST_CASE("boxes of 10000 random texts stand side by side with letters, each once, in plain text and paragraphs",
          "[layout]")
{
    std::mt19937 random{7};
    plain_layout plain;
    for (int i = 0; i < 10000; ++i) {
        const boxed_text t{random};
        test::toy_shaper font;
        const shape_options how{.direction = static_cast<direction>(random() % 3), .boxes = t.boxes};
        glyph_run run;
        REQUIRE(plain(font, t.text, how, {.align = alignment::left}, run));
        double pen = run.lines[0].origin.x - (how.direction == direction::right_to_left ? run.lines[0].hanging : 0.0);
        bool sound = true;
        pen = run.glyphs[0].origin.x;
        for (const placed_glyph& g : run.glyphs) {  // glyphs are in the order of drawing, without gaps
            sound = sound && std::fabs(g.origin.x - pen) < 1e-6 && !g.missing;
            pen += width_of_glyph(g, t);
        }
        std::vector<int> seen(t.boxes.size());
        each_inline_box(run, [&](const inline_box_place& p) {
            const inline_box& b = t.boxes[p.index];
            const placed_glyph& g = run.glyphs[p.glyph];
            ++seen[p.index];
            sound = sound && p.unit == b.unit && g.cluster == b.unit && p.line == 0;
            const point low = p.map({0.0, 0.0}), high = p.map({1.0, 1.0});
            sound = sound && std::fabs(low.x - 1e-3 * g.origin.x) < 1e-9 && std::fabs(high.x - low.x - b.width) < 1e-9;
            sound = sound && std::fabs(low.y + b.descent) < 1e-9 && std::fabs(high.y - b.ascent) < 1e-9;
            sound = sound && std::fabs(as_double(g.to_middle) - 500.0 * b.width) < 1e-3;
        });
        for (const int n : seen) sound = sound && n == 1;
        paragraph words{font};
        glyph_run same;
        REQUIRE(words.set(t.text, how));
        REQUIRE(words.lay_out({.align = alignment::left}, same));
        sound = sound && test::same_glyphs(run, same);
        REQUIRE(sound);
    }
}

TEST_CASE("a box between letters that read to the left stands between them, and lines know their boxes", "[layout]")
{
    const inline_box boxes[] = {{.unit = 1, .width = 2.0}, {.unit = 4, .width = 1.0}};
    const test::laid_paragraph<> p{u"\u05D0\uFFFC\u05D1\n\uFFFC", {.align = alignment::left}, {.boxes = boxes}};
    std::vector<inline_box_place> all;
    each_inline_box(p.run, [&](const inline_box_place& b) { all.push_back(b); });
    REQUIRE(all.size() == 2);
    CHECK(all[0].map.dx == Approx(0.5));  // bet, box, alef
    CHECK(all[0].line == 0);
    CHECK(all[1].line == 1);
    CHECK(all[1].index == 1);
    CHECK(all[1].map.dy == Approx(1e-3 * p.words.lines()[1].origin.y));
}
