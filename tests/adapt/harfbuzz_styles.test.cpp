// SPDX-License-Identifier: MIT
//
// Styled paragraphs with real fonts, and the meshes of them.

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/laid_out.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

const std::u16string coloured_office = u"AVATAR, To office flows. Wave ffi";
const std::u16string bismi = u"\u0628\u0633\u0645 \u0627\u0644\u0644\u0647 \u0633\u0644\u0627\u0645 ab\u064B";

struct styled_vertex {
    vec3 position;
    style_id style;
};

}  // namespace

template <>
struct typemesh::vertex_traits<styled_vertex> {
    static constexpr auto wants = attribute::position | attribute::style;
    styled_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.style}; }
};

TEST_CASE("kerning, ligatures and joined letters survive a change of colour", "[adapt][harfbuzz][styles]")
{
    struct sample {
        const char* font;
        const std::u16string& text;
    };
    for (const sample& s : {sample{"truetype/dejavu/DejaVuSans.ttf", coloured_office},
                            sample{"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", bismi},
                            sample{"truetype/awami/AwamiNastaliq-Regular.ttf", bismi}}) {
        harfbuzz_font font = test::opened(s.font);
        paragraph words{font};
        glyph_run plain, coloured;
        REQUIRE(words.set(s.text));
        REQUIRE(words.lay_out({.width = 4.0}, plain));
        std::vector<style_span> spans;  // a colour for every unit
        for (std::uint32_t u = 0; u < s.text.size(); ++u) spans.push_back({u, u + 1, {.style = style_id{u}}});
        REQUIRE(words.set(s.text, {.styles = spans}));
        REQUIRE(words.lay_out({.width = 4.0}, coloured));
        REQUIRE(coloured.glyphs.size() == plain.glyphs.size());
        for (std::size_t i = 0; i < plain.glyphs.size(); ++i) {
            CHECK(coloured.glyphs[i].id == plain.glyphs[i].id);
            CHECK(coloured.glyphs[i].origin == plain.glyphs[i].origin);
            const style_spans& styles = words.shaped().styles;
            CHECK(coloured.glyph_styles[coloured.glyphs[i].glyph_style].style ==
                  styles[styles.number_at(coloured.glyphs[i].cluster)].style);
        }
    }
}

TEST_CASE("a recoloured letter is built once, and styles part the mesh", "[adapt][harfbuzz][styles]")
{
    harfbuzz_font font = test::opened("truetype/dejavu/DejaVuSans.ttf");
    paragraph words{font};
    text_mesher mesher{font};
    const decoration both = decoration::underline | decoration::overline;
    const style_span spans[] = {{0, 3, {.style = style_id{4}}},
                                {4, 7, {.decorations = both, .style = style_id{2}}},
                                {8, 9, {.size = 1.5, .decorations = both, .style = style_id{9}}}};
    const glyph_run run = test::laid_out(words, "ooo ooo o", {.styles = spans});
    const bool merge = GENERATE(false, true);
    auto plan = test::required(mesher.plan(run, {.merge = merge}));
    CHECK(plan->glyphs().size() == 7 + 4);
    if (!merge) CHECK(plan->meshes().size() == 2 + 2);  // the o of either size; bars of two sizes, twice each
    std::vector<styled_vertex> vertices;
    std::vector<std::uint32_t> indices, styles_of(plan->size().vertices);
    REQUIRE(plan->write(into(vertices, indices)));
    std::size_t named = 0;
    for (const style_id style : plan->styles())
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(style, p);
            named += r.vertex_count;
            for (std::uint32_t v = r.first_vertex; v < r.first_vertex + r.vertex_count; ++v) {
                ++styles_of[v];
                CHECK(vertices[v].style == style);
            }
        }
    CHECK(named == vertices.size());
    CHECK(std::all_of(styles_of.begin(), styles_of.end(), [](std::uint32_t times) { return times == 1; }));
    CHECK(plan->styles().size() == 3);
}

TEST_CASE("decorated text is closed, and its bars are as wide as its letters' advances", "[adapt][harfbuzz][styles]")
{
    harfbuzz_font font = test::opened("truetype/liberation/LiberationSans-Regular.ttf");
    paragraph words{font};
    text_mesher mesher{font};
    const style_span spans[] = {{2, 8, {.slant = 0.2, .decorations = decoration::underline}}};
    const glyph_run run = test::laid_out(words, "gypsy quay", {.styles = spans});
    auto plan = test::required(mesher.plan(run, {}));
    std::vector<test::full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(plan->write(into(vertices, indices)));
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        std::vector<std::uint32_t> own;
        for (const part p : plan->parts()) {
            const auto first = indices.begin() + plan->range(g, p).first_index;
            own.insert(own.end(), first, first + plan->range(g, p).index_count);
        }
        CHECK(test::examine(vertices, own).is_closed());
    }

    double left = 1e9, right = -1e9, low = 1e9, high = -1e9;  // of the bar
    const std::size_t bar = plan->glyphs().size() - 1;
    CHECK(plan->glyphs()[bar].cluster == no_cluster);
    for (const part p : plan->parts()) {
        const mesh_range r = plan->range(bar, p);
        for (std::uint32_t v = r.first_vertex; v < r.first_vertex + r.vertex_count; ++v) {
            left = std::min(left, double(vertices[v].position.x)),
            right = std::max(right, double(vertices[v].position.x));
            low = std::min(low, double(vertices[v].position.y)), high = std::max(high, double(vertices[v].position.y));
        }
    }
    std::vector<box> boxes;
    words.laid().boxes_of(2, 8, [&](const box& b) { boxes.push_back(b); });
    REQUIRE(boxes.size() == 1);
    CHECK(std::fabs(left - boxes[0].low.x) < 1e-5);
    CHECK(std::fabs(right - boxes[0].high.x) < 1e-5);
    CHECK(std::fabs(high - -67.0 / 2048) < 1e-5);
    CHECK(std::fabs(low - -217.0 / 2048) < 1e-5);
}

TEST_CASE("carets stand within ligatures where the font says, and lead back to their places",
          "[adapt][harfbuzz][styles][carets]")
{
    harfbuzz_font font = test::opened("opentype/fonts-hosny-amiri/Amiri-Regular.ttf");
    paragraph words{font};
    glyph_run run = test::laid_out(words, "ffi");
    REQUIRE(run.glyphs.size() == 1);
    CHECK(std::fabs(words.laid().caret_at(1).at.x - 0.269) < 1e-3);
    CHECK(std::fabs(words.laid().caret_at(2).at.x - 0.537) < 1e-3);

    const std::u16string mixed = u"office ffi fl " + bismi + u" \u0644\u0627 ffl";
    const style_span large[] = {{1, 5, {.size = 2.0}}};
    for (const double width : {3.0, 5.0, 100.0})
        for (const bool styled : {false, true}) {
            REQUIRE(words.set(mixed,
                              {.styles = styled ? std::span<const style_span>{large} : std::span<const style_span>{}}));
            REQUIRE(words.lay_out({.width = width, .align = alignment::justify}, run));
            const laid_text laid = words.laid();
            for (std::uint32_t unit = 0; unit <= mixed.size(); ++unit)
                for (const affinity side : {affinity::downstream, affinity::upstream}) {
                    const caret at = laid.caret_at(unit, side);
                    const text_place found = laid.caret_from(at.at);
                    const caret again = laid.caret_at(found.unit, found.side);
                    CHECK(again.line == at.line);
                    CHECK(std::fabs(again.at.x - at.at.x) < 1e-9);
                }
        }
}

TEST_CASE("a span names its face, with that face's metrics and carets", "[adapt][harfbuzz][styles]")
{
    harfbuzz_font sans = test::opened("truetype/liberation/LiberationSans-Regular.ttf");
    harfbuzz_font naskh = test::opened("opentype/fonts-hosny-amiri/Amiri-Regular.ttf");
    font_cascade fonts{sans, naskh};
    paragraph words{fonts};
    const style_span spans[] = {{2, 5, {.face = 1, .decorations = decoration::underline}}};
    const glyph_run run = test::laid_out(words, "a ffi", {.styles = spans});
    REQUIRE(run.glyphs.size() == 4);
    CHECK(run.glyph_styles[run.glyphs[2].glyph_style].face == 1);
    const double unit = sans.units_per_em() / naskh.units_per_em();
    CHECK(std::fabs(words.lines()[0].metrics.ascender - unit * naskh.metrics(direction::automatic).ascender) < 1e-6);
    CHECK(std::fabs(words.laid().caret_at(3).at.x - words.laid().caret_at(2).at.x - 0.269) < 1e-3);
    const placed_glyph& bar = run.glyphs[3];
    CHECK(std::fabs(run.glyph_styles[bar.glyph_style].map.yy - 0.05 * sans.units_per_em()) < 1e-6);
    CHECK(std::fabs(bar.origin.y - -0.562 * sans.units_per_em()) < 1e-6);
    text_mesher mesher{fonts};
    CHECK(mesher.plan(run)->glyphs().size() == 3);
    CHECK(words.set("abc", {.styles = std::vector<style_span>{{0, 1, {.face = 2}}}}) == error::no_such_face);
}

TEST_CASE("superscripts are of the size and at the height that the font names", "[adapt][harfbuzz][styles]")
{
    harfbuzz_font font = test::opened("truetype/liberation/LiberationSans-Regular.ttf");
    paragraph words{font};
    const style_span spans[] = {{4, 5, {.position = script_position::superscript}}};
    const glyph_run run = test::laid_out(words, "E=mc2", {.styles = spans});
    REQUIRE(run.glyphs.size() == 5);
    CHECK(std::fabs(run.glyphs[4].origin.y - 977.0) < 1e-9);
    CHECK(std::fabs(run.glyph_styles[run.glyphs[4].glyph_style].map.yy - 1331.0 / 2048) < 1e-12);
}
