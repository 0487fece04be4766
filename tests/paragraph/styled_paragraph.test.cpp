// SPDX-License-Identifier: MIT
//
// Laws of styles that hold for every text: colours move nothing, sizes scale, memory.

#include "support/counting_memory.hpp"
#include "support/laid_paragraph.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

const std::u16string styled_letters = u"AV fix, \u05D0\u05D1 12 \u05D2 and\n\ta\u0301b fi AVAV \u05D3\u05D4 of fi";

/// Spans one after the other, with gaps; some begin inside graphemes.
std::vector<style_span> random_spans(std::mt19937& random, std::uint32_t size)
{
    std::vector<style_span> spans;
    for (std::uint32_t at = 0;;) {
        const auto first = static_cast<std::uint32_t>(at + random() % 4),
                   last = static_cast<std::uint32_t>(first + random() % 5);
        if (last > size) return spans;
        spans.push_back({first, last, {.style = style_id{static_cast<std::uint32_t>(random() % 3)}}});
        at = last;
    }
}

bool same_lines_and_glyphs(const glyph_run& a, const glyph_run& b)
{
    return test::same_glyphs(a, b) && std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                                                 [](const text_line& l, const text_line& m) {
                                                     return l.origin == m.origin && same(l.advance, m.advance);
                                                 });
}

}  // namespace

TEST_CASE("colours move nothing: glyphs and places are the same to the bit", "[paragraph][styles]")
{
    test::laid_paragraph<> plain{""}, coloured{""};
    std::mt19937 random{3};
    for (int round = 0; round < 60; ++round) {
        const auto spans = random_spans(random, static_cast<std::uint32_t>(styled_letters.size()));
        const std::size_t calls = plain.font.calls, styled_calls = coloured.font.calls;
        REQUIRE(plain.words.set(styled_letters));
        REQUIRE(coloured.words.set(styled_letters, {.styles = spans}));
        CHECK(coloured.font.calls - styled_calls == plain.font.calls - calls);
        for (const double width : {2.0, 4.0, 1e3}) {
            plain.again({.width = width, .align = alignment::justify});
            coloured.again({.width = width, .align = alignment::justify});
            CHECK(same_lines_and_glyphs(plain.run, coloured.run));
            for (std::size_t i = 0; i < coloured.run.glyphs.size(); ++i) {  // by its first character's span
                const style_spans& styles = coloured.words.shaped().styles;
                CHECK(coloured.style(i).style == styles[styles.number_at(coloured.run.glyphs[i].cluster)].style);
            }
        }
    }
}

TEST_CASE("a ligature over two styles has its first character's", "[paragraph][styles]")
{
    const style_span spans[] = {{1, 2, {.style = style_id{7}}}, {2, 3, {.style = style_id{8}}}};
    const test::laid_paragraph<> p{"xfi", {}, {.styles = spans}};
    CHECK(p.line(0) == u"x\uFB01");
    CHECK(p.style(0).style == style_id{});
    CHECK(p.style(1).style == style_id{7});

    const style_span sizes[] = {{1, 2, {.size = 2.0}}};  // which shape it apart
    CHECK(test::laid_paragraph<>{"xfi", {}, {.styles = sizes}}.run.glyphs.size() == 3);
}

TEST_CASE("sizes, rises, slants and distances do what they say", "[paragraph][styles]")
{
    const style_span spans[] = {{1, 3, {.size = 2.0, .letter_spacing = 0.25, .rise = 0.5, .slant = 0.125}},
                                {3, 6, {.word_spacing = 0.125}}};
    const test::laid_paragraph<> p{"abc d\te", {}, {.styles = spans}};
    REQUIRE(p.run.glyphs.size() == 6);
    const double places[] = {0.0, 500.0, 1750.0, 3000.0, 3375.0};
    for (std::size_t i = 0; i < 5; ++i) CHECK(std::fabs(p.run.glyphs[i].origin.x - places[i]) < 1e-9);
    CHECK(p.run.glyphs[1].origin.y == 500.0);
    CHECK(p.style(1).map == affine{.xx = 2.0, .xy = 0.25, .yy = 2.0});
    CHECK(p.style(0) == glyph_style{});
    CHECK(p.run.glyphs[5].origin.x == 5000.0);  // stops are those of plain spaces; that at 4000 is too near

    const style_span large[] = {{0, 7, {.size = 3.0}}};
    CHECK(test::laid_paragraph<>{"abc d\te", {}, {.styles = large}}.run.glyphs.back().origin.x == 7000.0);
}

TEST_CASE("a refused set of spans leaves an empty text", "[paragraph][styles]")
{
    test::toy_shaper font;
    paragraph<test::toy_shaper> words{font};
    const style_span nested[] = {{0, 3, {}}, {1, 2, {}}}, other_face[] = {{0, 1, {.face = 1}}};
    CHECK(words.set("abc", {.styles = nested}) == error::overlapping_spans);
    CHECK(words.shaped().text().size() == 0);
    CHECK(words.set("abc", {.styles = other_face}) == error::no_such_face);
    const style_span good[] = {{0, 1, {.style = style_id{1}}}};
    REQUIRE(words.set("abc", {.styles = good}));
    REQUIRE(words.set("abc"));
    CHECK(words.shaped().styles.empty());
}

TEST_CASE("a styled text laid out again needs no memory", "[paragraph][styles]")
{
    test::toy_shaper font;
    test::counting_memory memory;
    paragraph<test::toy_shaper> words{font, memory.source()};
    glyph_run run{memory.source()};
    const style_span spans[] = {{1, 4, {.size = 2.0, .decorations = decoration::underline}},
                                {5, 20, {.letter_spacing = 0.1, .style = style_id{2}}}};
    for (int round = 0; round < 2; ++round) {
        if (round == 1) memory.requests = 0;
        REQUIRE(words.set(styled_letters, {.styles = spans}));
        for (const double width : {2.0, 3.0, 7.0}) REQUIRE(words.lay_out({.width = width}, run));
    }
    CHECK(memory.requests == 0);
}

TEST_CASE("a styled text whose memory fails is laid out as before once there is some", "[paragraph][styles]")
{
    test::toy_shaper font;
    const style_span spans[] = {{1, 4, {.size = 2.0, .decorations = decoration::underline}},
                                {5, 9, {.position = script_position::superscript, .style = style_id{2}}}};
    paragraph<test::toy_shaper> fresh{font};
    glyph_run wanted;
    REQUIRE(fresh.set(styled_letters, {.styles = spans}));
    REQUIRE(fresh.lay_out({.width = 3.0}, wanted));
    bool failed = true;
    for (std::size_t at = 1; failed; ++at) {
        test::counting_memory failing{.fail_at = at, .fail_once = true};
        paragraph<test::toy_shaper> words{font, failing.source()};
        glyph_run run{failing.source()};
        error e = words.set(styled_letters, {.styles = spans}).error();
        if (!e) e = words.lay_out({.width = 3.0}, run).error();
        failed = static_cast<bool>(e);
        if (failed) CHECK(e == error::out_of_memory);
        REQUIRE(words.set(styled_letters, {.styles = spans}));
        REQUIRE(words.lay_out({.width = 3.0}, run));
        CHECK(same_lines_and_glyphs(run, wanted));
    }
}
