// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/layout/impl/item_settings.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// The toy font with superscript digits and no subscripts of its own.
struct small_letters : test::toy_shaper {
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
    {
        const std::size_t before = glyphs.size();
        if (error e = toy_shaper::shape(text, item, how, glyphs)) return e;
        for (const feature& f : how.features)
            for (shaped_glyph& g : glyphs.view().subspan(before))
                if (std::string{f.tag} == "sups" && g.id >= '0' && g.id <= '9') g.id += 1000;
        return {};
    }
};
static_assert(shaper<small_letters>);

struct read_settings {
    small_letters font;
    style_spans styles;
    buffer<text_item> items;
    item_settings settings;

    read_settings(text_view text, const std::vector<style_span>& spans, const item_settings::base& plain = {})
    {
        const text_analysis found = test::analysed(text);
        REQUIRE_FALSE(styles.read(spans, found, 3));
        REQUIRE_FALSE(itemise(text, found, styles.borders(), {}, items));
        REQUIRE_FALSE(settings.read(font, text, found, styles, plain, items.view()));
    }
};

}  // namespace

TEST_CASE("an item has the face, the size and the spacing of its style", "[paragraph][styles]")
{
    const read_settings r{"abc",
                          {{1, 2, {.face = 2, .size = 3.0, .letter_spacing = 0.5, .language = "tr"}}},
                          {.options = {.language = "de"}, .letter_spacing = 100.0}};
    REQUIRE(r.items.size() == 3);
    CHECK(r.items[1].face == 2);
    CHECK(r.items[1].style == 1);
    CHECK(r.settings[1].scale == 3.0);
    CHECK(r.settings[1].letter_spacing == 600.0);
    CHECK(r.settings.options_of(1).language == "tr");
    for (const std::uint32_t other : {0u, 2u}) {
        CHECK(r.items[other].style == 0);
        CHECK(r.settings[other].scale == 1.0);
        CHECK(r.settings[other].letter_spacing == 100.0);
        CHECK(r.settings.options_of(other).language == "de");
    }
}

TEST_CASE("a style's features follow the whole text's", "[paragraph][styles]")
{
    const feature whole[] = {{"onum", 1}}, own[] = {{"onum", 0}, {"smcp", 1}};
    const read_settings r{"abc", {{1, 2, {.features = own}}}, {.options = {.features = whole}}};
    REQUIRE(r.settings.options_of(1).features.size() == 3);
    CHECK(std::string{r.settings.options_of(1).features[0].tag} == "onum");
    CHECK(r.settings.options_of(1).features[1].value == 0);
    CHECK(std::string{r.settings.options_of(1).features[2].tag} == "smcp");
    CHECK(r.settings.options_of(0).features.size() == 1);
}

TEST_CASE("ligatures are off where letters are spaced", "[paragraph][styles]")
{
    const read_settings r{"abc", {{1, 2, {.letter_spacing = 0.1}}}};
    CHECK(r.settings.options_of(0).ligatures);
    CHECK_FALSE(r.settings.options_of(1).ligatures);
    const read_settings plain{"abc", {}, {.options = {}, .letter_spacing = 1.0}};
    CHECK_FALSE(plain.settings.options_of(0).ligatures);
    CHECK(plain.settings[0].letter_spacing == 1.0);
    CHECK(plain.font.calls == 0);
}

TEST_CASE("superscripts are the font's own where it has all of them, else smaller letters", "[paragraph][styles]")
{
    const text_style raised{.size = 2.0, .position = script_position::superscript};
    const read_settings own{"a1 2", {{1, 4, raised}}};
    CHECK(own.settings[1].scale == 2.0);
    CHECK(own.settings[1].lift == 0.0);
    CHECK(std::string{own.settings.options_of(1).features.back().tag} == "sups");

    const read_settings scaled{"a1b", {{1, 3, raised}}};  // no superscript b
    const script_metrics usual = face_metrics{}.superscript;
    CHECK(scaled.settings[1].scale == 2.0 * usual.size);
    CHECK(std::fabs(scaled.settings[1].lift - 2000.0 * usual.rise) < 1e-9);
    CHECK(scaled.settings.options_of(1).features.empty());

    const read_settings lowered{"a1", {{1, 2, {.position = script_position::subscript}}}};
    CHECK(lowered.settings[1].lift < 0.0);
    CHECK(lowered.settings[1].scale < 1.0);
}
