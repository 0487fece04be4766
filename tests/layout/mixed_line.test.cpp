// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/layout/impl/mixed_line.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct split_line {
    buffer<text_item> items;

    split_line(text_view text, std::size_t first, std::size_t last, direction d = direction::automatic)
    {
        shape_options how;
        how.direction = d;
        if (d != direction::top_to_bottom) {
            REQUIRE_FALSE(mixed_line{}.split(text, first, last, how, items));
            return;
        }
        how.columns.latin = column_latin::upright;
        split_column(text, first, last, how);
    }
    split_line(text_view text, const shape_options& how) { split_column(text, 0, text.size(), how); }
    void split_column(text_view text, std::size_t first, std::size_t last, const shape_options& how)
    {
        const auto no_form = [](char32_t) noexcept { return false; };
        REQUIRE_FALSE(mixed_line{}.split_column(text, first, last, how, no_form, items));
    }
    [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges() const
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
        for (const text_item& i : items) all.emplace_back(i.first, i.last);
        return all;
    }
};

using ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

}  // namespace

TEST_CASE("items stand from left to right, and count from the text's start", "[layout]")
{
    CHECK(split_line(u"a \u05D0\u05D1 b", 0, 6).ranges() == ranges{{0, 2}, {2, 4}, {4, 5}, {5, 6}});
    CHECK(split_line(u"\u05D0 12 \u05D1", 0, 6).ranges() == ranges{{4, 6}, {2, 4}, {0, 2}});
    CHECK(split_line(u"xx\u05D0 12", 2, 6).ranges() == ranges{{4, 6}, {2, 4}});
    CHECK(split_line("x\xD7\x90"
                     "b",
                     1, 4)
              .ranges() == ranges{{3, 4}, {1, 3}});
    CHECK(split_line(u"", 0, 0).items.empty());
}

TEST_CASE("an item has one script, and those of a run that is read to the left stand the other way", "[layout]")
{
    const split_line p{u"\u05D0\u05D1 \u0628\u0628", 0, 5};
    REQUIRE(p.items.size() == 2);
    CHECK(p.items[0].script == script_tag("Arab"));
    CHECK(p.items[1].script == script_tag("Hebr"));
    CHECK(p.items[0].first == 3);
    for (const text_item& i : p.items) CHECK(i.to_the_left());
}

TEST_CASE("a requested direction is the line's", "[layout]")
{
    CHECK(split_line(u"a\u05D0", 0, 2, direction::left_to_right).ranges() == ranges{{0, 1}, {1, 2}});
    CHECK(split_line(u"a\u05D0", 0, 2, direction::right_to_left).ranges() == ranges{{1, 2}, {0, 1}});
    // What stands before the line does not count.
    CHECK(split_line(u"\u05D0a\u05D0", 1, 3).ranges() == ranges{{1, 2}, {2, 3}});
}

TEST_CASE("a column's items stand from top to bottom, upright", "[layout]")
{
    const split_line p{u"a\u05D0\u05D1\u4E00", 0, 4, direction::top_to_bottom};
    CHECK(p.ranges() == ranges{{0, 1}, {1, 3}, {3, 4}});
    for (const text_item& i : p.items) {
        CHECK(i.orientation == glyph_orientation::upright);
        CHECK_FALSE(i.to_the_left());
    }
}

TEST_CASE("a column is cut where it turns, and what lies on its side keeps its direction", "[layout][columns]")
{
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 2;
    const split_line p{u"\u4E00a \u05D0\u05D1 12\u4E8C", how};
    CHECK(p.ranges() == ranges{{0, 1}, {1, 3}, {6, 8}, {3, 6}, {8, 9}});
    constexpr auto up = glyph_orientation::upright, side = glyph_orientation::sideways;
    const glyph_orientation wanted[] = {up, side, glyph_orientation::combined, side, up};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(p.items[k].orientation == wanted[k]);
        CHECK(p.items[k].to_the_left() == (k == 3));
    }
}

TEST_CASE("no grapheme is cut where the script or the level changes inside it", "[layout]")
{
    CHECK(split_line(u"xa\u093Fb", 0, 4).ranges() == ranges{{0, 4}});
    CHECK(split_line(u"\u05D0\u093F", 0, 2).ranges() == ranges{{0, 2}});  // a letter and a mark of two directions
    CHECK(split_line(u"a\u05D0\u200C", 0, 3).ranges() == ranges{{0, 1}, {1, 3}});  // not set as the line's end is
    CHECK(split_line(u"a\u093F", 0, 2, direction::top_to_bottom).ranges() == ranges{{0, 2}});
}

TEST_CASE("items of a line cover it", "[layout]")
{
    const std::u16string text = u"ab \u202Ecd\u202C (\u05D0 1.5% \u0628)\u2067x\u2069 \u4E00";
    for (std::size_t first = 0; first < text.size(); ++first) {
        const split_line p{text, first, text.size()};
        std::vector<int> times(text.size());
        for (const text_item& i : p.items)
            for (std::uint32_t u = i.first; u < i.last; ++u) ++times[u];
        for (std::size_t u = 0; u < text.size(); ++u) CHECK(times[u] == (u < first ? 0 : 1));
    }
}

TEST_CASE("a mixed line reports a memory that gives nothing, and keeps what it has", "[layout]")
{
    const std::u16string text = u"a \u05D0\u05D1 12 b";
    test::counting_memory counted;
    mixed_line line{counted.source()};
    buffer<text_item> items{counted.source()};
    REQUIRE_FALSE(line.split(text, 0, text.size(), {}, items));
    const std::size_t needed = counted.requests;
    REQUIRE_FALSE(line.split(text, 0, text.size(), {}, items));
    CHECK(counted.requests == needed);
    for (std::size_t at = 1; at <= needed; ++at) {
        test::counting_memory failing{.fail_at = at};
        mixed_line poor{failing.source()};
        buffer<text_item> none{failing.source()};
        CHECK(poor.split(text, 0, text.size(), {}, none) == error::out_of_memory);
    }
}

TEST_CASE("a line that is split after a column knows nothing of it", "[layout][mixed_line]")
{
    const std::u16string_view column = u"日本語 12 word", text = u"only one item";
    shape_options down;
    down.direction = direction::top_to_bottom;
    mixed_line reused;
    buffer<text_item> items;
    REQUIRE_FALSE(reused.split_column(column, 0, column.size(), down, [](char32_t) noexcept { return false; }, items));
    CHECK(items.size() > 1);
    REQUIRE_FALSE(reused.split(text, 0, text.size(), {}, items));
    REQUIRE(items.size() == 1);
    CHECK(items[0].orientation == glyph_orientation::horizontal);
}
