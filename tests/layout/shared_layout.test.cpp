// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/layout/shared_layout.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// Every code point is a glyph of that number; '?' is missing, '!' refused, what is no UTF-8 noted. 'g' and 'h' have looks
/// of their own; that of '$' is in no table.
struct counting_shaper {
    double units_per_em() const noexcept { return 1000.0; }
    line_metrics metrics(direction) const noexcept { return {700.0, -200.0, 100.0}; }
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& how,
                        glyph_run& run) noexcept
    {
        point pen;
        const bool down = how.direction == direction::top_to_bottom;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            const auto cluster = static_cast<cluster_id>(i);
            if (c.value == '!') return error{error::needs_shaping}.at(no_glyph, cluster);
            const bool missing = c.value == '?';
            if (missing) run.note_missing(cluster);
            if (missing) run.note_parted(cluster);
            if (!c.valid) run.note_invalid_units(cluster);
            const look own = c.value == 'g' ? look{.style = style_id{1}} : c.value == 'h' ? look{.face = 1} : look{};
            const auto number = c.value == '$' ? result<std::uint32_t>{999u} : run.number_of(own);
            if (!number) return number.error();
            if (!run.glyphs.push_back({static_cast<glyph_id>(c.value), cluster, pen, missing, *number}))
                return error::out_of_memory;
            (down ? pen.y : pen.x) += (down ? -1.0 : 1.0) * (400.0 + c.value);
            i = c.next;
        }
        return pen;
    }
};

/// What each worker has.
struct workers_at_hand {
    test::scrambled_workers several;
    std::vector<counting_shaper> shapers;
    std::vector<glyph_run> runs;
    shared_layout shared;

    workers_at_hand(std::size_t count, std::uint32_t seed, memory source = heap())
        : several{count, seed}, shapers(count), shared{source}
    {
        for (std::size_t i = 0; i < count; ++i) runs.emplace_back(source);
    }
    result<void> set(text_view text, const shape_options& how, const layout_options& options, glyph_run& run)
    {
        counting_shaper font;
        return shared(
            several, [this](std::size_t w) noexcept -> counting_shaper& { return shapers[w]; },
            [this](std::size_t w) noexcept -> glyph_run& { return runs[w]; }, font, text, how, options, run);
    }
};

void check_same(const glyph_run& a, const glyph_run& b)
{
    CHECK(std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(),
                     [](const placed_glyph& g, const placed_glyph& h) {
                         return g.id == h.id && g.cluster == h.cluster && g.origin == h.origin &&
                                g.missing == h.missing;
                     }));
    CHECK(a.looks.size() == b.looks.size());
    const auto look_of = [](const glyph_run& run, const placed_glyph& g) {
        return run.looks.empty() ? look{} : run.looks[g.look];
    };
    bool alike = true;
    for (std::size_t i = 0; i < a.glyphs.size() && i < b.glyphs.size(); ++i)
        alike = alike && look_of(a, a.glyphs[i]) == look_of(b, b.glyphs[i]);
    CHECK(alike);
    CHECK(std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                     [](const text_line& l, const text_line& m) {
                         return l.first_glyph == m.first_glyph && l.glyph_count == m.glyph_count &&
                                l.origin == m.origin && l.advance == m.advance;
                     }));
    CHECK(a.units_per_em == b.units_per_em);
    CHECK(a.missing == b.missing);
    CHECK(a.first_missing == b.first_missing);
    CHECK(a.parted == b.parted);
    CHECK(a.first_parted == b.first_parted);
    CHECK(a.invalid_units == b.invalid_units);
    CHECK(a.first_invalid_unit == b.first_invalid_unit);
}

/// Lines of all lengths, empty ones among them.
std::string long_text(std::size_t length)
{
    std::string text;
    std::uint32_t r = 1;
    while (text.size() < length) {
        r = r * 1664525u + 1013904223u;
        const std::uint32_t k = r >> 24;
        text += k < 8    ? "\n"
                : k < 12 ? "\r\n"
                : k < 14 ? "\n\n\n"
                : k < 15 ? "?"
                : k < 16 ? "\t"
                : k < 17 ? "\xFF"
                         : &"abcdefgh"[k % 8];
    }
    return text;
}

}  // namespace

TEST_CASE("several workers set a text as one does", "[layout][threads]")
{
    const std::string text = GENERATE(std::string{}, std::string{"a"}, std::string{"\n"}, std::string{"one\n\ntwo\r\n"},
                                      long_text(300), long_text(5000), long_text(60'000), std::string(4000, 'x'));
    const auto align = GENERATE(alignment::left, alignment::centre, alignment::right);
    shape_options how;
    how.direction = GENERATE(direction::automatic, direction::top_to_bottom);
    const layout_options options{.align = align, .line_spacing = 1.5, .letter_spacing = GENERATE(0.0, 0.25)};
    counting_shaper font;
    glyph_run expected;
    REQUIRE(layout(font, text, how, options, expected));
    for (const std::size_t count : {1u, 2u, 3u, 8u}) {
        workers_at_hand team{count, 7};
        for (int round = 0; round < 2; ++round) {
            glyph_run run;
            REQUIRE(team.set(text, how, options, run));
            check_same(run, expected);
        }
    }
}

TEST_CASE("a look that a shaper names and no table holds is refused by name", "[layout][threads]")
{
    workers_at_hand team{3, 1};
    glyph_run run;
    const error e = team.set(long_text(3000) + "gh\n$", {}, {}, run).error();
    CHECK(e == error::no_such_look);
    CHECK(e.glyph == '$');
    CHECK(run.glyphs.empty());
    CHECK(run.looks.empty());
}

TEST_CASE("of several lines that are refused the first is told, and the run is empty", "[layout][threads]")
{
    std::string text = long_text(20'000);
    for (const std::size_t at : {17'000u, 9000u, 8990u, 3u}) {
        text.insert(at, "!");
        counting_shaper font;
        glyph_run run;
        const error expected = layout(font, text, {}, {}, run).error();
        REQUIRE(expected == error::needs_shaping);
        for (std::uint32_t seed = 1; seed < 10; ++seed) {
            workers_at_hand team{3, seed};
            const error e = team.set(text, {}, {}, run).error();
            CHECK(e == error::needs_shaping);
            CHECK(e.cluster == expected.cluster);
            CHECK(run.glyphs.empty());
            CHECK(run.lines.empty());
            CHECK(run.missing == 0);
        }
    }
    workers_at_hand team{2, 1};
    glyph_run run;
    const layout_options bad{alignment::left, std::numeric_limits<double>::quiet_NaN()};
    const error e = team.set("a", {}, bad, run).error();
    CHECK(e == error::bad_option);
    CHECK(std::string{e.option} == "line_spacing");
    counting_shaper font;
    CHECK(std::string{layout(font, "a", {}, bad, run).error().option} == e.option);
}

TEST_CASE("setting a text again needs no memory, and memory that fails leaves an empty run", "[layout][threads]")
{
    const std::string text = long_text(3000);
    counting_shaper font;
    glyph_run expected;
    REQUIRE(layout(font, text, {}, {}, expected));
    test::counting_memory counted;
    workers_at_hand warm{3, 1, counted.source()};
    glyph_run run{counted.source()};
    for (int i = 0; i < 30; ++i) REQUIRE(warm.set(text, {}, {}, run));  // the seed goes on: all have had all
    const std::size_t before = counted.requests;
    for (int i = 0; i < 5; ++i) REQUIRE(warm.set(text, {}, {}, run));
    CHECK(counted.requests == before);

    std::size_t failures = 0;
    for (std::size_t n = 1; n < 200; ++n) {
        test::counting_memory failing{.fail_at = n, .fail_once = true};
        workers_at_hand team{3, 1, failing.source()};
        glyph_run out{failing.source()};
        const error e = team.set(text, {}, {}, out).error();
        if (e) {
            ++failures;
            CHECK(e == error::out_of_memory);
            CHECK(out.glyphs.empty());
            CHECK(out.lines.empty());
        }
        REQUIRE(team.set(text, {}, {}, out));
        check_same(out, expected);
        if (failing.requests < n) break;
    }
    CHECK(failures > 5);
}
