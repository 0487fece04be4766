// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <string>
#include <vector>

using namespace typemesh;
using test::shaped_paragraph;

TEST_CASE("clusters cover the text in its order, whatever the direction of their glyphs", "[paragraph]")
{
    const std::u16string text = u"a\u0301 \u05D0\u05D1\u05B8 12\tfi\r\n\u00ADz";
    const shaped_paragraph p{text};
    cluster_id at = 0;
    for (std::uint32_t i = 0; i < p.shaped.cluster_count(); ++i) {
        const text_cluster& c = p.shaped.cluster(i);
        CHECK(c.first == at);
        REQUIRE(c.last > c.first);
        at = c.last;
        double advance = 0.0;
        for (std::uint32_t g = c.glyph; g < c.glyph + c.glyph_count; ++g) {
            CHECK((p.shaped.glyph(g).cluster >= c.first && p.shaped.glyph(g).cluster < c.last));
            advance += p.shaped.glyph(g).advance;
        }
        CHECK(advance == c.advance);
        CHECK(has(c.flags, cluster_flags::silent) == (silent_at(text, c.first) != 0));
        CHECK((c.glyph_count == 0) == has(c.flags, cluster_flags::silent));
        CHECK(i >= p.shaped.first_cluster(c.item));
        CHECK(i < p.shaped.end_cluster(c.item));
        CHECK(p.shaped.item_at(c.first) == c.item);
    }
    CHECK(at == text.size());
}

TEST_CASE("a grapheme is never in two clusters, and letter spacing follows it", "[paragraph]")
{
    for (const char16_t* text :
         {u"\u1112\u1161\u11ABx", u"\u202E\u1112\u1161\u11ABx"}) {  // a syllable of three letters
        const shaped_paragraph p{std::u16string{text}, direction::automatic, 40.0};
        const std::uint32_t at = text[0] == 0x202E ? 1 : 0;
        REQUIRE(p.shaped.cluster_count() == at + 2);
        const text_cluster& c = p.shaped.cluster(at);
        CHECK(c.first == at);
        CHECK(c.last == at + 3);
        CHECK(c.advance == 1540.0);
        REQUIRE(c.glyph_count == 3);
        for (std::uint32_t g = 0; g < 3; ++g) {
            const shaped_glyph& glyph = p.shaped.glyph(c.glyph + g);
            CHECK(glyph.cluster == at + (at != 0 ? 2 - g : g));  // as the shaper said
            CHECK(glyph.id == text[glyph.cluster]);
        }
    }
}

TEST_CASE("an item without glyphs is one cluster", "[paragraph]")
{
    for (const double spacing : {0.0, 40.0}) {
        const shaped_paragraph p{"a\t\x7F\x7F", direction::automatic, spacing};
        REQUIRE(p.shaped.cluster_count() == 3);
        const text_cluster& c = p.shaped.cluster(2);
        CHECK(c.first == 2);
        CHECK(c.last == 4);
        CHECK(c.glyph_count == 0);
        CHECK(c.advance == 0.0);
        CHECK(c.item == 2);
        CHECK(p.shaped.item_at(3) == 2);
        CHECK(p.shaped.advance(0, 3) == p.shaped.advance(0, 1));
    }
}

TEST_CASE("letter spacing widens every letter but those written joined, and separates ligatures", "[paragraph]")
{
    const shaped_paragraph plain{"fix"}, spaced{"fix", direction::automatic, 40.0};
    CHECK(plain.shaped.cluster_count() == 2);
    REQUIRE(spaced.shaped.cluster_count() == 3);
    for (std::uint32_t i = 0; i < 3; ++i) {
        CHECK(spaced.shaped.cluster(i).advance == 540.0);
        CHECK(spaced.shaped.spacing_of(spaced.shaped.cluster(i)) == 40.0);
    }
    const shaped_paragraph joined{u"\u0628\u0628x", direction::automatic, 40.0};
    CHECK(joined.shaped.cluster(0).advance == 500.0);
    CHECK(joined.shaped.spacing_of(joined.shaped.cluster(0)) == 0.0);
    CHECK_FALSE(joined.shaped.may_be_spaced(joined.shaped.cluster(0)));
    CHECK(joined.shaped.may_be_spaced(joined.shaped.cluster(1)));
    CHECK(joined.shaped.cluster(1).advance == 540.0);
    // What is read to the left has the distance on its left.
    CHECK(joined.shaped.glyph(joined.shaped.cluster(1).glyph).offset == point{40.0, 0.0});
}

TEST_CASE("what is not drawn takes no distance", "[paragraph]")
{
    const shaped_paragraph p{u"a\u00AD\tb"};
    CHECK(p.shaped.may_be_spaced(p.shaped.cluster(0)));
    CHECK_FALSE(p.shaped.may_be_spaced(p.shaped.cluster(1)));
    CHECK_FALSE(p.shaped.may_be_spaced(p.shaped.cluster(2)));
    CHECK(p.shaped.may_be_spaced(p.shaped.cluster(3)));
}

TEST_CASE("a cluster knows whether a tatweel may stand before it", "[paragraph]")
{
    const shaped_paragraph p{u"\u0628\u0628 \u0628"};
    for (std::uint32_t i = 0; i < 4; ++i) CHECK(has(p.shaped.cluster(i).flags, cluster_flags::tatweel) == (i == 1));
}

TEST_CASE("a line ends with a hyphen after U+00AD, in either encoding, and where the analyser says so", "[paragraph]")
{
    shaped_paragraph wide{u"ab\u00ADc"}, narrow{
                                             "ab\xC2\xAD"
                                             "c"};
    for (std::uint32_t place = 0; place <= 4; ++place) CHECK(wide.shaped.hyphenates(place) == (place == 3));
    for (std::uint32_t place = 0; place <= 5; ++place) CHECK(narrow.shaped.hyphenates(place) == (place == 4));
    wide.shaped.analysis.marks[1] = wide.shaped.analysis.marks[1] | text_mark::hyphen;
    CHECK(wide.shaped.hyphenates(1));
}

TEST_CASE("a hyphen or an ellipsis is a cluster of the place that it stands for", "[paragraph]")
{
    shaped_paragraph p{"ab"};
    REQUIRE_FALSE(p.shaped.append_foreign(p.font, 0, 1, std::u16string_view{u"\uFFFF"}, text_view{"--"}));
    const text_cluster& c = p.shaped.cluster(p.shaped.all_clusters() - 1);
    CHECK(c.first == 1);
    CHECK(c.glyph_count == 2);
    CHECK(c.advance == 1000.0);
    CHECK(p.shaped.glyph(c.glyph).id == '-');
    CHECK(p.shaped.glyph(c.glyph + 1).cluster == 1);
    CHECK(p.shaped.cluster_count() == 2);
}

TEST_CASE("what is shaped later has its own advance, whatever has been shaped before", "[paragraph]")
{
    shaped_paragraph p{"abc", direction::automatic, 83.37};
    for (int times = 0; times < 40; ++times) {
        const auto at = static_cast<std::uint32_t>(p.shaped.all_clusters());
        REQUIRE_FALSE(p.shaped.shape_range(p.font, 0, 0, 3));
        CHECK(p.shaped.advance(at, at + 1) == 583.37);
        CHECK(p.shaped.advance(at, at + 3) == 583.37 + 583.37 + 583.37);
    }
}

TEST_CASE("carets within a ligature on its side stand as far along the line as in a line", "[paragraph][carets]")
{
    struct ligature_font : test::toy_shaper {
        error ligature_carets(std::uint32_t, glyph_id, bool, buffer<double>& carets) const noexcept
        {
            return carets.push_back(400.0) ? error{} : error{error::out_of_memory};
        }
    } font;
    font.lines = {1200.0, -100.0, 0.0};  // the column's middle is above the caret
    const auto carets_in = [&font](text_view text, direction d, column_style column) {
        shaped_text shaped;
        const style_span all[] = {{0, static_cast<std::uint32_t>(text.size()), {.column = column}}};
        REQUIRE_FALSE(unicode_analyser{}.analyse(text, {}, shaped.analysis));
        REQUIRE_FALSE(shaped.read(font, 1, text, {.direction = d, .styles = all}));
        REQUIRE_FALSE(shaped.shape(font));
        const auto found = shaped.carets_of(shaped.cluster_count() - 1);
        return std::vector<double>{found.begin(), found.end()};
    };
    const std::vector<double> own{400.0};
    CHECK(carets_in("xfi", direction::left_to_right, {}) == own);
    for (const column_style column : {column_style::sideways, column_style::upright})
        CHECK(carets_in("xfi", direction::top_to_bottom, column) == own);
}

TEST_CASE("only what is combined in a column is drawn narrower", "[paragraph][columns]")
{
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 4;
    const shaped_paragraph p{u"\u3042ab1234", how};
    REQUIRE(p.shaped.items().size() == 3);
    const double squeezed[] = {1.0, 1.0, 0.5};  // upright, on its side, four digits of 500 in 1000
    for (std::size_t k = 0; k < 3; ++k) CHECK(p.shaped.items()[k].squeeze == squeezed[k]);
}
