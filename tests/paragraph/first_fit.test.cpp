// SPDX-License-Identifier: MIT
#include "pieces.hpp"
#include "support/counting_memory.hpp"

#include <random>

using namespace typemesh;

namespace {

using test::ends_of, test::words;

ends_of first_fit_of(const test::piece_list& pieces, const line_room& room)
{
    return test::broken(first_fit{}, pieces, room);
}

}  // namespace

TEST_CASE("a hyphen that does not fit is not set", "[paragraph]")
{
    // a, b, a soft hyphen, which the line may end with, c
    test::piece_list pieces(4, break_piece{.width = 1.0, .end = piece_end::in_need});
    pieces[2] = {.end_change = 1.0, .hyphen = true};
    pieces[3].end = piece_end::paragraph;
    CHECK(first_fit_of(pieces, {.width = 2.0}) == ends_of{2, 4});
    CHECK(first_fit_of(pieces, {.width = 2.5}) == ends_of{2, 4});
    CHECK(first_fit_of(pieces, {.width = 3.0}) == ends_of{4});
    pieces[3].width = 2.0;
    CHECK(first_fit_of(pieces, {.width = 3.0}) == ends_of{3, 4});
}

TEST_CASE("a line takes all words that fit, and white space at its end does not count", "[paragraph]")
{
    CHECK(first_fit_of(words({3, 3, 3}), {.width = 7.0}) == ends_of{2, 3});
    CHECK(first_fit_of(words({3, 3, 3}), {.width = 6.999}) == ends_of{1, 2, 3});
    CHECK(first_fit_of(words({3, 3, 3}), {}) == ends_of{3});
    CHECK(first_fit_of(words({3, 3, 3}), {.width = 7.0, .indent = 1.0}) == ends_of{1, 3});
}

TEST_CASE("what a line's ends change counts at its ends only", "[paragraph]")
{
    auto hyphened = words({3, 3, 3});
    for (break_piece& p : hyphened) p.space = 0.0;
    hyphened[1].end_change = 1.0;
    CHECK(first_fit_of(hyphened, {.width = 6.5}) == ends_of{1, 3});
    CHECK(first_fit_of(hyphened, {.width = 7.0}) == ends_of{2, 3});
    CHECK(first_fit_of(hyphened, {.width = 9.0}) == ends_of{3});
    auto kerned = words({3, 3, 3});
    kerned[1].end_change = -0.5;
    CHECK(first_fit_of(kerned, {.width = 6.5}) == ends_of{2, 3});
    kerned[1].begin_change = 0.5;
    kerned[1].end_change = 0.0;
    CHECK(first_fit_of(kerned, {.width = 7.0}) == ends_of{2, 3});
    kerned[0].width = 6.0;
    CHECK(first_fit_of(kerned, {.width = 7.0}) == ends_of{1, 2, 3});  // the second word is wider at a line's beginning
}

TEST_CASE("a word that is too long sticks out, or is broken in need, in a line of its own", "[paragraph]")
{
    CHECK(first_fit_of(words({1, 9, 1}), {.width = 4.0}) == ends_of{1, 2, 3});
    test::piece_list letters = words({1, 2, 2, 2, 2, 1});
    for (std::size_t k = 1; k < 4; ++k) letters[k].end = piece_end::in_need, letters[k].space = 0.0;
    CHECK(first_fit_of(letters, {.width = 4.0}) == ends_of{1, 3, 5, 6});
    CHECK(first_fit_of(letters, {.width = 0.5}) == ends_of{1, 2, 3, 4, 5, 6});  // one at least
    CHECK(first_fit_of(letters, {.width = 11.0}) == ends_of{5, 6});
}

TEST_CASE("a line ends where the text demands it and never where it forbids it", "[paragraph]")
{
    test::piece_list pieces = words({1, 1, 1, 1});
    pieces[1].end = piece_end::line;
    CHECK(first_fit_of(pieces, {}) == ends_of{2, 4});
    pieces[1].end = piece_end::never;
    CHECK(first_fit_of(pieces, {.width = 3.5}) == ends_of{1, 3, 4});
    CHECK(first_fit_of(pieces, {.width = 0.5}) == ends_of{1, 3, 4});
    pieces[1].end = piece_end::paragraph;
    CHECK(first_fit_of(pieces, {.width = 3.0, .indent = 1.0}) == ends_of{1, 2, 3, 4});
    pieces[1].end = piece_end::line;  // no paragraph begins behind it
    CHECK(first_fit_of(pieces, {.width = 3.0, .indent = 1.0}) == ends_of{1, 2, 4});
}

TEST_CASE("white space by itself never begins a line", "[paragraph]")
{
    test::piece_list pieces{{.width = 3.0, .end = piece_end::never, .tab = true}, {.end = piece_end::paragraph}};
    CHECK(first_fit_of(pieces, {.width = 3.0, .tab = 4.0}) == ends_of{2});
    CHECK(first_fit_of({{.space = 9.0, .end = piece_end::paragraph}}, {.width = 3.0}) == ends_of{1});
}

TEST_CASE("a breaker stops after the lines that are wanted", "[paragraph]")
{
    CHECK(first_fit_of(words({3, 3, 3}), {.width = 3.0, .max_lines = 2}) == ends_of{1, 2});
    CHECK(first_fit_of({}, {}).empty());
}

TEST_CASE("each line fits and its successor's first word would not have", "[paragraph]")
{
    std::mt19937 random{20240711};
    const auto below = [&random](unsigned n) { return static_cast<double>(random() % n); };
    for (int round = 0; round < 300; ++round) {
        test::piece_list pieces(1 + random() % 60);
        for (break_piece& p : pieces)
            p = {.width = 1.0 + below(8),
                 .space = below(3),
                 .begin_change = below(2),
                 .end_change = 2.0 * (random() % 4 == 0 ? 1.0 : 0.0)};
        pieces.back().end = piece_end::paragraph;
        const line_room room{.width = 4.0 + below(20)};
        const ends_of ends = first_fit_of(pieces, room);
        REQUIRE(ends.back() == pieces.size());
        std::size_t first = 0;
        for (const std::uint32_t last : ends) {
            REQUIRE(last > first);
            if (last - first > 1) CHECK(test::line_of(pieces, first, last, room).width <= room.width);
            bool more = false;
            for (std::size_t k = last + 1; k <= pieces.size(); ++k)
                more = more || test::line_of(pieces, first, k, room).width <= room.width;
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
