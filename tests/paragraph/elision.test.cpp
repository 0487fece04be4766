// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <string>
#include <utility>

using namespace typemesh;

namespace {

using elided_text = test::laid_paragraph<>;

cluster_id cluster_of_dots(const elided_text& p)
{
    for (const placed_glyph& g : p.run.glyphs)
        if (g.id == '.') return g.cluster;
    return no_cluster;
}

/// A line that gives way where it is said, with ".." or another ellipsis of that width.
layout_options eliding(double width, ellipsis_place place, text_view ellipsis = "..")
{
    return {.width = width, .wrap = wrap_mode::none, .ellipsis = ellipsis, .elide = place};
}

constexpr ellipsis_place all_places[] = {ellipsis_place::end, ellipsis_place::middle, ellipsis_place::start};

}  // namespace

TEST_CASE("an elided line begins where the one before ended, in the midst of a ligature, too", "[paragraph]")
{
    const elided_text p{"xxxfiyyyyyy", {.width = 2.0, .max_lines = 2, .ellipsis = ".."}};
    CHECK(p.lines() == std::vector<std::u16string>{u"xxxf", u"iy.."});
}

TEST_CASE("no text is shown twice where a line gives way at its start or in its middle", "[paragraph]")
{
    for (const auto& [place, line] : {std::pair{ellipsis_place::end, u"Dona.."},
                                      {ellipsis_place::middle, u"Do..ff "},
                                      {ellipsis_place::start, u"..hiff "}}) {
        const elided_text p{"Donaudampfschiff ab",
                            {.width = 3.0, .wrap = wrap_mode::word, .ellipsis = "..", .elide = place}};
        CHECK(p.lines() == std::vector<std::u16string>{line, u"ab"});
    }
}

TEST_CASE("a line that loses only what follows it has its ellipsis at the end", "[paragraph]")
{
    for (const ellipsis_place place : all_places) {
        const elided_text p{"one\ntwo", {.max_lines = 1, .ellipsis = "..", .elide = place}};
        CHECK(p.line(0) == u"one..");
        CHECK(cluster_of_dots(p) == 4);
    }
}

TEST_CASE("elided lines fit, whatever tabs and distances between letters do", "[paragraph]")
{
    for (const ellipsis_place place : all_places)
        for (const double spacing : {0.0, 0.3, -0.1})
            for (double width = 1.7; width < 9.0; width += 0.37) {
                layout_options how = eliding(width, place);
                how.max_lines = 1;
                const elided_text p{u"a\tfi bc\tAVAVA\tx\u05D0\u05D1\td", how, {.letter_spacing = spacing}};
                CHECK(p.run.lines[0].advance <= 1000.0 * width);
            }
}

TEST_CASE("no hyphen stands before an ellipsis", "[paragraph]")
{
    for (const double width : {3.2, 3.6, 4.0})
        for (const std::uint32_t most : {1u, 2u}) {
            const elided_text p{u"exam\u00ADple\u00ADless words",
                                {.width = width, .max_lines = most, .ellipsis = ".."}};
            const std::u16string shown = p.lines().back();
            CHECK(shown.find(u'.') != std::u16string::npos);
            CHECK(shown.find(u'\u2010') == std::u16string::npos);
        }
    const elided_text p{u"exam\u00ADple", {.width = 3.2, .max_lines = 1, .ellipsis = ".."}};
    CHECK(p.line(0) == u"exam..");
}

TEST_CASE("an ellipsis stands between what is read before and after it, and is read as the letters on both sides are",
          "[paragraph]")
{
    // In an English line the Hebrew word runs to the left through it; at the end it stands at the line's end.
    const std::u16string english = u"ab \u05D0\u05D1\u05D2\u05D3\u05D4\u05D5\u05D6\u05D7";
    const std::u16string hebrew = u"\u05D0\u05D1 abcdefghij";
    struct {
        const std::u16string& text;
        ellipsis_place place;
        const char* ellipsis;
        std::u16string shown;
    } const cases[] = {{english, ellipsis_place::end, "..", u"ab \u05D4\u05D3\u05D2\u05D1\u05D0.."},
                       {english, ellipsis_place::middle, "..", u"ab \u05D7\u05D6\u05D5\u05D4..\u05D0"},
                       {english, ellipsis_place::start, "..", u"..\u05D7\u05D6\u05D5\u05D4\u05D3\u05D2\u05D1\u05D0"},
                       {english, ellipsis_place::middle, "<.", u"ab \u05D7\u05D6\u05D5\u05D4.<\u05D0"},
                       {english, ellipsis_place::end, "<.", u"ab \u05D4\u05D3\u05D2\u05D1\u05D0<."},
                       {hebrew, ellipsis_place::middle, "<.", u"a<.ghij \u05D1\u05D0"},
                       {hebrew, ellipsis_place::end, "<.", u".<abcde \u05D1\u05D0"}};
    for (const auto& [text, place, ellipsis, shown] : cases) {
        CAPTURE(static_cast<int>(place), ellipsis);
        CHECK(elided_text{text, eliding(5.0, place, ellipsis)}.line(0) == shown);
    }
}

TEST_CASE("an ellipsis of letters is read in their own direction", "[paragraph]")
{
    const elided_text p{u"\u05D0\u05D1\u05D2\u05D3\u05D4\u05D5", eliding(2.5, ellipsis_place::end, "[x-z]")};
    CHECK(p.line(0) == u"]x-z[");  // the brackets belong to the line, a font mirrors them
}

TEST_CASE("a column gives way, too", "[paragraph]")
{
    const elided_text p{"abcdef", eliding(2.0, ellipsis_place::end, ".:"), {.direction = direction::top_to_bottom}};
    CHECK(p.line(0) == u"ab.:");
    for (std::size_t i = 0; i < 4; ++i) CHECK(p.run.glyphs[i].origin == point{-250.0, -500.0 * static_cast<double>(i)});
}

TEST_CASE("an ellipsis stands for the first grapheme that is dropped", "[paragraph]")
{
    for (const auto& [place, cluster] :
         {std::pair{ellipsis_place::end, 4u}, {ellipsis_place::middle, 2u}, {ellipsis_place::start, 0u}})
        CHECK(cluster_of_dots(elided_text{"abcdefgh", eliding(3.0, place)}) == cluster);
}
