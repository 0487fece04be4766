// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace typemesh;
using test::shaped_paragraph;

namespace {

/// Pieces cover a text and have its width.
void check_cover(const text_pieces::list& list, const shaped_text& shaped)
{
    REQUIRE(list.pieces.size() == list.sources.size());
    std::uint32_t at = 0;
    double width = 0.0;
    for (const break_piece& p : list.pieces) {
        CHECK(p.first == at);
        at = p.last;
        width += p.width + p.space;
    }
    CHECK(at == shaped.text().size());
    CHECK(width == shaped.advance(0, shaped.cluster_count()));
    CHECK(list.pieces.back().end == piece_end::paragraph);
}

}  // namespace

TEST_CASE("words cover the text and have its width, however they are cut", "[paragraph]")
{
    for (const std::u16string text :
         {u"", u" ", u"one", u"one  two three", u"fi AVAV office\tx\t\ty", u"a\n\nb\u2028c\r\n", u"\u05D0\u05D1 12 ab",
          u"long\u00ADword fi\u00ADfi", u"a\u0301\u0302 b\u0301"}) {
        shaped_paragraph p{text};
        check_cover(p.pieces.words(), p.shaped);
        for (const double narrowest : {0.0, 600.0, 1e9})
            for (const wrap_mode wrap : {wrap_mode::word_or_grapheme, wrap_mode::grapheme})
                check_cover(p.wrapped(wrap, narrowest), p.shaped);
    }
}

TEST_CASE("pieces end where the text says so", "[paragraph]")
{
    struct expected {
        const char* text;
        std::vector<piece_end> ends;
    };
    using enum piece_end;
    for (const auto& [text, ends] : {expected{"", {paragraph}},
                                     {"a b", {allowed, paragraph}},
                                     {"a\n", {paragraph, paragraph}},
                                     {"a\r\nb", {paragraph, paragraph}},
                                     {"a\xE2\x80\xA8z", {line, paragraph}},
                                     {"a\x0Bz", {line, paragraph}},
                                     {"a\t\tb", {never, allowed, paragraph}}}) {
        const shaped_paragraph p{text};
        std::vector<piece_end> found;
        for (const break_piece& piece : p.pieces.words().pieces) found.push_back(piece.end);
        INFO(text);
        CHECK(found == ends);
    }
}

TEST_CASE("graphemes are made once, and only of words that need it", "[paragraph]")
{
    shaped_paragraph p{"AVAVAV xx fifi"};
    const std::size_t calls = p.font.calls;
    CHECK(&p.wrapped(wrap_mode::word, 1.0) == &p.pieces.words());
    double widest = 0.0;
    for (const break_piece& word : p.pieces.words().pieces) widest = (std::max)(widest, word.room());
    CHECK(&p.wrapped(wrap_mode::word_or_grapheme, widest) == &p.pieces.words());
    CHECK(p.font.calls == calls);
    CHECK(p.wrapped(wrap_mode::word_or_grapheme, 1400.0).pieces.size() == 6 + 1 + 1);
    const std::size_t more = p.font.calls;
    CHECK(more > calls);
    CHECK(p.wrapped(wrap_mode::word_or_grapheme, 1400.0).pieces.size() == 6 + 1 + 1);
    CHECK(p.font.calls == more);
    CHECK(p.wrapped(wrap_mode::grapheme, 0.0).pieces.size() == 6 + 2 + 4);
    for (const break_piece& g : p.wrapped(wrap_mode::grapheme, 0.0).pieces) CHECK(g.end != piece_end::in_need);
}

TEST_CASE("marks and white space stay with what they follow", "[paragraph]")
{
    shaped_paragraph p{u"a\u0301b  c"};
    const auto& list = p.wrapped(wrap_mode::grapheme, 0.0);
    REQUIRE(list.pieces.size() == 3);
    CHECK(list.pieces[0].last == 2);
    CHECK(list.pieces[1].last == 5);
    CHECK(list.pieces[1].space == 500.0);
}

TEST_CASE("a space that carries a mark is no white space", "[paragraph]")
{
    shaped_paragraph p{u"a \u0301b"};
    CHECK(p.pieces.words().pieces[0].space == 0.0);
    const auto& list = p.wrapped(wrap_mode::grapheme, 0.0);
    REQUIRE(list.pieces.size() == 3);
    CHECK(list.pieces[1].width == 250.0);
    shaped_paragraph unseen{u"a \u200Fb"};  // a mark of direction is no such mark
    CHECK(unseen.pieces.words().pieces[0].space == 250.0);
}

TEST_CASE("in need a line ends after a tab where Unicode lets none end", "[paragraph]")
{
    shaped_paragraph p{"N\t)"};
    CHECK(p.pieces.words().pieces[0].end == piece_end::never);
    CHECK(p.wrapped(wrap_mode::word, 100.0).pieces[0].end == piece_end::never);
    CHECK(p.wrapped(wrap_mode::word_or_grapheme, 600.0).pieces[0].end == piece_end::in_need);
    CHECK(p.wrapped(wrap_mode::grapheme, 600.0).pieces[0].end == piece_end::allowed);
    shaped_paragraph spaced{"N\t )"};  // a space stays with the tab
    const auto& list = spaced.wrapped(wrap_mode::word_or_grapheme, 1000.0);
    REQUIRE(list.pieces.size() == 3);
    CHECK(list.pieces[0].end == piece_end::never);
    CHECK(list.pieces[1].end == piece_end::in_need);
}

TEST_CASE("marks without a letter show, though they have no width", "[paragraph]")
{
    CHECK(shaped_paragraph{u"\u0301"}.pieces.words().pieces[0].is_visible());
    CHECK_FALSE(shaped_paragraph{u"\u200F"}.pieces.words().pieces[0].is_visible());
}

TEST_CASE("a part of the text has the same graphemes as in the whole", "[paragraph]")
{
    shaped_paragraph p{"one two three"};
    const auto made = p.pieces.graphemes_of(4, 13, p.shaped, p.font);
    REQUIRE(made);
    REQUIRE((*made)->pieces.size() == 8);
    CHECK((*made)->pieces[0].first == 4);
    CHECK((*made)->pieces[7].last == 13);
    const auto inner = p.pieces.graphemes_of(5, 7, p.shaped, p.font);
    REQUIRE(inner);
    CHECK((*inner)->pieces.size() == 1);  // "w"; "o " ends after 7
}

TEST_CASE("a piece knows what it can be stretched by, and whether it is hyphenated at a line's end", "[paragraph]")
{
    shaped_paragraph p{u"one )  so\u00ADft\u00A0"};
    const auto& words = p.pieces.words().pieces;
    REQUIRE(words.size() == 3);
    CHECK(words[0].stretch == 750.0);  // one space within, two behind it
    CHECK(words[1].stretch == 0.0);
    CHECK(words[2].stretch == 0.0);
    for (std::size_t k = 0; k < 3; ++k) CHECK(words[k].hyphen == (k == 1));
    const auto& graphemes = p.wrapped(wrap_mode::word_or_grapheme, 600.0);
    double stretch = 0.0;
    int hyphens = 0;
    for (const break_piece& g : graphemes.pieces) {
        stretch += g.stretch;
        hyphens += g.hyphen ? 1 : 0;
    }
    CHECK(stretch == 750.0);
    CHECK(hyphens == 1);
}

TEST_CASE("a hyphen that the analyser wants costs its width where a line ends", "[paragraph]")
{
    shaped_paragraph p{"abcd"};
    p.shaped.analysis.marks[2] = p.shaped.analysis.marks[2] | text_mark::may_break | text_mark::hyphen;
    REQUIRE_FALSE(p.pieces.find_words(p.shaped, p.font));
    REQUIRE(p.pieces.words().pieces.size() == 2);
    CHECK(p.pieces.words().pieces[0].hyphen);
    CHECK(p.pieces.words().pieces[0].end_change == 500.0);
    CHECK(p.pieces.words().pieces[1].begin_change == 0.0);
    const line_cut& cut = p.pieces.cut(p.pieces.words().sources[0].cut);
    const text_cluster& hyphen = p.shaped.cluster(cut.before_first + cut.before_count - 1);
    CHECK(p.shaped.glyph(hyphen.glyph).id == 0x2010);
    CHECK(hyphen.first == 1);
}
