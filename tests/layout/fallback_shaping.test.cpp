// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/encoded.hpp"
#include "support/toy_covering_font.hpp"

#include <typemesh/layout/fallback_shaping.hpp>
#include <typemesh/layout/layout.hpp>

#include <iterator>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;
using test::toy_covering_font;

namespace {

/// Faces of a thousand units to the em, and the faces that are found for what they lack.
struct toy_faces {
    std::vector<toy_covering_font> fonts;
    std::vector<toy_covering_font> more = {};
    std::size_t asked = 0;
    std::uint32_t needs_shaping = 99;

    std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(fonts.size()); }
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
    {
        if (item.face == needs_shaping) return error::needs_shaping;
        const std::size_t before = glyphs.size();
        const error e = fonts[item.face].shape(text, item, how, glyphs);
        for (shaped_glyph& g : glyphs.view().subspan(before)) g.face = item.face;
        return e;
    }
    double units_per_em() const noexcept { return fonts[0].units_per_em(); }
    double column_middle() const noexcept { return 200.0; }
    bool has_vertical_form(char32_t) const noexcept { return false; }
};

/// A font of several faces.
struct filling_font : toy_faces {
    fallback_shaping shaping{};

    line_metrics metrics(direction) const noexcept { return {700.0, -200.0, 100.0}; }
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
    {
        return shaping.shape(static_cast<toy_faces&>(*this), text, item, how, glyphs);
    }
};

/// The same, with `more` to be found.
struct finding_faces : toy_faces {
    result<std::uint32_t> find(text_view text, text_range range, std::uint32_t, std::string_view) noexcept
    {
        ++asked;
        for (std::size_t k = 0; k < more.size(); ++k) {
            bool all = true;
            for (std::size_t i = range.first; i < range.last;) {
                const code_point c = decode(text, i);
                all = all && (more[k].covers(c.value) || is_default_ignorable(c.value));
                i = c.next;
            }
            if (!all) continue;
            for (std::uint32_t face = 0; face < face_count(); ++face)
                if (fonts[face].has == more[k].has) return face;
            fonts.push_back(more[k]);
            return face_count() - 1;
        }
        return fallback_shaping::no_face;
    }
};

struct made_item {
    buffer<shaped_glyph> glyphs;

    template <class Faces>
    made_item(Faces& faces, std::u16string_view text, std::uint8_t level = 0, std::uint16_t face = 0)
    {
        fallback_shaping shaping;
        const text_item item{.last = static_cast<std::uint32_t>(text.size()), .face = face, .level = level};
        REQUIRE_FALSE(shaping.shape(faces, text, item, {}, glyphs));
    }
    /// The faces by which the glyphs are drawn, from left to right; '?' for what is missing.
    [[nodiscard]] std::string faces() const
    {
        std::string all;
        for (const shaped_glyph& g : glyphs) {
            REQUIRE(g.face < 10);
            REQUIRE(has(g.flags, glyph_flags::missing) == (g.id == 0));
            all += has(g.flags, glyph_flags::missing) ? '?' : static_cast<char>('0' + g.face);
        }
        return all;
    }
    [[nodiscard]] std::string letters() const
    {
        std::string all;
        for (const shaped_glyph& g : glyphs) all += static_cast<char>(g.id == 0 ? '?' : g.id);
        return all;
    }
};

}  // namespace

TEST_CASE("a text that the item's face has is shaped once, by that face alone", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"abc"}, toy_covering_font{U"abcd"}}};
    CHECK(made_item{faces, u"abcab"}.faces() == "00000");
    CHECK(made_item{faces, u"abcd", 0, 1}.faces() == "1111");
    for (const toy_covering_font& font : faces.fonts) CHECK(font.items == 1);
}

TEST_CASE("only holes are shaped again, each by the first face that has it", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"ab"}, toy_covering_font{U"bcd"}, toy_covering_font{U"ade"}}};
    const made_item made{faces, u"aacdabeeba!"};
    CHECK(made.faces() == "0011002200?");
    CHECK(made.letters() == "aacdabeeba?");
    using ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    CHECK(faces.fonts[1].asked == ranges{{2, 4}, {6, 8}, {10, 11}});
    CHECK(faces.fonts[2].asked == ranges{{6, 8}, {10, 11}});
    CHECK(faces.fonts[0].asked == ranges{{0, 11}, {10, 11}});  // what no face has is the first one's
}

TEST_CASE("in an item that is read to the left holes are filled in drawing order", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"ab"}, toy_covering_font{U"cd"}, toy_covering_font{U"e"}}};
    const made_item made{faces, u"abcde!ba", 1};
    CHECK(made.letters() == "ab?edcba");
    CHECK(made.faces() == "00?21100");
    for (std::size_t i = 1; i < made.glyphs.size(); ++i) CHECK(made.glyphs[i].cluster < made.glyphs[i - 1].cluster);
}

TEST_CASE("graphemes and clusters are not torn apart", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"abfi"}, toy_covering_font{U"abi\u0301f"}}};
    CHECK(made_item{faces, u"ba\u0301b"}.faces() == "0110");
    CHECK(made_item{faces, u"bfi\u0301b"}.faces() == "01110");  // a cluster of two graphemes
    // A face that has a part of a grapheme gives nothing to it.
    toy_faces parts{{toy_covering_font{U"a"}, toy_covering_font{U"\u0301"}}};
    CHECK(made_item{parts, u"aa\u0301"}.faces() == "00?");
    CHECK(made_item{parts, u"aa\u0301"}.letters() == "aa?");
}

TEST_CASE("controls and what is not drawn are never looked for", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"ab"}, toy_covering_font{U"\u0001\u200Bc"}}};
    const made_item made{faces, u"a\u0001\u200Bb"};
    CHECK(made.faces() == "0?00");
    CHECK(faces.fonts[1].items == 0);
    CHECK(made_item{faces, u"a\u0001c"}.faces() == "0?1");
}

TEST_CASE("a face that does not shape a script lacks it", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"a"}, toy_covering_font{U"b"}, toy_covering_font{U"b"}}};
    faces.needs_shaping = 1;
    CHECK(made_item{faces, u"abba"}.faces() == "0220");
    fallback_shaping shaping;
    buffer<shaped_glyph> glyphs;
    CHECK(shaping.shape(faces, u"a", {.last = 1, .face = 1}, {}, glyphs) == error::needs_shaping);
}

TEST_CASE("a line may end where text of two faces meets, unless the first face forbids it", "[layout][fallback]")
{
    toy_faces faces{{toy_covering_font{U"abc"}, toy_covering_font{U"xyz"}}};
    const auto unsafe = [](const made_item& made, std::size_t i) {
        return has(made.glyphs[i].flags, glyph_flags::unsafe_to_break);
    };
    const made_item made{faces, u"abxyab"};
    for (std::size_t i = 0; i < 6; ++i) CHECK_FALSE(unsafe(made, i));
    // What the first face found unsafe stays so, for its own glyphs were shaped beside those that it lacked.
    const made_item joined{faces, u"ab\u200Dxya"};
    CHECK(unsafe(joined, 3));
    CHECK_FALSE(unsafe(joined, 4));
}

TEST_CASE("a line may not end inside a cluster of the first face, even where another face has several",
          "[layout][fallback]")
{
    struct parting_faces : toy_faces {  // the second makes a cluster of every glyph
        error shape(text_view text, const text_item& item, const shape_options& how,
                    buffer<shaped_glyph>& glyphs) noexcept
        {
            const std::size_t before = glyphs.size();
            const error e = toy_faces::shape(text, item, how, glyphs);
            if (item.face == 1)
                for (std::size_t i = before; i < glyphs.size(); ++i)
                    glyphs[i].cluster = item.first + static_cast<cluster_id>(i - before);
            return e;
        }
    } faces;
    faces.fonts = {toy_covering_font{U"abf"}, toy_covering_font{U"fi"}};
    const made_item made{faces, u"afib"};
    CHECK(made.faces() == "0110");
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(made.glyphs[i].cluster == i);
        CHECK(has(made.glyphs[i].flags, glyph_flags::unsafe_to_break) == (i == 2));
    }
}

TEST_CASE("what no face has is found once, and kept for the next text", "[layout][fallback]")
{
    finding_faces faces;
    faces.fonts = {toy_covering_font{U"ab"}, toy_covering_font{U"c"}};
    faces.more = {toy_covering_font{U"de"}, toy_covering_font{U"efg"}};
    CHECK(made_item{faces, u"abcab"}.faces() == "00100");
    CHECK(faces.asked == 0);
    CHECK(made_item{faces, u"a!dfegcb!"}.faces() == "0?232310?");
    CHECK(faces.face_count() == 4);
    const std::size_t asked = faces.asked;
    CHECK(made_item{faces, u"gedf"}.faces() == "3223");
    CHECK(faces.asked == asked);
    CHECK(made_item{faces, u"gef!", 1}.faces() == "?323");
}

TEST_CASE("a found face that lacks what it was found for is not tried again", "[layout][fallback]")
{
    struct liar : toy_faces {
        result<std::uint32_t> find(text_view, text_range, std::uint32_t, std::string_view) noexcept
        {
            ++asked;
            if (face_count() == 1) fonts.push_back(toy_covering_font{U"z"});
            return 1;
        }
    } faces;
    faces.fonts = {toy_covering_font{U"a"}};
    std::u16string text(2000, u'b');
    text += u'z';
    CHECK(made_item{faces, text}.faces() == std::string(2000, '?') + "1");
    CHECK(faces.asked <= 2 * text.size());
    CHECK(faces.fonts[1].items <= 2);
}

TEST_CASE("a grapheme has one face, and the same one in any part of the text", "[layout][fallback]")
{
    std::mt19937 random{14};
    const std::u32string letters =
        U"abcdefgi\u05D0\u05D1\u0301\u0323\u200D\uFE0F\U0001F468\U0001F469\U0001F1E6\U0001F1E7\u1100\u1161\u11A8 ";
    const auto some = [&] {
        std::u32string has;
        for (const char32_t c : letters)
            if (random() % 2 == 0) has += c;
        return has;
    };
    for (int round = 0; round < 400; ++round) {
        toy_faces faces{{toy_covering_font{some()}, toy_covering_font{some()}, toy_covering_font{some()}}};
        std::u16string text;
        for (int i = 0; i < 20; ++i) test::append_utf16(text, letters[random() % letters.size()]);
        const text_analysis found = test::analysed(text);
        const auto level = static_cast<std::uint8_t>(round % 2);
        const made_item made{faces, text, level};
        std::vector<int> face_of(text.size(), -1);
        std::size_t at = 0;  // the grapheme's beginning
        std::vector<std::size_t> grapheme(text.size());
        for (std::size_t u = 0; u < text.size(); ++u)
            grapheme[u] = at = has(found.marks[u], text_mark::grapheme) ? u : at;
        bool whole = true;
        for (const shaped_glyph& g : made.glyphs) {
            int& face = face_of[grapheme[g.cluster]];
            whole = whole && (face < 0 || face == g.face);
            face = g.face;
        }
        CHECK(whole);
        // The first face that has all of a grapheme draws it, whatever stands beside it; but what one cluster holds.
        std::size_t last = 0;
        for (std::size_t u = 0; u < text.size(); u = last) {
            last = u + 1;
            while (last < text.size() && !has(found.marks[last], text_mark::grapheme)) ++last;
            const std::u16string_view own = std::u16string_view{text}.substr(u, last - u);
            if (own[0] == u'f' || own[0] == u'i') continue;
            toy_faces again{faces.fonts};
            const made_item alone{again, own, level};
            REQUIRE_FALSE(alone.glyphs.empty());
            CHECK(face_of[u] == alone.glyphs[0].face);
        }
    }
}

TEST_CASE("A line with holes has the glyphs of all faces, in its order and in columns", "[layout][fallback]")
{
    filling_font font{{{toy_covering_font{U"ab "}, toy_covering_font{U"\u05D0\u05D1"}, toy_covering_font{U"c"}}}};
    glyph_run run;
    REQUIRE(layout(font, u"ab \u05D0\u05D1!c", {}, {}, run));
    CHECK(run.lines[0].advance == 3500.0);
    const cluster_id clusters[] = {0, 1, 2, 4, 3, 5, 6};
    const std::uint32_t faces[] = {0, 0, 0, 1, 1, 0, 2};
    REQUIRE(run.glyphs.size() == std::size(clusters));
    for (std::size_t i = 0; i < std::size(clusters); ++i) {
        const placed_glyph& g = run.glyphs[i];
        CHECK(g.cluster == clusters[i]);
        CHECK(run.glyph_styles[g.glyph_style].face == faces[i]);
        CHECK(g.origin == point{500.0 * static_cast<double>(i), 0.0});
        CHECK(g.missing == (clusters[i] == 5));
    }
    CHECK(run.missing == 1);
    CHECK(run.first_missing == 5);

    REQUIRE(layout(font, u"a\u05D0c", {.direction = direction::top_to_bottom}, {}, run));
    CHECK(run.lines[0].advance == 1500.0);
    CHECK(run.glyphs[2].origin == point{-200.0, -1000.0});
    CHECK(run.glyphs[1].cluster == 1);
}

TEST_CASE("fallback reports a memory that gives nothing, and keeps what it has", "[layout][fallback]")
{
    const std::u16string text = u"ab\u05D0\u05D1 cc!";
    const text_item all{.last = static_cast<std::uint32_t>(text.size())};
    toy_faces faces{{toy_covering_font{U"ab "}, toy_covering_font{U"\u05D0\u05D1"}, toy_covering_font{U"c"}}};
    test::counting_memory counted;
    fallback_shaping shaping{counted.source()};
    buffer<shaped_glyph> glyphs{counted.source()};
    REQUIRE_FALSE(shaping.shape(faces, text, all, {}, glyphs));
    const std::size_t needed = counted.requests;
    glyphs.clear();
    REQUIRE_FALSE(shaping.shape(faces, text, all, {}, glyphs));
    CHECK(counted.requests == needed);
    CHECK(needed == test::check_each_failure([&](memory source) {
              fallback_shaping poor{source};
              buffer<shaped_glyph> none{source};
              return poor.shape(faces, text, all, {}, none);
          }));
}

TEST_CASE("what another face shapes lies on its side in a column, too", "[layout][columns]")
{
    filling_font font{{{toy_covering_font{U"ab"}, toy_covering_font{U"\u4E00R"}}}};
    glyph_run run;
    REQUIRE(layout(font, u"a\u4E00Rb", {.direction = direction::top_to_bottom}, {}, run));
    REQUIRE(run.glyphs.size() == 4);
    point pen;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool upright = i == 1;
        const glyph_style drawn = run.glyph_styles[run.glyphs[i].glyph_style];
        CHECK(drawn.face == (i == 1 || i == 2 ? 1u : 0u));
        CHECK(drawn.map == (upright ? affine{} : quarter_turn));
        CHECK(run.glyphs[i].origin.x == (upright ? 0.0 : -200.0));
        CHECK(run.glyphs[i].origin.y <= pen.y);
        pen = run.glyphs[i].origin;
    }
    CHECK(run.lines[0].advance > -pen.y);
}
