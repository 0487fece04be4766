// SPDX-License-Identifier: MIT
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"

#include <cstdint>
#include <string>

using namespace typemesh;

namespace {

struct emoji_text {
    const char16_t* text;
    std::uint32_t parted;
    cluster_id first;
};

// Symbola draws the parts and has no glyph for a whole.
constexpr emoji_text texts[] = {
    {u"\U0001F44D\U0001F3FDx", 1, 0},
    {u"x\U0001F1E9\U0001F1EA\U0001F1EB\U0001F1F7", 2, 1},
    {u"ab\U0001F468\u200D\U0001F469\u200D\U0001F467", 1, 2},
    {u"\U0001F469\U0001F3FD\u200D\u2764\uFE0F\u200D\U0001F468", 1, 0},
    {u"\U0001F44D\U0001F44D \u2764\uFE0F \U0001F1E9 1\uFE0F\u20E3 e\u0301", 0, no_cluster},
    {u"\u05D0 \U0001F44D\U0001F3FD \u05D1", 1, 2},
};

template <class Font>
void check(Font& font, const emoji_text& t)
{
    for (const direction way : {direction::automatic, direction::top_to_bottom}) {
        glyph_run run = test::shaped(font, t.text, {.direction = way});
        CHECK(run.missing == 0);
        CHECK(run.parted == t.parted);
        CHECK(run.first_parted == t.first);
        text_mesher mesher{font};
        auto plan = test::required(mesher.plan(run, {.tolerance = quality::low}));
        CHECK(plan->report().missing == t.parted);
        CHECK(plan->report().parted == t.parted);
        CHECK(plan->report().first_missing == t.first);
        CHECK(plan->report().complete() == (t.parted == 0));

        paragraph words{font};
        REQUIRE(words.set(t.text, {.direction = way}));
        REQUIRE(words.lay_out({}, run));
        CHECK(run.parted == t.parted);
        CHECK(run.first_parted == t.first);
    }
}

}  // namespace

TEST_CASE("an emoji that has fallen apart is reported as missing, by a layout and by a paragraph", "[harfbuzz][emoji]")
{
    auto symbola = test::required(harfbuzz_font::open(font_file("truetype/ancient-scripts/Symbola_hint.ttf").c_str()));
    auto latin = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    const emoji_text& t = texts[GENERATE(range(0u, 6u))];
    if (t.text[0] != u'\u05D0') check(*symbola, t);  // it has no Hebrew
    font_cascade both{*latin, *symbola};
    if (t.text[0] != u'\u05D0') check(both, t);
    font_cascade turned{*symbola, *latin};
    check(turned, t);
}

TEST_CASE("an emoji that a line has dropped is not reported", "[harfbuzz][emoji]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/ancient-scripts/Symbola_hint.ttf").c_str()));
    paragraph words{*font};
    glyph_run run = test::laid_out(words, "one two \U0001F44D\U0001F3FD", {}, {.width = 4.0, .max_lines = 1});
    CHECK(run.parted == 0);
    REQUIRE(words.lay_out({.width = 4.0}, run));
    CHECK(run.parted == 1);
}
