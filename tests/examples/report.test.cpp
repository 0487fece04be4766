// SPDX-License-Identifier: MIT

#include "text_to_mesh/report.hpp"

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("text_to_mesh reports what is lost and what is narrowed, a line each, and nothing else", "[text_to_mesh]")
{
    text_report r;
    r.glyphs = 9;
    r.blank = 2;
    CHECK(text_to_mesh::in_words(r).empty());
    CHECK_FALSE(text_to_mesh::name_losses(r));
    r.narrowed = 3;
    r.first_narrowed = 5;
    CHECK(text_to_mesh::in_words(r) ==
          "text_to_mesh: the edges of 3 of 9 glyphs have moved less than --bevel, --outline, --embolden or --tube "
          "request; the "
          "first is at "
          "byte 5 of the text.\n");
    text_report emoji;
    emoji.glyphs = 3;
    emoji.missing = 2;
    emoji.first_missing = 0;
    emoji.parted = 1;
    emoji.first_parted = 4;
    CHECK(text_to_mesh::in_words(emoji, true, "line 3: ") ==
          "line 3: no font has a glyph for 2 of 3 characters; the first is at byte 0 of the text. Add another font "
          "with --fallback.\n"
          "line 3: 1 of them is an emoji whose parts are drawn one by one, because no font has a glyph for the whole; "
          "the "
          "first is at byte 4 of the text.\n");
    r.lost_caps = 2;
    r.first_lost_cap = 6;
    r.missing = 1;
    r.first_missing = 7;
    r.invalid_units = 1;
    r.first_invalid_unit = 8;
    r.unbroken = 2;
    r.first_unbroken = 4;
    CHECK(text_to_mesh::in_words(r) ==
          "text_to_mesh: the font has no glyph for 1 of 9 characters; the first is at byte 7 of the text. Give another "
          "--font, or add a font with --fallback.\n"
          "text_to_mesh: the text is not valid UTF-8 at 1 place; the first is at byte 8 of the text.\n"
          "text_to_mesh: the program has no dictionary for the words of 2 runs of Thai, Lao, Khmer, Burmese or a "
          "similar script, "
          "so lines end there only where they must; the first is at byte 4 of the text.\n"
          "text_to_mesh: the edges of 3 of 9 glyphs have moved less than --bevel, --outline, --embolden or --tube "
          "request; the "
          "first is at "
          "byte 5 of the text.\n"
          "text_to_mesh: bevels meet in a ridge on 2 pieces of glyphs that are smaller than the tolerance; the first "
          "is at byte "
          "6 of the text.\n");
}

TEST_CASE("text_to_mesh names missing characters by number, and shows those that can be printed", "[text_to_mesh]")
{
    CHECK(text_to_mesh::name_of(U'a') == "U+0061 a");
    CHECK(text_to_mesh::name_of(0xE9) == "U+00E9 \xC3\xA9");
    CHECK(text_to_mesh::name_of(0x8336) == "U+8336 \xE8\x8C\xB6");
    CHECK(text_to_mesh::name_of(0x1F44D) == "U+1F44D \xF0\x9F\x91\x8D");
    for (const char32_t hidden : {0x00, 0x0A, 0x20, 0x301, 0x200D, 0xFE0F, 0xE000, 0xFFFF, 0xE0100})
        CHECK(text_to_mesh::name_of(hidden).size() <= 7);

    text_report r;
    r.glyphs = 9;
    r.missing = 2;
    r.first_missing = 1;
    CHECK(text_to_mesh::in_words(r, false, "", U"\u8336\u0301") ==
          "the font has no glyph for 2 of 9 characters (U+8336 \xE8\x8C\xB6, U+0301); the first is at byte 1 of the "
          "text. Give another --font, or add a font with --fallback.\n");
    CHECK(text_to_mesh::in_words(r, true, "", U"abcdefgh") ==
          "no font has a glyph for 2 of 9 characters (U+0061 a, U+0062 b, U+0063 c, U+0064 d, U+0065 e, U+0066 f, "
          "U+0067 g, U+0068 h); the first is at byte 1 of the text. Add another font with --fallback.\n");
    CHECK(text_to_mesh::in_words(r, true, "", U"abcdefghij").find("U+0068 h and 2 more); the first") < 300);
}
