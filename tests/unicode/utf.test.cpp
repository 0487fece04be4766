// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/encoded.hpp"

#include <typemesh/unicode/utf.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

using test::utf16_of;
using test::utf8_of;

/// All code points of a text, with U+FFFD for what is invalid.
std::u32string read(text_view text)
{
    std::u32string all;
    for (std::size_t i = 0; i < text.size();) {
        const code_point c = decode(text, i);
        REQUIRE(c.next > i);
        REQUIRE(c.next <= text.size());
        REQUIRE((c.valid || c.value == 0xFFFD));
        all += c.value;
        i = c.next;
    }
    return all;
}

constexpr char32_t bad = 0xFFFD;

}  // namespace

TEST_CASE("every code point survives UTF-8 and UTF-16", "[layout][utf]")
{
    std::size_t wrong = 0;
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        if (c >= 0xD800 && c <= 0xDFFF) continue;
        const std::string eight = utf8_of({c});
        const std::u16string sixteen = utf16_of({c});
        const code_point a = decode(eight, 0), b = decode(sixteen, 0);
        wrong +=
            !(a.valid && a.value == c && a.next == eight.size() && b.valid && b.value == c && b.next == sixteen.size());
    }
    CHECK(wrong == 0);
}

TEST_CASE("invalid UTF-8 becomes U+FFFD for each maximal subpart, as the standard shows", "[layout][utf]")
{
    CHECK(read("\xC0\xAF\xE0\x80\xBF\xF0\x81\x82\x41") == std::u32string{bad, bad, bad, bad, bad, bad, bad, bad, U'A'});
    CHECK(read("\xED\xA0\x80\xED\xBF\xBF\xED\xAF\x41") == std::u32string{bad, bad, bad, bad, bad, bad, bad, bad, U'A'});
    CHECK(read("\xF4\x91\x92\x93\xFF\x41\x80\xBF\x42") ==
          std::u32string{bad, bad, bad, bad, bad, U'A', bad, bad, U'B'});
    CHECK(read("\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41") == std::u32string{bad, bad, bad, bad, U'A'});
}

TEST_CASE("a code point cut off at the end is one U+FFFD", "[layout][utf]")
{
    for (const char32_t c : {U'\u00E9', U'\u4E16', U'\U0001F600'}) {
        const std::string whole = utf8_of({c});
        for (std::size_t n = 1; n < whole.size(); ++n) CHECK(read(whole.substr(0, n)) == std::u32string{bad});
        CHECK(decode(whole, 0, 1).next == 1);
    }
    CHECK(read(std::u16string{0xD83D}) == std::u32string{bad});
}

TEST_CASE("each surrogate without a partner is one U+FFFD", "[layout][utf]")
{
    CHECK(read(std::u16string{0xDC00, 0xD800, u'a', 0xD83D, 0xDE00, 0xD800, 0xD800}) ==
          std::u32string{bad, bad, U'a', U'\U0001F600', bad, bad});
}

TEST_CASE("decode() moves on and stays inside for all sequences of three critical bytes", "[layout][utf]")
{
    const std::vector<unsigned> bytes{0x00, 0x41, 0x7F, 0x80, 0x8F, 0x90, 0x9F, 0xA0, 0xBF,
                                      0xC0, 0xC1, 0xC2, 0xDF, 0xE0, 0xE1, 0xEC, 0xED, 0xEE,
                                      0xEF, 0xF0, 0xF1, 0xF3, 0xF4, 0xF5, 0xF8, 0xFE, 0xFF};
    std::size_t wrong = 0;
    for (const unsigned a : bytes)
        for (const unsigned b : bytes)
            for (const unsigned c : bytes) {
                const char units[] = {static_cast<char>(a), static_cast<char>(b), static_cast<char>(c)};
                const text_view text{std::string_view{units, 3}};
                for (std::size_t i = 0; i < 3;) {
                    const code_point p = decode(text, i);
                    wrong += !(p.next > i && p.next <= 3);
                    if (p.valid)
                        wrong += utf8_of({p.value}) != std::string(units + i, p.next - i);  // only one spelling
                    i = p.next;
                }
            }
    CHECK(wrong == 0);
}
