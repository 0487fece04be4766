// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/impl/character.hpp>

using namespace typemesh;

TEST_CASE("some characters have the properties that the standard names", "[character]")
{
    CHECK(character_of(U'A').bidi == bidi_class::l);
    CHECK(character_of(U'A').line == line_class::al);
    CHECK(character_of(U'A').grapheme == grapheme_class::other);
    CHECK(character_of(U'A').orientation == vertical_orientation::rotated);
    CHECK(character_of(U'(').bracket == bracket_kind::opening);
    CHECK(character_of(U')').bracket == bracket_kind::closing);
    CHECK(character_of(U')').line == line_class::cp);
    CHECK(character_of(0xFF08).line == line_class::op_wide);
    CHECK(character_of(0x05D0).bidi == bidi_class::r);
    CHECK(character_of(0x05D0).line == line_class::hl);
    CHECK(character_of(0x0661).bidi == bidi_class::an);
    CHECK(character_of(0x0301).grapheme == grapheme_class::extend);
    CHECK(character_of(0x0E01).line == line_class::sa);
    CHECK(character_of(0x0E31).line == line_class::sa_mark);
    CHECK(character_of(0x4E00).orientation == vertical_orientation::upright);
    CHECK(character_of(0x1F600).grapheme == grapheme_class::pictographic);
    CHECK(character_of(0x1F1E6).grapheme == grapheme_class::regional_indicator);
    CHECK(character_of(0x1FAFF).line == line_class::picto);
    CHECK(character_of(0x3041).line == line_class::cj);
    CHECK(character_of(0x301C).orientation == vertical_orientation::transformed_rotated);
    CHECK(character_of(0x3001).orientation == vertical_orientation::transformed_upright);
}

TEST_CASE("an unassigned character has the properties of its block", "[character]")
{
    CHECK(character_of(0x05FF).bidi == bidi_class::r);
    CHECK(character_of(0x07BF).bidi == bidi_class::al);
    CHECK(character_of(0x20CF).bidi == bidi_class::et);
    CHECK(character_of(0x10FFFF).bidi == bidi_class::bn);
    CHECK(character_of(0x0378).line == line_class::al);
    CHECK(character_of(0x3FFFD).line == line_class::id);
}

TEST_CASE("a number that is no code point has the properties of U+FFFD", "[character]")
{
    const character none = character_of(0xFFFFFFFF), replacement = character_of(0xFFFD);
    CHECK(none.bidi == replacement.bidi);
    CHECK(none.line == replacement.line);
    CHECK(none.grapheme == replacement.grapheme);
}
