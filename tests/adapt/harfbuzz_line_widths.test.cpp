// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// What lines have been broken by: spaces of all kinds, tabs, marks that are drawn or not, hyphens, joiners, directions,
/// scripts that are shaped in clusters.
const std::u32string alphabet =
    U"   "
    U"\t\t\u200D\u200C\u0301\u0300\u00AD\u200F\u200E\u061C\u4E00\u3001\u3042\u0628\u0627\u0644\u064B\u0E01\u0E32\u0E48"
    U"\u05D0\u05D1aVAfiN)(.1-"
    U"\u200B\u2060\u00A0\u2067\u2069\u202B\u202C\u034F\u115F\u3000\u2028\n\u0930\u094D\u0915\u17A0"
    U"\u17D2\u1794\u1000\u1039\u102C\uFE0F\U0001F468\U000E0100\u1160\u180E\u1680\u2003";

double below(std::mt19937& random, unsigned n) { return static_cast<double>(random() % n); }

std::u16string random_line(std::mt19937& random)
{
    std::u32string some;  // few letters in a text, so that they meet
    for (std::size_t n = 2 + random() % 10; some.size() < n;) some += alphabet[random() % alphabet.size()];
    std::u16string text;
    for (std::size_t n = 1 + random() % 24; n > 0; --n) {
        const char32_t c = some[random() % some.size()];
        if (c >= 0x10000) text += static_cast<char16_t>(0xD7C0 + (c >> 10));
        text += static_cast<char16_t>(c < 0x10000 ? c : 0xDC00 | (c & 0x3FF));
    }
    return text;
}

layout_options random_line_options(std::mt19937& random)
{
    layout_options how{.width = 0.1 + below(random, 400) / 100.0};
    how.wrap = random() % 2 != 0 ? wrap_mode::word_or_grapheme : wrap_mode::grapheme;
    how.align = static_cast<alignment>(random() % 6);
    how.justify = static_cast<justification>(random() % 4);
    how.tab_width = below(random, 5);
    if (random() % 4 == 0) how.indent = how.width * below(random, 200) / 200.0 - how.width / 2;
    return how;
}

/// How many graphemes of a line show something.
template <class Words>
std::size_t shown(const Words& words, const laid_line& line)
{
    const shaped_text& shaped = words.shaped();
    const auto marks = shaped.analysis.marks.view();
    std::size_t n = 0;
    for (std::size_t u = line.first; u < line.last; u = grapheme_end(marks, u))
        n += is_blank(shaped.text(), marks, u, grapheme_end(marks, u)) ? 0u : 1u;
    return n;
}

/// How many lines are wider than there is room, of texts laid out at several widths each.
template <class Words>
std::size_t too_wide(Words& words, std::mt19937& random, const std::u16string& text)
{
    std::vector<style_span> spans;
    if (random() % 3 == 0) {
        const auto middle = static_cast<std::uint32_t>(random() % text.size());
        spans.push_back({0, middle, {.size = 0.5 + below(random, 4) * 0.5}});
        spans.push_back({middle, static_cast<std::uint32_t>(text.size()), {.letter_spacing = 0.25}});
    }
    const shape_options how{.direction = static_cast<direction>(random() % 4)};
    shape_options styled = how;
    styled.styles = spans;
    styled.letter_spacing = random() % 4 == 0 ? 0.1 : 0.0;
    REQUIRE(words.set(text, styled));
    std::size_t wrong = 0;
    for (int k = 0; k < 6; ++k) {
        const layout_options options = random_line_options(random);
        glyph_run run;
        REQUIRE(words.lay_out(options, run));
        bool begins = true;
        const double em = run.units_per_em;
        for (const laid_line& line : words.lines()) {
            const double room = (options.width - (begins ? options.indent : 0.0)) * em;
            begins = line.last > 0 && line.last < text.size() && text[line.last - 1] == u'\n';
            if (!(line.width > room * (1.0 + 1e-9) + 1e-6) || shown(words, line) <= 1) continue;
            ++wrong;
            std::string units;
            for (const char16_t u : text) units += " " + std::to_string(int{u});
            INFO("text" << units << ", width " << options.width << ", line from " << line.first << " to " << line.last);
            CHECK(line.width <= room);
        }
    }
    return wrong;
}

}  // namespace

// TYPEMESH_LINE_WIDTHS=100000 asks for so many texts.
TEST_CASE("no line of a random text is wider than its room, unless it is a single grapheme",
          "[adapt][harfbuzz][paragraph]")
{
    const char* wanted = std::getenv("TYPEMESH_LINE_WIDTHS");
    const int rounds = wanted != nullptr ? std::atoi(wanted) : 1500;
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    paragraph first{*font};
    paragraph<harfbuzz_font, unicode_analyser, total_fit> total{*font};
    std::mt19937 random{29};
    std::size_t wrong = 0;
    for (int k = 0; k < rounds && wrong < 20; ++k) {
        const std::u16string text = random_line(random);
        wrong += k % 4 == 0 ? too_wide(total, random, text) : too_wide(first, random, text);
    }
    CHECK(wrong == 0);
}

TEST_CASE("white space at a line's end hangs beyond every edge, whatever is not drawn beside it",
          "[adapt][harfbuzz][paragraph]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    paragraph words{*font}, plain{*font};
    glyph_run run, bare;
    for (const char16_t* word : {u"abc", u"\u05D0\u05D1\u05D2", u"\u0628\u0628"})
        for (const char16_t* end : {u" \u200F", u" \u200E ", u"\u200F \u061C", u" \u034F", u" \u200D\u200F"})
            for (const alignment align : {alignment::left, alignment::centre, alignment::right}) {
                const std::u16string text = std::u16string{word} + end;
                REQUIRE(words.set(text));
                REQUIRE(plain.set(std::u16string_view{word}));
                REQUIRE(words.lay_out({.width = 8.0, .align = align}, run));
                REQUIRE(plain.lay_out({.width = 8.0, .align = align}, bare));
                CHECK(words.lines()[0].width == Approx(plain.lines()[0].width));
                for (const placed_glyph& g : bare.glyphs) {
                    bool found = false;
                    for (const placed_glyph& h : run.glyphs)
                        found = found || (h.id == g.id && h.origin.x == Approx(g.origin.x).margin(1e-6));
                    CHECK(found);
                }
            }
}

TEST_CASE("the marks of a letter may be any number: all are drawn, with the letter", "[adapt][harfbuzz][paragraph]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    for (const char16_t* letter : {u"x", u"\u05D0"}) {
        const std::u16string text = u"x" + std::u16string{letter} + std::u16string(100000, u'\u0316') + letter;
        paragraph words{*font};
        glyph_run run = test::laid_out(words, text, {}, {.width = 3.0});
        CHECK(run.glyphs.size() == text.size());
        CHECK(run.missing == 0);
        for (const auto& glyphs : {&run}) {
            std::size_t marks = 0;
            for (const placed_glyph& g : glyphs->glyphs) marks += g.cluster == 1 ? 1u : 0u;
            CHECK(marks == 100001);
        }
        REQUIRE(layout(*font, text, {}, {}, run));
        CHECK(run.glyphs.size() == text.size());
        for (const placed_glyph& g : run.glyphs) CHECK((g.cluster <= 1 || g.cluster == text.size() - 1));
    }
}
