// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/paragraph.hpp>

#include <string>
#include <utility>

using namespace typemesh;

namespace {

/// What the lines of a text show, as letters from left to right, and how wide they are.
struct shown_lines {
    test::toy_shaper font;
    paragraph<test::toy_shaper> words{font};
    glyph_run run;

    shown_lines(text_view text, const layout_options& options, double letter_spacing = 0.0)
    {
        REQUIRE(words.set(text, {.letter_spacing = letter_spacing}));
        REQUIRE(words.lay_out(options, run));
    }
    [[nodiscard]] std::u16string line(std::size_t k) const
    {
        std::u16string shown;
        for (const placed_glyph& g : run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count))
            shown.push_back(static_cast<char16_t>(g.id));
        return shown;
    }
    [[nodiscard]] cluster_id dots() const
    {
        for (const placed_glyph& g : run.glyphs)
            if (g.id == '.') return g.cluster;
        return no_cluster;
    }
};

constexpr ellipsis_place all_places[] = {ellipsis_place::end, ellipsis_place::middle, ellipsis_place::start};

}  // namespace

TEST_CASE("an elided line begins where the one before ended, in the midst of a ligature, too", "[paragraph]")
{
    const shown_lines p{"xxxfiyyyyyy", {.width = 2.0, .max_lines = 2, .ellipsis = ".."}};
    CHECK(p.line(0) == u"xxxf");
    CHECK(p.line(1) == u"iy..");
}

TEST_CASE("no text is shown twice where a line gives way at its start or in its middle", "[paragraph]")
{
    for (const auto& [place, line] : {std::pair{ellipsis_place::end, u"Dona.."},
                                      {ellipsis_place::middle, u"Do..ff"},
                                      {ellipsis_place::start, u"..hiff"}}) {
        const shown_lines p{"Donaudampfschiff ab",
                            {.width = 3.0, .wrap = wrap_mode::word, .ellipsis = "..", .elide = place}};
        REQUIRE(p.run.lines.size() == 2);
        std::u16string shown = p.line(0);
        while (shown.back() == u' ') shown.pop_back();
        CHECK(shown == line);
        CHECK(p.line(1) == u"ab");
    }
}

TEST_CASE("a line of which nothing is dropped but what is behind it has its ellipsis at the end", "[paragraph]")
{
    for (const ellipsis_place place : all_places) {
        const shown_lines p{"one\ntwo", {.max_lines = 1, .ellipsis = "..", .elide = place}};
        CHECK(p.line(0) == u"one..");
        CHECK(p.dots() == 4);
    }
}

TEST_CASE("elided lines fit, whatever tabs and distances between letters do", "[paragraph]")
{
    const std::u16string text = u"a\tfi bc\tAVAVA\tx\u05D0\u05D1\td";
    for (const ellipsis_place place : all_places)
        for (const double spacing : {0.0, 0.3, -0.1})
            for (double width = 1.7; width < 9.0; width += 0.37) {
                const shown_lines p{
                    text,
                    {.width = width, .wrap = wrap_mode::none, .max_lines = 1, .ellipsis = "..", .elide = place},
                    spacing};
                CHECK(p.run.lines[0].advance <= 1000.0 * width);
            }
}

TEST_CASE("no hyphen stands before an ellipsis", "[paragraph]")
{
    for (const double width : {3.2, 3.6, 4.0})
        for (const std::uint32_t most : {1u, 2u}) {
            const shown_lines p{u"exam\u00ADple\u00ADless words",
                                {.width = width, .max_lines = most, .ellipsis = ".."}};
            const std::u16string shown = p.line(p.run.lines.size() - 1);
            CHECK(shown.find(u'.') != std::u16string::npos);
            CHECK(shown.find(u'\u2010') == std::u16string::npos);
        }
    const shown_lines p{u"exam\u00ADple", {.width = 3.2, .max_lines = 1, .ellipsis = ".."}};
    CHECK(p.line(0) == u"exam..");
}

TEST_CASE("an ellipsis stands between what is read before and behind it", "[paragraph]")
{
    // In an English line the Hebrew word runs to the left through it; at the end it stands at the line's end.
    const std::u16string text = u"ab \u05D0\u05D1\u05D2\u05D3\u05D4\u05D5\u05D6\u05D7";
    const auto elided = [&](ellipsis_place place) {
        return shown_lines{text, {.width = 5.0, .wrap = wrap_mode::none, .ellipsis = "..", .elide = place}}.line(0);
    };
    CHECK(elided(ellipsis_place::end) == u"ab \u05D4\u05D3\u05D2\u05D1\u05D0..");
    CHECK(elided(ellipsis_place::middle) == u"ab \u05D7\u05D6\u05D5\u05D4..\u05D0");
    CHECK(elided(ellipsis_place::start) == u"..\u05D7\u05D6\u05D5\u05D4\u05D3\u05D2\u05D1\u05D0");
}

TEST_CASE("an ellipsis between letters of one direction is read as they are", "[paragraph]")
{
    const auto elided = [](text_view text, ellipsis_place place) {
        return shown_lines{text, {.width = 5.0, .wrap = wrap_mode::none, .ellipsis = "<.", .elide = place}}.line(0);
    };
    const std::u16string english = u"ab \u05D0\u05D1\u05D2\u05D3\u05D4\u05D5\u05D6\u05D7";
    CHECK(elided(english, ellipsis_place::middle) == u"ab \u05D7\u05D6\u05D5\u05D4.<\u05D0");
    CHECK(elided(english, ellipsis_place::end) == u"ab \u05D4\u05D3\u05D2\u05D1\u05D0<.");
    const std::u16string hebrew = u"\u05D0\u05D1 abcdefghij";
    CHECK(elided(hebrew, ellipsis_place::middle) == u"a<.ghij \u05D1\u05D0");
    CHECK(elided(hebrew, ellipsis_place::end) == u".<abcde \u05D1\u05D0");
}

TEST_CASE("an ellipsis of letters is read in their own direction", "[paragraph]")
{
    const std::u16string text = u"\u05D0\u05D1\u05D2\u05D3\u05D4\u05D5";
    const shown_lines p{text, {.width = 2.5, .wrap = wrap_mode::none, .ellipsis = "[x-z]"}};
    CHECK(p.line(0) == u"]x-z[");  // the brackets belong to the line, a font mirrors them
}

TEST_CASE("a column gives way, too", "[paragraph]")
{
    test::toy_shaper font;
    paragraph words{font};
    glyph_run run;
    REQUIRE(words.set("abcdef", {.direction = direction::top_to_bottom}));
    REQUIRE(words.lay_out({.width = 2.0, .wrap = wrap_mode::none, .ellipsis = ".:"}, run));
    REQUIRE(run.glyphs.size() == 4);
    const glyph_id shown[] = {'a', 'b', '.', ':'};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(run.glyphs[i].id == shown[i]);
        CHECK(run.glyphs[i].origin == point{-250.0, -500.0 * static_cast<double>(i)});
    }
}

TEST_CASE("an ellipsis stands for the first grapheme that is dropped", "[paragraph]")
{
    const auto place_of = [](ellipsis_place place) {
        return shown_lines{"abcdefgh", {.width = 3.0, .wrap = wrap_mode::none, .ellipsis = "..", .elide = place}}
            .dots();
    };
    CHECK(place_of(ellipsis_place::end) == 4);
    CHECK(place_of(ellipsis_place::middle) == 2);
    CHECK(place_of(ellipsis_place::start) == 0);
}
