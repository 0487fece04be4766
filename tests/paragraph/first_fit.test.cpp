// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/paragraph/first_fit.hpp>

#include <random>
#include <vector>

using namespace typemesh;

namespace {

using ends_of = std::vector<std::uint32_t>;

ends_of broken(const std::vector<break_piece>& pieces, const line_room& room)
{
    buffer<std::uint32_t> ends;
    REQUIRE_FALSE(first_fit{}.break_lines(pieces, room, ends));
    return {ends.begin(), ends.end()};
}

std::vector<break_piece> words(std::initializer_list<double> widths, piece_end end = piece_end::allowed)
{
    std::vector<break_piece> all;
    for (const double w : widths) all.push_back({.width = w, .space = 1.0, .end = end});
    all.back().end = piece_end::paragraph;
    return all;
}

/// The width of pieces [first, last) as a line: what first_fit promises to keep below the room.
double width_of(const std::vector<break_piece>& pieces, std::size_t first, std::size_t last)
{
    double pen = pieces[first].begin_change, width = 0.0;
    for (std::size_t k = first; k < last; ++k) {
        if (pieces[k].width > 0.0) width = pen + pieces[k].width + (k + 1 == last ? pieces[k].end_change : 0.0);
        pen += pieces[k].width + pieces[k].space;
    }
    return width;
}

}  // namespace

TEST_CASE("a hyphen that does not fit is not set", "[paragraph]")
{
    // a, b, a soft hyphen, which the line may end with, c
    std::vector<break_piece> pieces(4, break_piece{.width = 1.0, .end = piece_end::in_need});
    pieces[2] = {.end_change = 1.0, .hyphen = true};
    pieces[3].end = piece_end::paragraph;
    CHECK(broken(pieces, {.width = 2.0}) == ends_of{2, 4});
    CHECK(broken(pieces, {.width = 2.5}) == ends_of{2, 4});
    CHECK(broken(pieces, {.width = 3.0}) == ends_of{4});
    pieces[3].width = 2.0;
    CHECK(broken(pieces, {.width = 3.0}) == ends_of{3, 4});
}

TEST_CASE("a line takes all words that fit, and white space at its end does not count", "[paragraph]")
{
    CHECK(broken(words({3, 3, 3}), {.width = 7.0}) == ends_of{2, 3});
    CHECK(broken(words({3, 3, 3}), {.width = 6.999}) == ends_of{1, 2, 3});
    CHECK(broken(words({3, 3, 3}), {}) == ends_of{3});
    CHECK(broken(words({3, 3, 3}), {.width = 7.0, .indent = 1.0}) == ends_of{1, 3});
}

TEST_CASE("what a line's ends change counts at its ends only", "[paragraph]")
{
    auto hyphened = words({3, 3, 3});
    for (break_piece& p : hyphened) p.space = 0.0;
    hyphened[1].end_change = 1.0;
    CHECK(broken(hyphened, {.width = 6.5}) == ends_of{1, 3});
    CHECK(broken(hyphened, {.width = 7.0}) == ends_of{2, 3});
    CHECK(broken(hyphened, {.width = 9.0}) == ends_of{3});
    auto kerned = words({3, 3, 3});
    kerned[1].end_change = -0.5;
    CHECK(broken(kerned, {.width = 6.5}) == ends_of{2, 3});
    kerned[1].begin_change = 0.5;
    kerned[1].end_change = 0.0;
    CHECK(broken(kerned, {.width = 7.0}) == ends_of{2, 3});
    kerned[0].width = 6.0;
    CHECK(broken(kerned, {.width = 7.0}) == ends_of{1, 2, 3});  // the second word is wider at a line's beginning
}

TEST_CASE("a word that is too long sticks out, or is broken in need, in a line of its own", "[paragraph]")
{
    CHECK(broken(words({1, 9, 1}), {.width = 4.0}) == ends_of{1, 2, 3});
    std::vector<break_piece> letters = words({1, 2, 2, 2, 2, 1});
    for (std::size_t k = 1; k < 4; ++k) letters[k].end = piece_end::in_need, letters[k].space = 0.0;
    CHECK(broken(letters, {.width = 4.0}) == ends_of{1, 3, 5, 6});
    CHECK(broken(letters, {.width = 0.5}) == ends_of{1, 2, 3, 4, 5, 6});  // one at least
    CHECK(broken(letters, {.width = 11.0}) == ends_of{5, 6});
}

TEST_CASE("a line ends where the text demands it and never where it forbids it", "[paragraph]")
{
    std::vector<break_piece> pieces = words({1, 1, 1, 1});
    pieces[1].end = piece_end::line;
    CHECK(broken(pieces, {}) == ends_of{2, 4});
    pieces[1].end = piece_end::never;
    CHECK(broken(pieces, {.width = 3.5}) == ends_of{1, 3, 4});
    CHECK(broken(pieces, {.width = 0.5}) == ends_of{1, 3, 4});
    pieces[1].end = piece_end::paragraph;
    CHECK(broken(pieces, {.width = 3.0, .indent = 1.0}) == ends_of{1, 2, 3, 4});
    pieces[1].end = piece_end::line;  // no paragraph begins behind it
    CHECK(broken(pieces, {.width = 3.0, .indent = 1.0}) == ends_of{1, 2, 4});
}

TEST_CASE("white space by itself never begins a line", "[paragraph]")
{
    std::vector<break_piece> pieces{{.width = 3.0, .end = piece_end::never, .tab = true},
                                    {.end = piece_end::paragraph}};
    CHECK(broken(pieces, {.width = 3.0, .tab = 4.0}) == ends_of{2});
    CHECK(broken({{.space = 9.0, .end = piece_end::paragraph}}, {.width = 3.0}) == ends_of{1});
}

TEST_CASE("a breaker stops after the lines that are wanted", "[paragraph]")
{
    CHECK(broken(words({3, 3, 3}), {.width = 3.0, .max_lines = 2}) == ends_of{1, 2});
    CHECK(broken({}, {}).empty());
}

TEST_CASE("each line fits and its successor's first word would not have", "[paragraph]")
{
    std::mt19937 random{20240711};
    const auto below = [&random](unsigned n) { return static_cast<double>(random() % n); };
    for (int round = 0; round < 300; ++round) {
        std::vector<break_piece> pieces(1 + random() % 60);
        for (break_piece& p : pieces)
            p = {.width = 1.0 + below(8),
                 .space = below(3),
                 .begin_change = below(2),
                 .end_change = 2.0 * (random() % 4 == 0 ? 1.0 : 0.0)};
        pieces.back().end = piece_end::paragraph;
        const line_room room{.width = 4.0 + below(20)};
        const ends_of ends = broken(pieces, room);
        REQUIRE(ends.back() == pieces.size());
        std::size_t first = 0;
        for (const std::uint32_t last : ends) {
            REQUIRE(last > first);
            if (last - first > 1) CHECK(width_of(pieces, first, last) <= room.width);
            bool more = false;
            for (std::size_t k = last + 1; k <= pieces.size(); ++k)
                more = more || width_of(pieces, first, k) <= room.width;
            CHECK_FALSE(more);
            first = last;
        }
    }
}

TEST_CASE("first_fit reports a memory that gives nothing", "[paragraph]")
{
    test::counting_memory failing{.fail_at = 1};
    buffer<std::uint32_t> ends{failing.source()};
    CHECK(first_fit{}.break_lines(words({1}), {}, ends) == error::out_of_memory);
}
