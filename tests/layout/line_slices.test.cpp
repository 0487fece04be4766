// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/layout/impl/line_slices.hpp>

#include <ctime>

using namespace typemesh;
using test::shaped_paragraph;

namespace {

double advance_of(const line_slices& line)
{
    double sum = 0.0;
    for (const line_slice& s : line.slices()) sum += s.width;
    return sum;
}

}  // namespace

TEST_CASE("white space at a line's end hangs, and takes the paragraph's level", "[paragraph]")
{
    shaped_paragraph p{u"\u05D0 \u05D1  "};
    line_slices line;
    REQUIRE_FALSE(
        append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
    const auto width = line.finish(p.shaped, 0, 0.0, {});
    REQUIRE(width);
    CHECK(*width == 1250.0);
    REQUIRE(line.slices().size() == 2);
    CHECK(line.visible() == 1);
    CHECK(line.slices()[0].level == 1);
    CHECK(line.slices()[1].level == 0);
    CHECK(advance_of(line) == 1750.0);
}

TEST_CASE("white space before a mark that is not drawn hangs, too, at the paragraph's level", "[paragraph]")
{
    for (const char16_t* end : {u"\u200F", u" \u200F", u"\u200F ", u" \u200F ", u"  \u200F\u200E \u200F"})
        for (const char16_t* word : {u"ab", u"\u05D0\u05D1"}) {
            shaped_paragraph p{word + std::u16string{end}};
            line_slices line;
            REQUIRE_FALSE(
                append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
            const auto width = line.finish(p.shaped, 0, 0.0, {});
            REQUIRE(width);
            CHECK(*width == 1000.0);
            double pieces = 0.0;
            for (const break_piece& piece : p.pieces.words().pieces) pieces += piece.width;
            CHECK(pieces == 1000.0);
            std::uint32_t next = 0;
            bool space = false;  // there has been one
            for (const line_slice& s : line.slices()) {
                CHECK(s.first == next);
                next = s.last;
                space = space || has(p.shaped.cluster(s.first).flags, cluster_flags::hangs);
                if (space) CHECK(s.level == 0);
            }
            CHECK(next == p.shaped.cluster_count());
        }
}

TEST_CASE("white space before each tab takes the paragraph's level, in linear time", "[paragraph]")
{
    for (const char16_t* unit : {u"\u05D0 \t", u"\t", u"\u05D0 \u2067 \u2069 \t\t", u"a \t\u05D0b \t "}) {
        std::u16string text;
        while (text.size() < 20'000) text += unit;
        text += u"\u05D0";
        shaped_paragraph p{text, direction::left_to_right};
        line_slices line;
        const std::clock_t begin = std::clock();
        REQUIRE_FALSE(
            append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
        REQUIRE(line.finish(p.shaped, 0, 0.0, {}));
        CHECK(std::clock() - begin < CLOCKS_PER_SEC);  // seconds, were each tab to look at all before it
        std::size_t wrong = 0;
        std::uint32_t next = 0;
        for (const line_slice& s : line.slices()) {
            wrong += s.first != next ? 1u : 0u;  // a gap
            next = s.last;
            for (std::uint32_t c = s.first; c < s.last; ++c) {
                std::uint32_t k = c;  // does only white space follow, up to a tab?
                const auto hangs = [&] { return has(p.shaped.cluster(k).flags, cluster_flags::hangs); };
                while (hangs() && !has(p.shaped.cluster(k).flags, cluster_flags::tab)) ++k;
                if (has(p.shaped.cluster(k).flags, cluster_flags::tab) && s.level != 0) ++wrong;
            }
        }
        CHECK(wrong == 0);
        CHECK(next == p.shaped.cluster_count());
        CHECK(line.slices().back().level == 1);
        CHECK(line.visible() == line.slices().size());
    }
}

TEST_CASE("a line of nothing but white space has no width", "[paragraph]")
{
    shaped_paragraph p{"   "};
    line_slices line;
    REQUIRE_FALSE(
        append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
    const auto width = line.finish(p.shaped, 0, 0.0, {});
    REQUIRE(width);
    CHECK(*width == 0.0);
    CHECK(line.visible() == 0);
    line.trim(p.shaped);
    CHECK(line.slices().empty());
}

TEST_CASE("tabs take what leads to the next stop, and what stands behind the last one is justified", "[paragraph]")
{
    shaped_paragraph p{"a b\tc d"};
    line_slices line;
    REQUIRE_FALSE(
        append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
    const auto width = line.finish(p.shaped, 0, 0.0, {.tab = 2000.0});
    REQUIRE(width);
    CHECK(*width == 2000.0 + 1250.0);
    CHECK(line.justify(p.shaped, 90.0) == 90.0);
    CHECK(advance_of(line) == *width + 90.0);
    CHECK(line.slices()[0].stretch == 0.0);
    CHECK(line.slices()[2].stretch == 90.0);

    shaped_paragraph one{"word"};
    line.clear();
    REQUIRE_FALSE(append_pieces(line, one.pieces, {one.pieces.words(), 0, 1}, one.shaped, one.font));
    REQUIRE(line.finish(one.shaped, 0, 0.0, {}));
    CHECK(line.justify(one.shaped, 90.0) == 0.0);
}

TEST_CASE("letter spacing behind a line's last letter does not count", "[paragraph]")
{
    for (const char16_t* text : {u"abc ", u"\u05D0\u05D1\u05D2 "}) {
        shaped_paragraph p{text, direction::automatic, 40.0};
        line_slices line;
        REQUIRE_FALSE(
            append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
        const auto width = line.finish(p.shaped, 0, 0.0, {});
        REQUIRE(width);
        CHECK(*width == 1580.0);
        CHECK(line.slices()[0].lead == (text[0] == u'a' ? 0.0 : -40.0));
    }
}

TEST_CASE("nor does it before marks of direction, which keep the level of what hangs behind them", "[paragraph]")
{
    for (const char16_t* text :
         {u"abc\u200E", u"abc\u200E  ", u"\u05D0\u05D1\u05D2\u200F", u"a\u05D1\u05D2\u200F", u"\u05D0bc\u200E"}) {
        shaped_paragraph p{text, direction::automatic, 40.0};
        line_slices line;
        REQUIRE_FALSE(
            append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
        const auto width = line.finish(p.shaped, 0, 0.0, {});
        REQUIRE(width);
        CHECK(*width == 1580.0);
        const break_piece& word = p.pieces.words().pieces[0];
        CHECK(word.width + word.end_change == *width);
        double sum = 0.0;
        for (std::size_t k = 0; k < line.visible(); ++k) sum += line.slices()[k].width;
        CHECK(sum == *width);
    }
    shaped_paragraph p{u"\u05D0\u200F ", direction::left_to_right, 40.0};
    line_slices line;
    REQUIRE_FALSE(
        append_pieces(line, p.pieces, {p.pieces.words(), 0, p.pieces.words().pieces.size()}, p.shaped, p.font));
    REQUIRE(line.finish(p.shaped, 0, 0.0, {}));
    REQUIRE(line.slices().size() == 3);  // the letter, its mark, the space: by rule L1 only that has the line's level
    CHECK(line.slices()[0].level == 1);
    CHECK(line.slices()[1].level == 1);
    CHECK(line.slices()[2].level == 0);
}
