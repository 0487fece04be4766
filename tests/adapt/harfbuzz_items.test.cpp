// SPDX-License-Identifier: MIT
//
// Items shaped through HarfBuzz, held against whole lines of one direction, which are shaped another way.

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/text/shaped_by.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::amiri;
using test::dejavu;
using test::opened;

constexpr std::uint32_t tag(const char (&letters)[5])
{
    std::uint32_t made = 0;
    for (int i = 0; i < 4; ++i) made = made << 8 | static_cast<unsigned char>(letters[i]);
    return made;
}

struct items {
    buffer<shaped_glyph> glyphs;

    items(harfbuzz_font& font, text_view text, const text_item& item, const shape_options& how = {})
    {
        const error e = font.shape(text, item, how, glyphs);
        INFO(e.message());
        REQUIRE_FALSE(e);
    }
};

text_item whole(text_view text, std::uint32_t script, std::uint8_t level)
{
    return {.first = 0, .last = static_cast<std::uint32_t>(text.size()), .script = script, .level = level};
}

}  // namespace

TEST_CASE("an item has the glyphs and places of the line that it is", "[adapt][harfbuzz]")
{
    struct sample {
        const char* font;
        std::u16string text;
        std::uint32_t script;
        std::uint8_t level;
        direction flow;
    };
    const sample all[] = {
        {dejavu, u"AVATAR office, To Ve.", tag("Latn"), 0, direction::automatic},
        {amiri, u"\u0628\u0650\u0633\u0652\u0645\u0650 \u0627\u0644\u0644\u0651\u0647", tag("Arab"), 1,
         direction::automatic},
        {"truetype/lohit-devanagari/Lohit-Devanagari.ttf",
         u"\u0915\u094D\u0937\u093F\u0924\u093F \u0939\u093F\u0928\u094D\u0926\u0940", tag("Deva"), 0,
         direction::automatic},
        {"truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf", u"\u3053\u3093\u306B\u3061\u306F\u3002\u4E16\u754C",
         tag("Hani"), 0, direction::top_to_bottom},
    };
    for (const sample& s : all) {
        harfbuzz_font font = opened(s.font);
        glyph_run run;
        REQUIRE(layout(font, s.text, {.direction = s.flow}, {.align = alignment::left}, run));
        text_item item = whole(s.text, s.script, s.level);
        const bool down = s.flow == direction::top_to_bottom;
        if (down) item.orientation = glyph_orientation::upright;
        const items made{font, s.text, item};
        REQUIRE(made.glyphs.size() == run.glyphs.size());
        double pen = 0.0;
        for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
            const shaped_glyph& g = made.glyphs[i];
            CHECK(g.id == run.glyphs[i].id);
            CHECK(g.cluster == run.glyphs[i].cluster);
            CHECK(has(g.flags, glyph_flags::missing) == run.glyphs[i].missing);
            const point at = g.offset + (down ? point{0.0, 0.0 - pen} : point{pen, 0.0});
            CHECK(length(at - run.glyphs[i].origin) < 1e-9);
            pen += g.advance;
        }
        CHECK(pen == Approx(run.lines[0].advance));
        CHECK(pen > 0.0);
    }
}

TEST_CASE("an item's level decides its direction, and nothing in it is mixed", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    for (const std::u16string text : {u"1234", u"a1\u05D0", u"\u05D0 12"}) {
        const items right{font, text, whole(text, 0, 0)}, left{font, text, whole(text, 0, 1)};
        REQUIRE(right.glyphs.size() == text.size());
        REQUIRE(left.glyphs.size() == text.size());
        for (std::size_t i = 0; i < text.size(); ++i) {
            CHECK(right.glyphs[i].cluster == i);
            CHECK(left.glyphs[i].cluster == text.size() - 1 - i);
        }
    }
    const items bracket{font, "(", whole("(", 0, 1)};  // mirrored
    CHECK(bracket.glyphs[0].id == items(font, ")", whole(")", 0, 0)).glyphs[0].id);
}

TEST_CASE("a part of an item keeps the joins to what stands round it", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const std::u16string text = u"\u0628\u0628\u0628";
    const items all{font, text, whole(text, tag("Arab"), 1)};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const items one{font, text, {.first = i, .last = i + 1, .script = tag("Arab"), .level = 1}};
        REQUIRE(one.glyphs.size() == 1);
        CHECK(one.glyphs[0].id == all.glyphs[2 - i].id);
        CHECK(one.glyphs[0].cluster == i);
    }
}

TEST_CASE("glyphs say where the text must not simply be cut", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const items kerned{font, "xAVx", whole("xAVx", tag("Latn"), 0)};
    CHECK(has(kerned.glyphs[2].flags, glyph_flags::unsafe_to_break));
    CHECK_FALSE(has(kerned.glyphs[0].flags, glyph_flags::unsafe_to_break));

    const items apart{font, "x x", whole("x x", tag("Latn"), 0)};
    for (const shaped_glyph& g : apart.glyphs) CHECK_FALSE(has(g.flags, glyph_flags::unsafe_to_break));

#if HB_VERSION_ATLEAST(5, 1, 0)
    harfbuzz_font naskh = opened(amiri);
    const std::u16string text = u"\u0627\u0644\u0633\u0644\u0627\u0645 \u0639\u0644\u064A\u0643\u0645";
    const items joined{naskh, text, whole(text, tag("Arab"), 1)};
    bool stretches = false;
    for (const shaped_glyph& g : joined.glyphs) stretches = stretches || has(g.flags, glyph_flags::tatweel);
    CHECK(stretches);
#endif
}

TEST_CASE("glyphs of an item that the font lacks are flagged, invalid text is read as everywhere", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const std::string text = "a\xF0\x9F\x9B\xB8\xE2\x82|";  // a flying saucer, and a broken sequence before the bar
    const items made{font, text, whole(text, 0, 0)};
    REQUIRE(made.glyphs.size() == 4);
    CHECK(made.glyphs[1].id == 0);
    CHECK(has(made.glyphs[1].flags, glyph_flags::missing));
    CHECK_FALSE(has(made.glyphs[0].flags, glyph_flags::missing));
    CHECK(made.glyphs[2].cluster == 5);  // one U+FFFD
    CHECK(made.glyphs[3].cluster == 7);
}

TEST_CASE("an item's shaping can fail for its options only", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    buffer<shaped_glyph> glyphs;
    const text_item item = whole("ab", 0, 0);
    CHECK(font.shape("ab", item, {.script = "Lat"}, glyphs) == error::bad_option);
    const feature cut[] = {{"lig", 1}};
    CHECK(font.shape("ab", item, {.features = cut}, glyphs) == error::bad_feature);
    CHECK_FALSE(font.shape("ab", {}, {}, glyphs));
    CHECK(glyphs.empty());
    // An option's script wins.
    CHECK(items(font, u"\u0628\u0628", whole(u"\u0628\u0628", tag("Latn"), 1), {.script = "Arab"}).glyphs[0].id ==
          items(font, u"\u0628\u0628", whole(u"\u0628\u0628", tag("Arab"), 1)).glyphs[0].id);
}

TEST_CASE("a pair of shaper and source shapes items if its shaper does", "[adapt][harfbuzz]")
{
    static_assert(shaper<shaped_by<harfbuzz_font, harfbuzz_font>>);
    harfbuzz_font font = opened(dejavu);
    shaped_by pair{font, font};
    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(pair.shape("ab", whole("ab", 0, 0), {}, glyphs));
    CHECK(glyphs.size() == 2);
}

TEST_CASE("A letter with hundreds of marks is shaped in parts, in drawing order", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const std::u16string text = u"\u05D0" + std::u16string(600, u'\u05B0') + u"\u05D1";
    const items left{font, text, whole(text, tag("Hebr"), 1)};
    REQUIRE(left.glyphs.size() > 2);
    CHECK(left.glyphs[0].cluster == 601);
    for (std::size_t i = 1; i < left.glyphs.size(); ++i) CHECK(left.glyphs[i].cluster <= left.glyphs[i - 1].cluster);
}
