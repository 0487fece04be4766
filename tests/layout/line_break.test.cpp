// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/line_break.hpp>

#include <string>

using namespace typemesh;

TEST_CASE("the mandatory breaks of UAX #14 are found in both encodings, and nothing else", "[layout][line_break]")
{
    struct expected {
        std::string eight;
        std::u16string sixteen;
    };
    for (const auto& [eight, sixteen] : {expected{"\n", u"\n"},
                                         {"\r", u"\r"},
                                         {"\r\n", u"\r\n"},
                                         {"\v", u"\v"},
                                         {"\f", u"\f"},
                                         {"\xC2\x85", u"\u0085"},
                                         {"\xE2\x80\xA8", u"\u2028"},
                                         {"\xE2\x80\xA9", u"\u2029"}}) {
        CHECK(line_break_at(eight, 0) == eight.size());
        CHECK(line_break_at(sixteen, 0) == sixteen.size());
        CHECK(line_break_at(eight + "x", 0) == eight.size());
        CHECK(line_break_at(std::string{"x"} + eight, 0) == 0);
        CHECK(line_break_at(sixteen + u"x", 0) == sixteen.size());
    }
    CHECK(line_break_at("\n\r", 0) == 1);
    CHECK(line_break_at("\n\n", 0) == 1);
    for (const char* other : {"\t", " ", "a", "\x08", "\x0E", "\xC2\xA0", "\xC2\x84", "\xE2\x80\xA7", "\xE2\x80\xAA",
                              "\xE2\x80", "\xE2", "\xC2", "\x85"})
        CHECK(line_break_at(other, 0) == 0);
    CHECK(line_break_at(u"\u2027", 0) == 0);
    CHECK(line_break_at(u"\u0A0D", 0) == 0);
}
