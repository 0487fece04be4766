// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// The toy font with bars of its own.
struct barred_font : test::toy_shaper {
    static face_metrics suggested_metrics() noexcept
    {
        return {.underline = {-0.1, 0.05}, .strike_through = {0.3, 0.04}};
    }
};

struct bar_box {
    double left, right, low, high;
    style_id style;
};

struct decorated : test::laid_paragraph<barred_font> {
    decorated(text_view text, const std::vector<style_span>& spans, const layout_options& options = {},
              shape_options how = {})
        : test::laid_paragraph<barred_font>{text, options, (how.styles = spans, how)}
    {
    }
    [[nodiscard]] std::vector<bar_box> bars() const
    {
        std::vector<bar_box> all;
        for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
            const placed_glyph& g = run.glyphs[i];
            const glyph_style l = style(i);
            if (l.face != bar_face) continue;
            CHECK(g.cluster == no_cluster);
            all.push_back({g.origin.x, g.origin.x + l.map.xx, g.origin.y, g.origin.y + l.map.yy, l.style});
        }
        return all;
    }
};

bool covers(const bar_box& b, double left, double right)
{
    return std::fabs(b.left - left) < 1e-9 && std::fabs(b.right - right) < 1e-9;
}
bool lies(const bar_box& b, double low, double high)
{
    return std::fabs(b.low - low) < 1e-9 && std::fabs(b.high - high) < 1e-9;
}

}  // namespace

TEST_CASE("bars stand where the font says, as wide as the text and in its style", "[paragraph][styles]")
{
    const decoration all = decoration::underline | decoration::strike_through | decoration::overline;
    const decorated d{"abcd", {{1, 3, {.decorations = all, .style = style_id{5}}}}};
    const auto bars = d.bars();
    REQUIRE(bars.size() == 3);
    for (const bar_box& b : bars) {
        CHECK(covers(b, 500.0, 1500.0));
        CHECK(b.style == style_id{5});
    }
    CHECK(lies(bars[0], -150.0, -100.0));
    CHECK(lies(bars[1], 260.0, 300.0));
    CHECK(lies(bars[2], 650.0, 700.0));
    CHECK(d.run.lines[0].glyph_count == 7);
    CHECK(d.run.lines[0].advance == 2000.0);
}

TEST_CASE("a bar goes on over what has no width", "[paragraph][styles]")
{
    const decorated d{u"ab\u00ADcd", {{0, 5, {.decorations = decoration::underline}}}};
    const auto bars = d.bars();
    REQUIRE(bars.size() == 1);
    CHECK(covers(bars[0], 0.0, 2000.0));
}

TEST_CASE("bars follow size, rise and lines, and underlines do not follow small letters", "[paragraph][styles]")
{
    const text_style lined{.decorations = decoration::underline};
    text_style large = lined, risen = lined, small = lined;
    large.size = 2.0;
    risen.rise = 0.5;
    small.position = script_position::superscript;
    const auto sized = decorated{"abc", {{0, 1, large}, {1, 2, risen}}}.bars();
    REQUIRE(sized.size() == 2);
    CHECK(covers(sized[0], 0.0, 1000.0));
    CHECK(lies(sized[0], -300.0, -200.0));
    CHECK(lies(sized[1], 350.0, 400.0));
    const auto joined = decorated{"xy", {{0, 1, lined}, {1, 2, small}}}.bars();
    REQUIRE(joined.size() == 1);
    CHECK(covers(joined[0], 0.0, 500.0 + 500.0 * face_metrics{}.superscript.size));

    const decorated wrapped{"ab cd", {{0, 5, lined}}, {.width = 1.5}};
    REQUIRE(wrapped.bars().size() == 2);
    for (const bar_box& b : wrapped.bars()) CHECK(covers(b, 0.0, 1000.0));  // not below the space, which hangs
    CHECK(wrapped.run.lines[1].first_glyph == wrapped.run.lines[0].glyph_count);
}

TEST_CASE("through and above small letters bars are as small as these, and stand as they do", "[paragraph][styles]")
{
    for (const auto position : {script_position::superscript, script_position::subscript}) {
        const bool raised = position == script_position::superscript;
        const script_metrics own = raised ? face_metrics{}.superscript : face_metrics{}.subscript;
        const text_style struck{
            .size = 2.0,
            .position = position,
            .rise = 0.5,
            .decorations = decoration::underline | decoration::strike_through | decoration::overline};
        const auto bars = decorated{"xy", {{1, 2, struck}}}.bars();
        REQUIRE(bars.size() == 3);
        const double size = 2.0 * own.size, lift = 500.0 + 2000.0 * own.rise;
        CHECK(lies(bars[0], 200.0, 300.0));  // at the line's own height
        CHECK(lies(bars[1], lift + 260.0 * size, lift + 300.0 * size));
        CHECK(lies(bars[2], lift + 650.0 * size, lift + 700.0 * size));
    }
}

TEST_CASE("a range in mixed directions has a bar for each stretch", "[paragraph][styles]")
{
    const decorated d{u"ab \u05D0\u05D1 cd", {{1, 4, {.decorations = decoration::underline}}}};
    REQUIRE(d.bars().size() == 2);
    CHECK(covers(d.bars()[0], 500.0, 1250.0));
    CHECK(covers(d.bars()[1], 1750.0, 2250.0));
}

TEST_CASE("bars are as wide as the boxes of what they belong to, however lines are aligned", "[paragraph][styles]")
{
    const std::u16string text = u"AV fix, \u05D0\u05D1 12 \u05D2 and\n\ta\u0301b fi \u05D3\u05D4";
    const auto size = static_cast<std::uint32_t>(text.size());
    for (const alignment align : {alignment::start, alignment::justify, alignment::right})
        for (const double width : {3.0, 4.0, 100.0})
            for (std::uint32_t first = 0; first < size; first += 3)
                for (std::uint32_t last = first + 1; last <= size; last += 2) {
                    const decorated d{text,
                                      {{first, last, {.decorations = decoration::underline}}},
                                      {.width = width, .align = align}};
                    if (d.words.shaped().styles.moved() != 0) continue;
                    double bars = 0.0, boxes = 0.0;
                    for (const bar_box& b : d.bars()) bars += (b.right - b.left) / 1000.0;
                    const laid_text laid = d.words.laid();
                    laid.boxes_of(first, last, [&](const box& b) {
                        for (const laid_line& line : d.words.lines())  // what hangs counts for boxes only
                            if (std::fabs(line.origin.y / 1000.0 - b.low.y - 0.2) < 1e-9)
                                boxes += std::fmax(0.0, std::fmin(b.high.x, line.right() / 1000.0) -
                                                            std::fmax(b.low.x, line.left / 1000.0));
                    });
                    const bool splits = first > 0 && (text[first] == u'i' || (last < size && text[last] == u'i'));
                    if (!splits) CHECK(std::fabs(bars - boxes) < 1e-9);
                }
}

TEST_CASE("in columns bars stand beside the letters and in their middle", "[paragraph][styles]")
{
    const decoration both = decoration::underline | decoration::strike_through | decoration::overline;
    const decorated d{"abc", {{1, 2, {.decorations = both}}}, {}, {.direction = direction::top_to_bottom}};
    REQUIRE(d.bars().size() == 3);
    for (const bar_box& b : d.bars()) CHECK(lies(b, -1000.0, -500.0));
    CHECK(d.bars()[0].right == -200.0 - 50.0);  // apart from the letters by its thickness
    CHECK(d.bars()[1].left == -20.0);
    CHECK(d.bars()[2].left == 700.0 + 50.0);
}

TEST_CASE("columns of Japanese and Korean are underlined on the right, and have their overline on the left",
          "[paragraph][styles]")
{
    const decoration both = decoration::underline | decoration::overline;
    for (const char* language : {"", "ja", "ja-JP", "JA_jp", "ko", "zh", "zh-Hant", "jav", "j"}) {
        const std::string name{language};
        const bool right = name.size() > 1 && name != "jav" && name[0] != 'z';
        CHECK(underlined_on_the_right(language) == right);
        const shape_options how{.direction = direction::top_to_bottom, .language = language};
        for (const bool styled : {false, true}) {
            text_style style{.decorations = both};
            if (styled) style.language = language;
            const auto bars = decorated{"abc", {{1, 2, style}}, {}, styled ? shape_options{how.direction} : how}.bars();
            REQUIRE(bars.size() == 2);
            CHECK(lies(bars[right ? 0 : 1], -1000.0, -500.0));
            CHECK(bars[right ? 0 : 1].left == 700.0 + 50.0);
            CHECK(bars[right ? 1 : 0].right == -200.0 - 50.0);
        }
    }
    const auto line = decorated{"abc", {{1, 2, {.decorations = both}}}, {}, {.language = "ja"}}.bars();
    CHECK(line[0].high == -100.0);  // in lines nothing changes
}
