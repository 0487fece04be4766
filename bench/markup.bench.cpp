// SPDX-License-Identifier: MIT
//
// Mark-up beside the time that HarfBuzz needs to shape the same text without tags, line by line. What counts is the ratio:
//
//     of_shaping     reading the mark-up, in per cent of shaping: of text without tags at most 1, with a tag for every
//                    ten letters at most 5
//     ns_a_tag       of reading
//
//     markup_bench                     fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/markup/markup_styles.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <ctime>
#include <string>

namespace {

using namespace typemesh;

constexpr const char* font_file = "truetype/liberation/LiberationSerif-Regular.ttf";
constexpr std::uint32_t line_length = 60;

double seconds(std::clock_t from) { return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC; }

/// Of the processor's own time, for one letter; 0 after a failure.
double shaping_seconds(harfbuzz_font& font, const std::string& text)
{
    buffer<shaped_glyph> glyphs;
    std::size_t letters = 0;
    const std::clock_t begin = std::clock();
    while (seconds(begin) < 0.5) {
        for (std::uint32_t at = 0; at + line_length <= text.size(); at += line_length) {
            glyphs.clear();
            if (font.shape(text, text_item{.first = at, .last = at + line_length}, {}, glyphs)) return 0.0;
            letters += line_length;
        }
    }
    return seconds(begin) / static_cast<double>(letters);
}

/// 100,000 letters with a tag after so many; 0: no tags. The tags that open have `kinds` different values.
void read(benchmark::State& state, std::size_t letters_a_tag, std::uint32_t kinds, bool styles_too)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    auto font =
        harfbuzz_font::open((std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + font_file).c_str());
    if (!font) return state.SkipWithError(font.error().message());
    std::string text, source;
    while (text.size() < 100'000) text += "The quick brown fox: A VAT To Ve jumps over the lazy dog, ";
    std::uint32_t tags = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        source += text[i];
        if (letters_a_tag == 0 || i % letters_a_tag != 0) continue;
        source += tags % 2 != 0 ? "[/colour]" : "[colour=#" + std::to_string(100 + tags / 2 % kinds) + "]";
        ++tags;
    }
    const double shaping = shaping_seconds(*font, text);
    markup marked;
    markup_styles styles;
    if (!marked.read(source) || marked.text() != text || !(shaping > 0.0)) return state.SkipWithError("no text");
    std::size_t times = 0;
    const std::clock_t begin = std::clock();
    for (auto unused : state) {
        (void)unused;
        if (!marked.read(source) || (styles_too && !styles.set(marked))) return state.SkipWithError("no text");
        ++times;
    }
    const double once = seconds(begin) / static_cast<double>(times);
    state.counters["of_shaping"] = 100.0 * once / (shaping * static_cast<double>(text.size()));
    if (tags != 0) state.counters["ns_a_tag"] = 1e9 * once / tags;
}

BENCHMARK_CAPTURE(read, no_tags, 0, 1, false);
BENCHMARK_CAPTURE(read, tag_a_ten_letters, 10, 1, false);
BENCHMARK_CAPTURE(read, tag_a_ten_letters_many_colours, 10, 500, false);
BENCHMARK_CAPTURE(read, tag_a_ten_letters_with_styles, 10, 1, true);

}  // namespace

BENCHMARK_MAIN();
