// SPDX-License-Identifier: MIT
#include "pieces.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>
#include <typemesh/unicode/hyphenating.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace total_fit_tests {
namespace {

using test::broken, test::ends_of, test::line_of, test::piece_list;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// By the definition; infinite for a line that is not within the tolerance.
double demerits_of(const total_fit& how, const piece_list& pieces, std::size_t first, std::size_t last,
                   const line_room& room)
{
    for (std::size_t k = first; k + 1 < last; ++k)
        if (pieces[k].ends_line()) return infinite;
    const break_piece& end = pieces[last - 1];
    const bool demanded = end.ends_line() || last == pieces.size();
    if (!demanded && end.end != piece_end::allowed) return infinite;
    const auto line = line_of(pieces, first, last, room);
    const double spare = room.width - line.width, stretch = line.stretch + how.emergency_stretch * room.width;
    double badness = 0.0;
    if (spare < 0.0) {
        if (0.0 - spare > room.shrink * line.stretch) return infinite;
        badness = 100.0 * std::pow(0.0 - spare / (room.shrink * line.stretch), 3);
    } else if (!demanded && spare > 0.0) {
        if (spare > how.tolerance * stretch) return infinite;
        badness = 100.0 * std::pow(2.0 * spare / stretch, 3);
    }
    return std::pow(10.0 + badness, 2) + (end.hyphen && !demanded ? std::pow(how.hyphen_penalty, 2) : 0.0);
}

double demerits_of(const total_fit& how, const piece_list& pieces, const ends_of& ends, const line_room& room)
{
    double sum = 0.0;
    std::size_t first = 0;
    for (const std::uint32_t last : ends) {
        sum += demerits_of(how, pieces, first, last, room);
        first = last;
    }
    return sum;
}

/// The least demerits that any lines have, of all 2^(n - 1) ways to end them.
double least_demerits(const total_fit& how, const piece_list& pieces, const line_room& room)
{
    double least = infinite;
    for (std::uint32_t chosen = 0; chosen < 1u << (pieces.size() - 1); ++chosen) {
        double sum = 0.0;
        std::size_t first = 0;
        for (std::size_t last = 1; last <= pieces.size() && sum < least; ++last) {
            if (last < pieces.size() && (chosen >> (last - 1) & 1) == 0) continue;
            sum += demerits_of(how, pieces, first, last, room);
            first = last;
        }
        if (sum < least) least = sum;
    }
    return least;
}

/// The same for long texts: of all beginnings, not of 32.
double least_demerits_of_many(const total_fit& how, const piece_list& pieces, const line_room& room,
                              std::size_t shortest, std::size_t longest)
{
    std::vector<double> best(pieces.size() + 1, infinite);
    best[0] = 0.0;
    for (std::size_t last = 1; last <= pieces.size(); ++last)
        for (std::size_t first = last > longest ? last - longest : 0;
             first + (last < pieces.size() ? shortest : 1) <= last; ++first)
            if (best[first] < infinite)
                best[last] = (std::min)(best[last], best[first] + demerits_of(how, pieces, first, last, room));
    return best.back();
}

struct dice {
    std::mt19937 random{20261122};
    double below(unsigned n) { return static_cast<double>(random() % n); }
    bool one_in(unsigned n) { return random() % n == 0; }
};

piece_list some_pieces(dice& d, std::size_t count)
{
    piece_list pieces(count);
    for (break_piece& p : pieces) {
        p = {.width = 1.0 + d.below(8), .space = d.below(3), .begin_change = d.one_in(4) ? d.below(2) : 0.0};
        p.stretch = p.space;
        p.hyphen = d.one_in(4);
        if (p.hyphen) p.end_change = 1.0;
        if (d.one_in(8)) p.end_change = -0.5;
        if (d.one_in(16)) p.width = 0.0;
        if (d.one_in(32)) p.width = p.end_change = 0.0;
    }
    pieces.back().end = piece_end::paragraph;
    return pieces;
}

struct in_the_middle {
    template <class Put>
    void hyphenate(text_view, text_range word, std::string_view, const Put& put) noexcept
    {
        put((word.first + word.last) / 2);
    }
};

}  // namespace
}  // namespace total_fit_tests

using namespace total_fit_tests;

TEST_CASE("total_fit evens lines out that first_fit leaves ragged", "[paragraph]")
{
    const piece_list pieces = test::words({3, 2, 2, 5});
    CHECK(broken(first_fit{}, pieces, {.width = 6.0}) == ends_of{2, 3, 4});
    CHECK(broken(total_fit{.emergency_stretch = 1.0}, pieces, {.width = 6.0}) == ends_of{1, 3, 4});
}

TEST_CASE("total_fit finds the lines of fewest demerits among all possible lines", "[paragraph]")
{
    dice d;
    int found = 0;
    for (int round = 0; round < 400; ++round) {
        const piece_list pieces = some_pieces(d, 1 + d.random() % (round % 20 == 0 ? 16 : 11));
        const line_room room{.width = 8.0 + d.below(20), .indent = d.below(3), .shrink = d.below(3) / 4};
        const total_fit how{.tolerance = 0.5 + d.below(3), .hyphen_penalty = d.below(3) * 40.0};
        const double least = least_demerits(how, pieces, room);
        if (!(least < infinite)) continue;
        ++found;
        const double got = demerits_of(how, pieces, broken(how, pieces, room), room);
        CHECK(got <= least * (1.0 + 1e-12));
    }
    CHECK(found > 150);
}

TEST_CASE("every line of total_fit is within the tolerance, or first_fit made it", "[paragraph]")
{
    dice d;
    int within = 0, helped = 0;
    for (int round = 0; round < 300; ++round) {
        piece_list pieces = some_pieces(d, 1 + d.random() % 80);
        for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
            const piece_end ends[] = {piece_end::never, piece_end::in_need, piece_end::line, piece_end::paragraph};
            if (d.one_in(6)) pieces[k].end = ends[d.random() % 4];
            pieces[k].tab = pieces[k].end == piece_end::never && d.one_in(2);
        }
        const line_room room{.width = 6.0 + d.below(30), .indent = d.below(3), .shrink = d.below(3) / 4, .tab = 4.0};
        const total_fit how{.tolerance = 0.5 + d.below(3)};
        const ends_of ends = broken(how, pieces, room);
        REQUIRE(ends.back() == pieces.size());
        std::size_t first = 0;
        for (const std::uint32_t last : ends) {
            REQUIRE(last > first);
            REQUIRE(pieces[last - 1].end != piece_end::never);
            for (std::size_t k = first; k + 1 < last; ++k) REQUIRE_FALSE(pieces[k].ends_line());
            const bool fits = demerits_of(how, pieces, first, last, room) < infinite;
            const bool fresh = first == 0 || pieces[first - 1].end == piece_end::paragraph;
            if (!fits) CHECK(first_fit::end_of(pieces, first, room.start(fresh), room) == last);
            (fits ? within : helped) += 1;
            first = last;
        }
    }
    CHECK(within > 500);
    CHECK(helped > 100);
}

TEST_CASE("lines of hundreds of words are nearly the best, though 32 beginnings are compared at a time", "[paragraph]")
{
    dice d;
    piece_list pieces(1500);
    for (break_piece& p : pieces) p = {.width = 1.0 + d.below(8), .space = 1.0, .stretch = 1.0};
    pieces.back().end = piece_end::paragraph;
    const line_room room{.width = 700.0, .shrink = 0.33};
    const total_fit how;
    const ends_of ends = broken(how, pieces, room);
    const double got = demerits_of(how, pieces, ends, room);
    CHECK(got < infinite);
    CHECK(got <= 1.01 * least_demerits_of_many(how, pieces, room, 90, 190));
}

TEST_CASE("emergency_stretch sets a paragraph that has no lines without it", "[paragraph]")
{
    const piece_list pieces = test::words({6, 6, 6, 3, 3});
    const line_room room{.width = 10.0};
    const total_fit plain, helped{.emergency_stretch = 0.5};
    CHECK_FALSE(demerits_of(plain, pieces, broken(plain, pieces, room), room) < infinite);
    const ends_of ends = broken(helped, pieces, room);
    CHECK(demerits_of(helped, pieces, ends, room) == least_demerits(helped, pieces, room));

    // Where it is not needed it changes nothing.
    const piece_list easy = test::words({3, 5, 4, 4, 4, 4, 2});
    CHECK(broken(plain, easy, room) == broken(helped, easy, room));
    CHECK(demerits_of(plain, easy, broken(plain, easy, room), room) < infinite);
}

TEST_CASE("without a width total_fit ends lines where the text demands it", "[paragraph]")
{
    piece_list pieces = test::words({3, 3, 3});
    CHECK(broken(total_fit{}, pieces, {}) == ends_of{3});
    CHECK(broken(total_fit{.emergency_stretch = 0.1}, pieces, {}) == ends_of{3});
    pieces[1].end = piece_end::line;
    CHECK(broken(total_fit{}, pieces, {}) == ends_of{2, 3});
    CHECK(broken(total_fit{}, pieces, {.max_lines = 1}) == ends_of{2});
    CHECK(broken(total_fit{}, {}, {}).empty());
}

TEST_CASE("total_fit refuses options out of their range and reports a memory that gives nothing", "[paragraph]")
{
    const piece_list pieces = test::words({1});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    buffer<std::uint32_t> ends;
    for (const total_fit& how :
         {total_fit{.tolerance = nan}, total_fit{.tolerance = -1.0}, total_fit{.hyphen_penalty = -1.0},
          total_fit{.emergency_stretch = infinite}, total_fit{.emergency_stretch = -0.1}})
        CHECK(how.break_lines(pieces, {}, ends) == error::bad_option);
    test::counting_memory failing{.fail_at = 1};
    buffer<std::uint32_t> none{failing.source()};
    CHECK(total_fit{}.break_lines(pieces, {}, none) == error::out_of_memory);
}

TEST_CASE("a paragraph keeps the memory that total_fit needs", "[paragraph]")
{
    std::string text;
    for (int k = 0; k < 200; ++k) text += k % 7 == 0 ? "longer\tones " : "of a fi\xC2\xAD\x66th ";
    test::toy_shaper font;
    test::counting_memory counted;
    paragraph words{font, counted.source(), unicode_analyser{counted.source()}, total_fit{.emergency_stretch = 0.1}};
    glyph_run run{counted.source()};
    REQUIRE(words.set(text));
    REQUIRE(words.lay_out({.width = 6.0, .align = alignment::justify}, run));
    const std::size_t before = counted.requests, lines = run.lines.size(), glyphs = run.glyphs.size();
    for (const double width : {20.0, 9.0, 31.0, 12.3, 6.0})
        REQUIRE(words.lay_out({.width = width, .align = alignment::justify}, run));
    CHECK(counted.requests == before);
    CHECK(run.lines.size() == lines);
    CHECK(run.glyphs.size() == glyphs);
}

TEST_CASE("words are parted with hyphens, as hyphen_penalty allows", "[paragraph]")
{
    test::toy_shaper font;
    paragraph words{font, heap(), hyphenating{unicode_analyser{}, in_the_middle{}}, total_fit{.tolerance = 5.0}};
    glyph_run run;
    REQUIRE(words.set("a b cdef gh ij"));
    const auto hyphens = [&](double penalty) {
        words.breaker().hyphen_penalty = penalty;
        REQUIRE(words.lay_out({.width = 3.3}, run));
        for (const text_line& line : run.lines) CHECK(line.advance <= 3300.0);
        return std::ranges::count(run.glyphs, glyph_id{0x2010}, &placed_glyph::id);
    };
    CHECK(hyphens(0.0) == 2);
    CHECK(hyphens(1e9) == 1);  // nothing else is within the tolerance
    words.breaker().tolerance = 12.0;
    CHECK(hyphens(0.0) == 2);
    CHECK(hyphens(1e9) == 0);
}
