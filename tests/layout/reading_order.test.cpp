// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/reading_order.hpp>

#include <string>

using namespace typemesh;

namespace {

line_reading read_all(text_view text) { return read_line(text, 0, text.size()); }
std::size_t number_in(text_view text) { return find_number(text, 0, text.size()); }

constexpr std::size_t nowhere = line_reading::nowhere;

}  // namespace

TEST_CASE("characters read as Unicode's bidirectional classes say", "[layout][reading_order]")
{
    struct expected {
        reading what;
        std::u32string_view characters;
    };
    for (const auto& [what, characters] :
         {expected{reading::to_the_right,
                   U"azAZ\u00AA\u00E9\u03B1\u0416\u0531\u0905\u0E01\u10D0\u1100\u3042\u30A2\u4E16\uAC00\uA000\uFF21"
                   U"\U00020000\u200E"},
          {reading::to_the_left,
           U"\u05D0\u05EA\u0627\u064A\u0710\u0780\u07CA\u07C1\u0800\u08A0\u200F\u202B\u202E\u2067\uFB1D\uFB50\uFE8D"
           U"\U00010800\U0001E900\u061F"},
          {reading::digit, U"09\u0660\u0669\u06F0\u00B2\u2070\uFF10\U0001D7CE"},
          {reading::separator, U".,:/+-\u00A0\u060C\u2212"},
          {reading::terminator, U"%$#\u00B0\u20AC\u066A"},
          {reading::neutral,
           U" !?()[]&*;\t\u00AB\u0300\u200B\u2014\u2190\u2500\u3000\u3001\uFF01\U0001F600\uFFFD\uFE0F"}})
        for (const char32_t c : characters) {
            INFO(static_cast<std::uint32_t>(c));
            CHECK(reading_of(c) == what);
        }
}

TEST_CASE("the quick answer for right-to-left is the table's", "[layout][reading_order]")
{
    std::size_t wrong = 0, left = 0;
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        wrong += reads_to_the_left(c) != (reading_of(c) == reading::to_the_left);
        left += reads_to_the_left(c);
    }
    CHECK(wrong == 0);
    CHECK(left > 2000);
}

TEST_CASE("a line tells where each direction was met first", "[layout][reading_order]")
{
    CHECK(read_all("12 + 3 = 15!").to_the_right == nowhere);
    CHECK(read_all("12 + 3 = 15!").to_the_left == nowhere);
    CHECK(read_all("  abc").to_the_right == 2);
    CHECK(read_all("\u05D0\u05D1 abc").to_the_left == 0);
    CHECK(read_all("\u05D0\u05D1 abc").to_the_right == 5);
    CHECK(read_all(u"abc \u0627").to_the_left == 4);
    CHECK(read_all("a\xFF\xFE").invalid.count == 2);
    CHECK(read_all("a\xFF\xFE").invalid.first == 1);
}

TEST_CASE("a number is what would be wrong the other way round", "[layout][reading_order]")
{
    CHECK(number_in("a 7 b") == nowhere);
    CHECK(number_in("7. 8, 9") == nowhere);
    CHECK(number_in("(3)") == nowhere);
    CHECK(number_in("+3") == nowhere);
    CHECK(number_in("ab 42") == 3);
    CHECK(number_in("ab 3.5") == 3);
    CHECK(number_in("12:30") == 0);
    CHECK(number_in("a 5%") == 2);
    CHECK(number_in("a $5") == 2);
    CHECK(number_in("1..2") == nowhere);
    CHECK(number_in("\u0661\u0662") == 0);
    CHECK(number_in("\u05D0 \u0661\u066B\u0662") == 3);
}

TEST_CASE("invalid places are counted and the first is told in the caller's units", "[layout][reading_order]")
{
    const invalid_places none = read_line(text_view{"gr\xC3\xBC\xC3\x9F"}, 0, 6).invalid;
    CHECK(none.count == 0);
    CHECK(none.first == no_cluster);

    const std::string_view broken =
        "ab\xFF"
        "c\xE2\x82";
    const invalid_places two = read_line(broken, 0, 6).invalid;
    CHECK(two.count == 2);
    CHECK(two.first == 2);

    const std::u16string lone{u'a', u'b', 0xD800};
    CHECK(read_line(lone, 0, 3).invalid.first == 2);
    CHECK(read_line(lone, 0, 2).invalid.count == 0);
}
