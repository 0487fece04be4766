// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/encoded.hpp"

#include <typemesh/layout/impl/long_graphemes.hpp>

#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

std::vector<shaping_part> parts_of(text_view text)
{
    std::vector<shaping_part> parts;
    const auto add = [&parts](const shaping_part& p) {
        parts.push_back(p);
        return error{};
    };
    REQUIRE_FALSE(cut_long_graphemes(text, 0, text.size(), add));
    return parts;
}

}  // namespace

TEST_CASE("a letter with many marks is cut after so many characters, and its parts are one cluster", "[layout]")
{
    const std::u16string text = u"xa" + std::u16string(600, u'\u0301') + u"b";
    const auto parts = parts_of(text);
    REQUIRE(parts.size() == 3);
    const std::size_t ends[] = {257, 513, 603};
    for (std::size_t k = 0; k < 3; ++k) CHECK(parts[k].last == ends[k]);
    CHECK(parts[0].cluster(0) == 0);
    CHECK(parts[1].first == 257);
    CHECK(parts[1].cluster(400) == 1);
    CHECK(parts[2].cluster(601) == 1);
    CHECK(parts[2].cluster(602) == 602);
}

TEST_CASE("text without such letters is shaped in one piece, however long it is", "[layout]")
{
    CHECK(parts_of(std::u16string(10000, u'a')).size() == 1);
    CHECK(parts_of(std::u16string(300, u'\u0301')).size() == 2);
    CHECK(parts_of(u"a" + std::u16string(255, u'\u0301')).size() == 1);
    CHECK(parts_of(u"").size() == 1);
    std::u16string zalgo;
    for (int k = 0; k < 100; ++k) zalgo += u"z" + std::u16string(100, u'\u0316');
    CHECK(parts_of(zalgo).size() == 1);
}

TEST_CASE("parts are all of the text, no part has more of a grapheme than allowed, and each is cut where it must be",
          "[layout]")
{
    std::mt19937 random{3};
    const std::u32string letters = U"ab\u0301\u0301\u0301\u0316\u200D\u0915\u094D\u0937\U0001F468";
    for (int repeat = 0; repeat < 300; ++repeat) {
        std::u32string text;
        while (text.size() < 2000)
            text.append(1 + random() % (random() % 3 == 0 ? 700 : 3), letters[random() % letters.size()]);
        std::u16string units;
        std::vector<std::size_t> begins, starts;  // of characters, and of their graphemes, in units
        grapheme_boundaries boundary;
        for (const char32_t c : text) {
            begins.push_back(units.size());
            starts.push_back(boundary(character_of(c).grapheme) ? units.size() : starts.back());
            test::append_utf16(units, c);
        }
        std::size_t at = 0, k = 0;
        for (const shaping_part& p : parts_of(units)) {
            REQUIRE(p.first == at);
            std::size_t count = 0;
            for (; k < begins.size() && begins[k] < p.last; ++k) {
                count = begins[k] == starts[k] ? 1 : count + 1;
                CHECK(count <= max_grapheme);
                CHECK(p.cluster(begins[k]) == (starts[k] < p.first ? starts[k] : begins[k]));
            }
            if (p.last < units.size()) CHECK(count == max_grapheme);
            at = p.last;
        }
        CHECK(at == units.size());
    }
}
