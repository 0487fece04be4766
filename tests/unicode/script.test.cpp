// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/script.hpp>

using namespace typemesh;

TEST_CASE("a letter has the script of its alphabet", "[script]")
{
    static_assert(script_tag("Latn") == 0x4C61746E);
    for (const char32_t c : {U'a', U'Z', U'\u00E9'}) CHECK(script_set::of(c).tag() == script_tag("Latn"));
    CHECK(script_set::of(0x05D0).tag() == script_tag("Hebr"));
    CHECK(script_set::of(0x4E00).tag() == script_tag("Hani"));
    CHECK(script_set::of(0x1E94B).tag() == script_tag("Adlm"));
    CHECK(script_set::of(0x0483).tag() == script_tag("Cyrl"));  // also in Old Permic
    CHECK(script_set::of(0x0301).tag() == script_tag("Latn"));  // shared with Cherokee, Cyrillic and others
}

TEST_CASE("a character of all scripts has the script Zyyy", "[script]")
{
    for (const char32_t c : {U' ', U'1', U'[', U'`', U'{', U'@', char32_t{0}, char32_t{0x034F}, char32_t{0xE000},
                             char32_t{0x0378}, char32_t{0x10FFFF}, char32_t{0xFFFFFFFF}}) {
        CHECK(script_set::of(c).universal());
        CHECK(script_set::of(c).tag() == script_tag("Zyyy"));
    }
}

TEST_CASE("sets of scripts are intersected", "[script]")
{
    const script_set kana = script_set::of(0x30FC), katakana = script_set::of(0x30A2), latin = script_set::of(U'a');
    CHECK(kana.tag() == script_tag("Hira"));
    script_set both = kana;
    REQUIRE(both.intersect(katakana));
    CHECK(both.tag() == script_tag("Kana"));
    CHECK_FALSE(both.intersect(latin));
    CHECK(both.tag() == script_tag("Kana"));
    CHECK(both.intersect(script_set{}));
    CHECK(both.tag() == script_tag("Kana"));
    script_set all;
    CHECK(all.intersect(latin));
    CHECK(all.tag() == script_tag("Latn"));
}

TEST_CASE("Han, the kana and Bopomofo are set as one script, and no others", "[script]")
{
    const std::uint32_t east[] = {script_tag("Hani"), script_tag("Hira"), script_tag("Kana"), script_tag("Bopo")};
    for (const std::uint32_t a : east) {
        for (const std::uint32_t b : east) CHECK(set_as_one(a, b));
        for (const std::uint32_t b : {script_tag("Hang"), script_tag("Latn"), script_tag("Zyyy"), std::uint32_t{0}}) {
            CHECK_FALSE(set_as_one(a, b));
            CHECK_FALSE(set_as_one(b, a));
        }
    }
    CHECK_FALSE(set_as_one(script_tag("Latn"), script_tag("Grek")));
    CHECK(set_as_one(script_tag("Latn"), script_tag("Latn")));
}

TEST_CASE("a character's script is in the character's set of scripts", "[script]")
{
    for (char32_t c = 0; c < 0x110000; ++c) {
        script_set set = script_set::of(c);
        const std::uint32_t tag = set.tag();
        if (!set.intersect(script_set::of(c)) || set.tag() != tag) FAIL("character " << std::uint32_t{c});
    }
}
