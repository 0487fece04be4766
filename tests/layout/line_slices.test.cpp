// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/layout/impl/line_slices.hpp>

#include <ctime>
#include <string>
#include <vector>

using namespace typemesh;
using test::shaped_paragraph;

namespace {

/// A text as one line of width `width`.
struct whole_line : shaped_paragraph {
    line_slices line{};
    double width = 0.0;

    explicit whole_line(text_view text, direction d = direction::automatic, double letter_spacing = 0.0,
                        const line_room& room = {})
        : shaped_paragraph{text, d, letter_spacing}
    {
        const auto& words = pieces.words();
        REQUIRE_FALSE(append_pieces(line, pieces, {words, 0, words.pieces.size()}, shaped, font));
        const auto made = line.finish(shaped, 0, 0.0, room);
        REQUIRE(made);
        width = *made;
    }
    [[nodiscard]] double sum(std::size_t slices) const
    {
        double all = 0.0;
        for (std::size_t k = 0; k < slices; ++k) all += line.slices()[k].width;
        return all;
    }
    /// The levels of its slices, which cover the line.
    [[nodiscard]] std::vector<int> levels() const
    {
        std::vector<int> all;
        std::uint32_t next = 0;
        for (const line_slice& s : line.slices()) {
            CHECK(s.first == next);
            next = s.last;
            all.push_back(s.level);
        }
        CHECK(next == shaped.cluster_count());
        return all;
    }
};

}  // namespace

TEST_CASE("white space at a line's end hangs, and takes the paragraph's level", "[paragraph]")
{
    const whole_line p{u"\u05D0 \u05D1  "};
    CHECK(p.width == 1250.0);
    CHECK(p.line.visible() == 1);
    CHECK(p.levels() == std::vector{1, 0});
    CHECK(p.sum(2) == 1750.0);
}

TEST_CASE("white space before a mark that is not drawn hangs, too, at the paragraph's level", "[paragraph]")
{
    for (const char16_t* end : {u"\u200F", u" \u200F", u"\u200F ", u" \u200F ", u"  \u200F\u200E \u200F"})
        for (const char16_t* word : {u"ab", u"\u05D0\u05D1"}) {
            const std::u16string text = word + std::u16string{end};
            const whole_line p{text};
            CHECK(p.width == 1000.0);
            double pieces = 0.0;
            for (const break_piece& piece : p.pieces.words().pieces) pieces += piece.width;
            CHECK(pieces == 1000.0);
            const std::vector<int> levels = p.levels();
            bool space = false;  // there has been one
            for (std::size_t k = 0; k < levels.size(); ++k) {
                space = space || has(p.shaped.cluster(p.line.slices()[k].first).flags, cluster_flags::hangs);
                if (space) CHECK(levels[k] == 0);
            }
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
                const auto is = [&](cluster_flags flag) { return has(p.shaped.cluster(k).flags, flag); };
                while (is(cluster_flags::hangs) && !is(cluster_flags::tab)) ++k;
                if (is(cluster_flags::tab) && s.level != 0) ++wrong;
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
    whole_line p{"   "};
    CHECK(p.width == 0.0);
    CHECK(p.line.visible() == 0);
    p.line.trim(p.shaped);
    CHECK(p.line.slices().empty());
}

TEST_CASE("tabs take what leads to the next stop, and what follows the last one is justified", "[paragraph]")
{
    whole_line p{"a b\tc d", direction::automatic, 0.0, {.tab = 2000.0}}, one{"word"};
    CHECK(p.width == 2000.0 + 1250.0);
    CHECK(p.line.justify(p.shaped, 90.0) == 90.0);
    CHECK(p.sum(p.line.slices().size()) == p.width + 90.0);
    CHECK(p.line.slices()[0].stretch == 0.0);
    CHECK(p.line.slices()[2].stretch == 90.0);
    CHECK(one.line.justify(one.shaped, 90.0) == 0.0);
}

TEST_CASE("letter spacing after a line's last letter does not count", "[paragraph]")
{
    for (const char16_t* text : {u"abc ", u"\u05D0\u05D1\u05D2 "}) {
        const whole_line p{text, direction::automatic, 40.0};
        CHECK(p.width == 1580.0);
        CHECK(p.line.slices()[0].lead == (text[0] == u'a' ? 0.0 : -40.0));
    }
}

TEST_CASE("letter spacing before marks of direction does not count, and they keep their level before what hangs",
          "[paragraph]")
{
    for (const char16_t* text :
         {u"abc\u200E", u"abc\u200E  ", u"\u05D0\u05D1\u05D2\u200F", u"a\u05D1\u05D2\u200F", u"\u05D0bc\u200E"}) {
        const whole_line p{text, direction::automatic, 40.0};
        CHECK(p.width == 1580.0);
        const break_piece& word = p.pieces.words().pieces[0];
        CHECK(word.width + word.end_change == p.width);
        CHECK(p.sum(p.line.visible()) == p.width);
    }
    // The letter, its mark, the space: by rule L1 only that has the line's level.
    CHECK(whole_line{u"\u05D0\u200F ", direction::left_to_right, 40.0}.levels() == std::vector{1, 1, 0});
}
