// SPDX-License-Identifier: MIT
//
// The floor under every text: shaping and outlines alone, by HarfBuzz and FreeType side by side.
//
//     shape      text to glyph run (layout included)
//     bare_shape the same by hb_buffer_add_utf8() and hb_shape() alone
//     outlines   the run's outlines into a sink that only adds up what it is given
//     bare       the same through the font library's own calls, with callbacks that do the same
//     record     the outlines kept as curves, as every mesh begins
//     font       the outlines of all glyphs of a font, streamed (a loop over one glyph trains the branch predictor)
//
// Items are glyphs. A font that is not installed is left out with a word.
#include "../tests/support/font_path.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <string>

using namespace typemesh;

namespace {

std::string text_of(const std::string& name)
{
    if (name == "hello") return "Hello world!";
    std::ifstream in{TYPEMESH_TEST_DATA "/workload/" + name};
    std::string line;
    std::getline(in, line);
    return line;
}

/// A sink whose work cannot be left out, and is next to none.
struct sum {
    double total = 0.0;
    void move(point p) noexcept { total += p.x; }
    void line(point p) noexcept { total += p.x; }
    void quadratic(point c, point p) noexcept { total += c.x + p.x; }
    void cubic(point c, point d, point p) noexcept { total += c.x + d.x + p.x; }
    void close() noexcept {}
};

struct bare_harfbuzz {
    hb_draw_funcs_t* calls = hb_draw_funcs_create();

    bare_harfbuzz()
    {
        hb_draw_funcs_set_move_to_func(
            calls, [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float, void*) { add(d, x); }, nullptr,
            nullptr);
        hb_draw_funcs_set_line_to_func(
            calls, [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float, void*) { add(d, x); }, nullptr,
            nullptr);
        hb_draw_funcs_set_quadratic_to_func(
            calls,
            [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float c, float, float x, float, void*) { add(d, c + x); },
            nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(
            calls,
            [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float c, float, float e, float, float x, float, void*) {
                add(d, c + e + x);
            },
            nullptr, nullptr);
        hb_draw_funcs_make_immutable(calls);
    }
    bare_harfbuzz(const bare_harfbuzz&) = delete;
    bare_harfbuzz& operator=(const bare_harfbuzz&) = delete;
    ~bare_harfbuzz() { hb_draw_funcs_destroy(calls); }

    static void add(void* to, float x) { *static_cast<double*>(to) += double{x}; }
    void draw(hb_font_t* font, glyph_id id, double& total) const
    {
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font, id, calls, &total);
#else
        hb_font_get_glyph_shape(font, id, calls, &total);
#endif
    }
};

struct bare_freetype {
    static double& to(void* data) { return *static_cast<double*>(data); }
    static double x(const FT_Vector* v) { return static_cast<double>(v->x); }

    static void draw(FT_Face face, glyph_id id, double& total)
    {
        static const FT_Outline_Funcs calls{
            [](const FT_Vector* p, void* d) { return to(d) += x(p), 0; },
            [](const FT_Vector* p, void* d) { return to(d) += x(p), 0; },
            [](const FT_Vector* c, const FT_Vector* p, void* d) { return to(d) += x(c) + x(p), 0; },
            [](const FT_Vector* c, const FT_Vector* e, const FT_Vector* p, void* d) {
                return to(d) += x(c) + x(e) + x(p), 0;
            },
            0,
            0};
        if (FT_Load_Glyph(face, id, FT_LOAD_NO_SCALE) == 0) FT_Outline_Decompose(&face->glyph->outline, &calls, &total);
    }
};

template <class Font>
glyph_run shape_or_skip(benchmark::State& state, Font& font, const std::string& text)
{
    glyph_run run;
    if (const auto done = layout(font, text, {}, {}, run); !done) state.SkipWithError(done.error().message());
    return run;
}

template <class Font>
void shape(benchmark::State& state, const std::string& path, const std::string& text)
{
    auto font = Font::open(path.c_str());
    if (!font) return state.SkipWithError(font.error().message());
    glyph_run run = shape_or_skip(state, *font, text);
    plain_layout layout;
    for (auto _ : state) {
        if (!layout(*font, text, {}, {}, run)) break;
        benchmark::DoNotOptimize(run.glyphs.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(run.glyphs.size()) *
                            static_cast<std::int64_t>(state.iterations()));
}

void bare_shape(benchmark::State& state, const std::string& path, const std::string& text)
{
    auto font = harfbuzz_font::open(path.c_str());
    if (!font) return state.SkipWithError(font.error().message());
    hb_buffer_t* units = hb_buffer_create();
    unsigned count = 0;
    for (auto _ : state) {
        hb_buffer_clear_contents(units);
        hb_buffer_add_utf8(units, text.data(), static_cast<int>(text.size()), 0, -1);
        hb_buffer_guess_segment_properties(units);
        hb_shape(font->handle(), units, nullptr, 0);
        benchmark::DoNotOptimize(hb_buffer_get_glyph_positions(units, &count));
    }
    hb_buffer_destroy(units);
    state.SetItemsProcessed(static_cast<std::int64_t>(count) * static_cast<std::int64_t>(state.iterations()));
}

/// Calls draw(font, glyph id) for each glyph of a text, or for each of the font where the text is empty.
template <class Font, class Draw>
void each_glyph(benchmark::State& state, const std::string& path, const std::string& text, Draw draw)
{
    auto font = Font::open(path.c_str());
    if (!font) return state.SkipWithError(font.error().message());
    buffer<glyph_id> ids;
    if (text.empty()) {
        for (glyph_id id = 0; id < font->glyph_count(); ++id)
            if (!ids.push_back(id)) return state.SkipWithError("no memory");
    } else {
        // Shaped by HarfBuzz for both, so that both draw the same glyphs.
        auto shaper = harfbuzz_font::open(path.c_str());
        if (!shaper) return state.SkipWithError(shaper.error().message());
        const glyph_run run = shape_or_skip(state, *shaper, text);
        for (const placed_glyph& g : run.glyphs)
            if (!ids.push_back(g.id)) return state.SkipWithError("no memory");
    }
    for (auto _ : state)
        for (const glyph_id id : ids) draw(*font, id);
    state.SetItemsProcessed(static_cast<std::int64_t>(ids.size()) * static_cast<std::int64_t>(state.iterations()));
}

template <class Font>
void outlines(benchmark::State& state, const std::string& path, const std::string& text)
{
    sum sink;
    each_glyph<Font>(state, path, text, [&](Font& font, glyph_id id) {
        if (font.outline(id, sink)) sink.total += 1.0;
    });
    benchmark::DoNotOptimize(sink.total);
}

void bare(benchmark::State& state, const std::string& path, const std::string& text, harfbuzz_font*)
{
    const bare_harfbuzz calls;
    double total = 0.0;
    each_glyph<harfbuzz_font>(state, path, text,
                              [&](harfbuzz_font& font, glyph_id id) { calls.draw(font.handle(), id, total); });
    benchmark::DoNotOptimize(total);
}

void bare(benchmark::State& state, const std::string& path, const std::string& text, freetype_font*)
{
    double total = 0.0;
    each_glyph<freetype_font>(state, path, text,
                              [&](freetype_font& font, glyph_id id) { bare_freetype::draw(font.handle(), id, total); });
    benchmark::DoNotOptimize(total);
}

template <class Font>
void record_all(benchmark::State& state, const std::string& path, const std::string& text)
{
    outline kept;
    each_glyph<Font>(state, path, text, [&](Font& font, glyph_id id) {
        if (record(font, id, kept).has_value()) benchmark::DoNotOptimize(kept.curves.data());
    });
}

template <class Font>
void add(const std::string& library, const std::string& label, const std::string& path, const std::string& text)
{
    const auto name = [&](const char* what) { return std::string{what} + "/" + library + "/" + label; };
    benchmark::RegisterBenchmark(name("outlines").c_str(), [=](benchmark::State& s) { outlines<Font>(s, path, text); });
    benchmark::RegisterBenchmark(name("bare").c_str(),
                                 [=](benchmark::State& s) { bare(s, path, text, static_cast<Font*>(nullptr)); });
    benchmark::RegisterBenchmark(name("record").c_str(), [=](benchmark::State& s) { record_all<Font>(s, path, text); });
}

}  // namespace

int main(int argc, char** argv)
{
    struct entry {
        const char* label;
        const char* font;
        const char* text;  // a file of workload/, "hello", or none for all glyphs of the font
        bool plain;
    };
    const entry entries[] = {
        {"hello_DejaVu", "truetype/dejavu/DejaVuSans.ttf", "hello", true},
        {"hello_ComicNeue", "opentype/comic-neue/ComicNeue-Regular.otf", "hello", true},
        {"lorem_DejaVu", "truetype/dejavu/DejaVuSans.ttf", "long-latin.txt", true},
        {"japanese_SawarabiMincho", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf", "phrases-japanese.txt",
         true},
        {"arabic_Amiri", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "phrases-arabic.txt", false},
        {"font_DejaVu", "truetype/dejavu/DejaVuSans.ttf", nullptr, true},
        {"font_Inter", "truetype/inter-vf/Inter-roman.var.ttf", nullptr, true},
        {"font_ComicNeue", "opentype/comic-neue/ComicNeue-Regular.otf", nullptr, true},
    };
    for (const entry& e : entries) {
        const std::string path = font_path(e.font).string(), text = e.text != nullptr ? text_of(e.text) : std::string{},
                          label = e.label;
        if (!std::ifstream{path}) {
            std::fprintf(stderr, "left out: %s is not installed\n", path.c_str());
            continue;
        }
        if (e.text != nullptr) {
            benchmark::RegisterBenchmark(("shape/harfbuzz/" + label).c_str(),
                                         [=](benchmark::State& s) { shape<harfbuzz_font>(s, path, text); });
            benchmark::RegisterBenchmark(("bare_shape/harfbuzz/" + label).c_str(),
                                         [=](benchmark::State& s) { bare_shape(s, path, text); });
            if (e.plain)
                benchmark::RegisterBenchmark(("shape/freetype/" + label).c_str(),
                                             [=](benchmark::State& s) { shape<freetype_font>(s, path, text); });
        }
        add<harfbuzz_font>("harfbuzz", label, path, text);
        add<freetype_font>("freetype", label, path, text);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
