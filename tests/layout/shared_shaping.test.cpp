// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/plain_text_law.hpp"

#include <typemesh/unicode/utf.hpp>

#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// Every code point is a glyph of that number; '?' is missing and parted, '!' is refused, 'h' has another face.
struct counting_shaper {
    double units_per_em() const noexcept { return 1000.0; }
    line_metrics metrics(direction) const noexcept { return {700.0, -200.0, 100.0}; }
    error shape(text_view text, const text_item& item, const shape_options&, buffer<shaped_glyph>& glyphs) noexcept
    {
        for (std::size_t i = item.first; i < item.last;) {
            const code_point c = decode(text, i, item.last);
            const auto cluster = static_cast<cluster_id>(i);
            if (c.value == '!') return error{error::needs_shaping}.at(no_glyph, cluster);
            const glyph_flags flags = c.value == '?' ? glyph_flags::missing | glyph_flags::parted : glyph_flags::none;
            const std::uint16_t face = c.value == 'h' ? 1 : 0;
            if (!glyphs.push_back({static_cast<glyph_id>(c.value), cluster, 400.0 + c.value, {}, face, flags}))
                return error::out_of_memory;
            i = c.next;
        }
        return {};
    }
};

/// What each worker has.
struct workers_at_hand {
    test::scrambled_workers several;
    std::vector<counting_shaper> shapers;
    std::vector<buffer<shaped_glyph>> glyphs;
    plain_layout lay_out;

    workers_at_hand(std::size_t count, std::uint32_t seed, memory source = heap())
        : several{count, seed}, shapers(count), lay_out{source}
    {
        for (std::size_t i = 0; i < count; ++i) glyphs.emplace_back(source);
    }
    result<void> set(text_view text, const shape_options& how, const layout_options& options, glyph_run& run)
    {
        counting_shaper font;
        return lay_out(font, text, how, options, run, this);
    }
    error shape(shared_shaping& shared, const shaped_text& shaped) noexcept
    {
        return shared(
            several, [this](std::size_t w) noexcept -> counting_shaper& { return shapers[w]; },
            [this](std::size_t w) noexcept -> buffer<shaped_glyph>& { return glyphs[w]; }, shaped);
    }
};

void check_same(const glyph_run& a, const glyph_run& b)
{
    CHECK(test::difference(a, b) == "");
    CHECK(a.glyph_styles.size() == b.glyph_styles.size());
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
    how.letter_spacing = GENERATE(0.0, 0.25);
    const layout_options options{.align = align, .line_spacing = 1.5};
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

TEST_CASE("of several lines that are refused the first is named, and the run is empty", "[layout][threads]")
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
    const layout_options bad{.line_spacing = std::numeric_limits<double>::quiet_NaN()};
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
        if (!e) break;
        ++failures;
        CHECK(e == error::out_of_memory);
        CHECK(out.glyphs.empty());
        CHECK(out.lines.empty());
        REQUIRE(team.set(text, {}, {}, out));
        check_same(out, expected);
    }
    CHECK(failures > 5);
}
