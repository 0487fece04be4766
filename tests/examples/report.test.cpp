// SPDX-License-Identifier: MIT

#include "text_to_mesh/report.hpp"

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("text_to_mesh says of a report what is lost and what is narrowed, a line each, and nothing of what is whole",
          "[text_to_mesh]")
{
    text_report r;
    r.glyphs = 9;
    r.blank = 2;
    CHECK(text_to_mesh::in_words(r).empty());
    CHECK_FALSE(text_to_mesh::name_losses(r));
    r.narrowed = 3;
    r.first_narrowed = 5;
    CHECK(text_to_mesh::in_words(r) ==
          "text_to_mesh: edges of 3 of 9 glyphs have moved less than --bevel, --outline or --embolden ask for; the "
          "first is at "
          "byte 5 of the text.\n");
    text_report emoji;
    emoji.glyphs = 3;
    emoji.missing = 2;
    emoji.first_missing = 0;
    emoji.parted = 1;
    emoji.first_parted = 4;
    CHECK(text_to_mesh::in_words(emoji, true, "line 3: ") ==
          "line 3: no font has a glyph for 2 of 3 characters; the first is at byte 0 of the text.\n"
          "line 3: 1 of them is an emoji whose parts are drawn one by one, as no font has a glyph for the whole; the "
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
          "text_to_mesh: the font has no glyph for 1 of 9 characters; the first is at byte 7 of the text.\n"
          "text_to_mesh: the text is not valid UTF-8 at 1 place; the first is at byte 8 of the text.\n"
          "text_to_mesh: no dictionary tells where the words end in 2 runs of Thai, Lao, Khmer, Burmese or the like, "
          "so lines end there only where they must; the first is at byte 4 of the text.\n"
          "text_to_mesh: edges of 3 of 9 glyphs have moved less than --bevel, --outline or --embolden ask for; the "
          "first is at "
          "byte 5 of the text.\n"
          "text_to_mesh: bevels meet in a ridge on 2 pieces of glyphs smaller than the tolerance; the first is at byte "
          "6 of the text.\n");
}
