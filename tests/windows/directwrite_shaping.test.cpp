// SPDX-License-Identifier: MIT
//
// Items, plain text and paragraphs through directwrite_font.
#include "support/catch.hpp"
#include "support/plain_text_law.hpp"
#include "windows/fake_face.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/directwrite_analyser.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

constexpr char mincho[] = "/usr/share/fonts/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf";
using namespace test;

using glyphs_of_item = std::vector<shaped_glyph>;

glyphs_of_item shaped(directwrite_font& font, text_view text, const text_item& item, const shape_options& how = {})
{
    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(font.shape(text, item, how, glyphs));
    return {glyphs.begin(), glyphs.end()};
}

text_item whole(text_view text, std::uint8_t level = 0, glyph_orientation orientation = glyph_orientation::horizontal)
{
    return {.last = static_cast<std::uint32_t>(text.size()), .level = level, .orientation = orientation};
}

double length_of(const glyphs_of_item& glyphs)
{
    double sum = 0.0;
    for (const shaped_glyph& g : glyphs) sum += g.advance;
    return sum;
}

bool same(const shaped_glyph& a, const shaped_glyph& b)
{
    return a.id == b.id && a.cluster == b.cluster && std::fabs(a.advance - b.advance) < 1e-6 &&
           std::fabs(a.offset.x - b.offset.x) < 1e-6 && std::fabs(a.offset.y - b.offset.y) < 1e-6;
}

}  // namespace

TEST_CASE("an item is a part of a text, and its clusters count from the text's start", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    const text_view text = u"Wall Ω𝔸z";
    const glyphs_of_item all = shaped(*font, text, whole(text));
    REQUIRE(all.size() == 8);
    const glyphs_of_item part = shaped(*font, text, {.first = 5, .last = 9});
    REQUIRE(part.size() == 3);
    CHECK(part[0].cluster == 5);
    CHECK(part[1].cluster == 6);
    CHECK(part[2].cluster == 8);
    for (std::size_t i = 0; i < 3; ++i) CHECK(part[i].id == all[5 + i].id);
    CHECK(shaped(*font, text, {.first = 3, .last = 3}).empty());

    // Glyphs are appended.
    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(font->shape(text, {.last = 4}, {}, glyphs));
    REQUIRE_FALSE(font->shape(text, {.first = 4, .last = 9}, {}, glyphs));
    CHECK(glyphs.size() == 8);
}

TEST_CASE("an item's level decides its direction, for any letters", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    for (const text_view text :
         {text_view{u"\u05D0\u05D1 \u05D2"}, text_view{u"abc 12, Ω"}, text_view{u"ab\u05D0\u05D1"}}) {
        const glyphs_of_item right = shaped(*font, text, whole(text, 0)), left = shaped(*font, text, whole(text, 1));
        REQUIRE(right.size() == text.size());
        REQUIRE(left.size() == text.size());
        for (std::size_t i = 0; i < right.size(); ++i) {
            CHECK(right[i].cluster == i);
            CHECK(left[i].cluster == text.size() - 1 - i);
        }
        CHECK(std::fabs(length_of(right) - length_of(left)) < 1e-6);
    }
}

TEST_CASE("a right-to-left item comes in drawing order, letters joined, marks within the word", "[windows]")
{
    auto font = opened(amiri);
    REQUIRE(font);
    const text_view text = u"مَرْحَبًا";
    const glyphs_of_item word = shaped(*font, text, whole(text, 1));
    REQUIRE(word.size() >= 5);
    double pen = 0.0;
    const double length = length_of(word);
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i != 0) CHECK(word[i].cluster <= word[i - 1].cluster);
        CHECK(pen + word[i].offset.x > -200.0);
        CHECK(pen + word[i].offset.x < length + 200.0);
        pen += word[i].advance;
    }
    CHECK(word.back().cluster == 0);
    // A letter inside a word has another form than alone. The text around an item is no context.
    const text_view joined = u"\u062D\u062D\u062D";
    const glyphs_of_item three = shaped(*font, joined, whole(joined, 1));
    const glyphs_of_item middle = shaped(*font, joined, {.first = 1, .last = 2, .level = 1});
    const glyphs_of_item alone = shaped(*font, u"\u062D", whole(u"\u062D", 1));
    REQUIRE(alone.size() == 1);
    REQUIRE(middle.size() == 1);
    CHECK(middle[0].id == alone[0].id);
    for (const shaped_glyph& g : three) CHECK(g.id != alone[0].id);
}

TEST_CASE("glyphs of a cluster agree whether a line may end before it, and both sides of a safe place stand alone",
          "[windows]")
{
    const struct {
        const char* font;
        text_view text;
        std::uint8_t level;
    } items[] = {{dejavu, u"office waffle AVATo 12 fi", 0},
                 {dejavu, u"e\u0301a\u0308\u0323 x 𝔸𝔸 a\u00ADb", 0},
                 {amiri, u"مَرْحَبًا بالعالم 12 لا", 1},
                 {dejavu, u"\u05D0\u05D1\u05D2 \u05D3\u05D4", 1},
                 {micro_hei, u"世界、こ", 0}};
    for (const auto& of : items) {
        auto font = opened(of.font);
        REQUIRE(font);
        glyphs_of_item all = shaped(*font, of.text, whole(of.text, of.level));
        REQUIRE_FALSE(all.empty());
        for (std::size_t i = 1; i < all.size(); ++i)
            if (all[i].cluster == all[i - 1].cluster)
                CHECK(has(all[i].flags, glyph_flags::unsafe_to_break) ==
                      has(all[i - 1].flags, glyph_flags::unsafe_to_break));
        for (const shaped_glyph& at : all) {
            if (at.cluster == 0) CHECK_FALSE(has(at.flags, glyph_flags::unsafe_to_break));
            if (at.cluster == 0 || has(at.flags, glyph_flags::unsafe_to_break)) continue;
            text_item before = whole(of.text, of.level), after = before;
            before.last = after.first = at.cluster;
            glyphs_of_item joined = shaped(*font, of.text, before), rest = shaped(*font, of.text, after);
            if (of.level != 0) std::swap(joined, rest);
            joined.insert(joined.end(), rest.begin(), rest.end());
            INFO("cut before unit " << at.cluster);
            REQUIRE(joined.size() == all.size());
            for (std::size_t i = 0; i < all.size(); ++i) CHECK(same(joined[i], all[i]));
        }
    }
}

TEST_CASE("missing glyphs are flagged, and what is never drawn has no glyph", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    const text_view text = u"a\U0001F9FFb\u2060c\U000E0100";
    const glyphs_of_item glyphs = shaped(*font, text, whole(text));
    std::size_t missing = 0;
    for (const shaped_glyph& g : glyphs) {
        CHECK(has(g.flags, glyph_flags::missing) == (g.id == 0));
        missing += g.id == 0 ? 1u : 0u;
        if (g.id == 0) CHECK(g.cluster == 1);
    }
    CHECK(missing == 1);
}

TEST_CASE("upright items go down by the font's vertical metrics, others as in a line", "[windows]")
{
    auto font = opened(micro_hei);
    REQUIRE(font);
    const double em = font->units_per_em();
    const text_view text = u"世、「";
    const glyphs_of_item line = shaped(*font, text, whole(text));
    const glyphs_of_item column = shaped(*font, text, whole(text, 0, glyph_orientation::upright));
    REQUIRE(column.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(column[i].cluster == i);
        CHECK(column[i].advance > 0.8 * em);
        CHECK(std::fabs(column[i].offset.x + em / 2) < 0.1 * em);
        CHECK(column[i].offset.y < -0.5 * em);
    }
    CHECK(column[0].id == line[0].id);
    CHECK(std::fabs(length_of(line) - 3.0 * em) < 0.2 * em);
    for (const glyph_orientation as : {glyph_orientation::sideways, glyph_orientation::combined}) {
        const glyphs_of_item lying = shaped(*font, text, whole(text, 0, as));
        REQUIRE(lying.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) CHECK(same(lying[i], line[i]));
    }
    // Hebrew that stands upright is read upwards.
    auto hebrew = opened(dejavu);
    REQUIRE(hebrew);
    const text_view word = u"\u05D0\u05D1\u05D2";
    const glyphs_of_item up = shaped(*hebrew, word, whole(word, 1, glyph_orientation::upright));
    REQUIRE(up.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(up[i].cluster == 2 - i);
        CHECK(up[i].advance > 0.0);
    }
}

TEST_CASE("a character has a vertical form if its glyph in columns is another one", "[windows]")
{
    auto font = opened(mincho);
    REQUIRE(font);
    for (const char32_t c : {U'A', U'世', U'\U0001D538', U'\U0001F9FF'}) CHECK_FALSE(font->has_vertical_form(c));
    std::size_t forms = 0;
    for (const char32_t c : {U'、', U'「', U'」', U'ー', U'（'}) {
        const auto unit = static_cast<char16_t>(c);
        const text_view text{std::u16string_view{&unit, 1}};
        const glyphs_of_item line = shaped(*font, text, whole(text));
        const glyphs_of_item column = shaped(*font, text, whole(text, 0, glyph_orientation::upright));
        REQUIRE(column.size() == 1);
        CHECK(font->has_vertical_form(c) == (line[0].id != column[0].id));
        forms += font->has_vertical_form(c) ? 1u : 0u;
    }
    CHECK(forms > 0);
    fake_face face;  // it fails when it is asked for the glyph of a character
    auto failing = directwrite_font::wrap(&face);
    REQUIRE(failing);
    CHECK_FALSE(failing->has_vertical_form(U'、'));
}

TEST_CASE("a paragraph through DirectWrite fills lines of a width", "[windows][paragraph]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    const text_view text = u"In the beginning \u05D1\u05E8\u05D0\u05E9\u05D9\u05EA was the office, 12 waffles";
    paragraph words{*font};
    REQUIRE(words.set(text));
    glyph_run one, run;
    REQUIRE(words.lay_out({}, one));
    REQUIRE(one.lines.size() == 1);
    for (const double width : {5.0, 8.0, 13.0, 60.0}) {
        REQUIRE(words.lay_out({.width = width}, run));
        CHECK((run.lines.size() == 1) == (width > 50.0));
        CHECK(run.missing == 0);
        for (std::size_t i = 0; i < run.lines.size(); ++i) {
            CHECK(run.lines[i].origin.x == 0.0);
            CHECK(run.lines[i].advance <= width * font->units_per_em());
            if (i != 0) CHECK(run.lines[i].origin.y < run.lines[i - 1].origin.y);
        }
        std::vector<bool> drawn(text.size());
        for (const placed_glyph& g : run.glyphs) drawn[g.cluster] = true;
        for (const placed_glyph& g : one.glyphs) CHECK(drawn[g.cluster]);
    }
    REQUIRE(words.lay_out({.width = 13.0, .align = alignment::justify}, run));
    REQUIRE(run.lines.size() > 1);
    for (std::size_t i = 0; i + 1 < run.lines.size(); ++i)
        CHECK(std::fabs(run.lines[i].advance - 13.0 * font->units_per_em()) < 1.0);

    // A word that is broken is shaped again at the line's end; lines of Arabic extend to the left of the width.
    auto arabic = opened(amiri);
    REQUIRE(arabic);
    paragraph<directwrite_font, directwrite_analyser> lines{*arabic};
    REQUIRE(lines.set(u"مرحبا بالعالم مرحبا"));
    REQUIRE(lines.lay_out({.width = 2.0, .wrap = wrap_mode::grapheme}, run));
    CHECK(run.lines.size() > 2);
    for (const text_line& line : run.lines) {
        CHECK(line.advance <= 2.0 * arabic->units_per_em());
        CHECK(std::fabs(line.origin.x + line.advance - 2.0 * arabic->units_per_em()) < 1e-6);
    }
}

TEST_CASE("plain text through DirectWrite is what a paragraph without a width makes", "[windows][paragraph]")
{
    const struct {
        const char* font;
        text_view text;
    } texts[] = {{dejavu, u"office 12\n\u05D0\u05D1 ab \u05D2 \n\nA\tB  "},
                 {dejavu, "a\xFFz \xF0\x9F\xA7\xBF"},
                 {amiri, u"مرحبا بالعالم 12 (ab)"},
                 {micro_hei, u"世界、Ab12「こ」"}};
    const style_span spans[] = {{1, 3, {.size = 1.5}}};
    const shape_options ways[] = {{},
                                  {.direction = direction::right_to_left},
                                  {.letter_spacing = 0.1, .styles = spans},
                                  {.direction = direction::top_to_bottom}};
    for (const auto& t : texts) {
        auto font = opened(t.font);
        REQUIRE(font);
        paragraph words{*font};
        for (const shape_options& how : ways) {
            glyph_run plain, laid;
            REQUIRE(layout(*font, t.text, how, {}, plain));
            REQUIRE(words.set(t.text, how));
            REQUIRE(words.lay_out({}, laid));
            CHECK(difference(plain, laid) == "");
        }
    }
}
