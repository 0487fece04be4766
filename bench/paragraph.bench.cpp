// SPDX-License-Identifier: MIT
//
// Paragraphs of 10^3 to 10^6 bytes: shaping once, then lines at another width each time. What counts are the ratios:
//
//     set_of_lay_out     analysing and shaping by laying out
//     ns_a_byte          of laying out: the same for any length, as far as the cache reaches
//     total_of_first     whole layouts of 200,000 bytes with total_fit by those with first_fit, at a width
//
//     paragraph_bench                  fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <ctime>
#include <string>

namespace {

using namespace typemesh;

struct sample {
    const char* font;
    const char* text;
};

const sample latin{"truetype/liberation/LiberationSerif-Regular.ttf", "The quick brown fox: A VAT To Ve jumps over "};
const sample mixed{"truetype/dejavu/DejaVuSans.ttf",
                   "\xD8\xA8\xD8\xB3\xD9\x85 \xD8\xA7\xD9\x84\xD9\x84\xD9\x87 2024 The quick brown fox "
                   "\xD8\xA7\xD9\x84\xD8\xB1\xD8\xAD\xD9\x85\xD9\x86 \xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D "};

void lay_out(benchmark::State& state, const sample& s, wrap_mode wrap, alignment align)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    auto font =
        harfbuzz_font::open((std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + s.font).c_str());
    if (!font) return state.SkipWithError(font.error().message());
    std::string text;
    while (text.size() < static_cast<std::size_t>(state.range(0))) text += s.text;
    paragraph words{*font};
    glyph_run run;

    // Of the processor's own time, which other programs do not count in.
    const auto seconds = [](std::clock_t from) { return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC; };
    const auto set = [&](std::size_t times) {
        for (std::size_t k = 0; k < times; ++k)
            if (!words.set(text) || !words.lay_out({.width = 20.0, .wrap = wrap}, run)) return false;
        return true;
    };
    if (!set(2)) return state.SkipWithError("no lines");
    const std::size_t often = 2'000'000 / text.size() + 1;
    const std::clock_t shaping = std::clock();
    if (!set(often)) return state.SkipWithError("no lines");
    const double whole = seconds(shaping) / static_cast<double>(often);

    double width = 20.0;
    std::size_t times = 0;
    const std::clock_t laying = std::clock();
    for (auto unused : state) {
        (void)unused;
        width = width < 40.0 ? width + 0.7 : 20.0;
        if (!words.lay_out({.width = width, .wrap = wrap, .align = align}, run)) return state.SkipWithError("no lines");
        ++times;
    }
    const double once = seconds(laying) / static_cast<double>(times);
    state.counters["set_of_lay_out"] = whole / once;
    state.counters["ns_a_byte"] = 1e9 * once / static_cast<double>(text.size());
}

/// Seconds of the processor for a layout, over several widths from state.range(0) em on.
template <line_breaker Breaker>
double seconds_of(benchmark::State& state, harfbuzz_font& font, const std::string& text, Breaker breaker)
{
    paragraph words{font, heap(), unicode_analyser{}, breaker};
    glyph_run run;
    const auto least = static_cast<double>(state.range(0));
    if (!words.set(text) || !words.lay_out({.width = least}, run)) return 0.0;
    constexpr int times = 20;
    const std::clock_t from = std::clock();
    for (int k = 0; k < times; ++k)
        if (!words.lay_out({.width = least * (1.0 + 0.02 * k), .align = alignment::justify}, run)) return 0.0;
    return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC / times;
}

void break_lines(benchmark::State& state, const sample& s)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    auto font =
        harfbuzz_font::open((std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + s.font).c_str());
    if (!font) return state.SkipWithError(font.error().message());
    std::string text;
    while (text.size() < 200'000) text += s.text;
    double first = 0.0, total = 0.0;
    for (auto unused : state) {
        (void)unused;
        first += seconds_of(state, *font, text, first_fit{});
        total += seconds_of(state, *font, text, total_fit{});
    }
    state.counters["total_of_first"] = total / first;
}

BENCHMARK_CAPTURE(lay_out, latin, latin, wrap_mode::word_or_grapheme, alignment::start)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000);
BENCHMARK_CAPTURE(lay_out, mixed, mixed, wrap_mode::word_or_grapheme, alignment::start)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000);
BENCHMARK_CAPTURE(lay_out, justified, mixed, wrap_mode::word_or_grapheme, alignment::justify)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000);
BENCHMARK_CAPTURE(lay_out, graphemes, mixed, wrap_mode::grapheme, alignment::start)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000);
BENCHMARK_CAPTURE(break_lines, latin, latin)->Arg(10)->Arg(20)->Arg(60)->Arg(400)->Iterations(1);
BENCHMARK_CAPTURE(break_lines, mixed, mixed)->Arg(20)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
