// SPDX-License-Identifier: MIT
//
// The texts of d3dx_create_text, made by typemesh::d3dx_text: natively with HarfBuzz, as a Windows program with
// DirectWrite.
//
//     typemesh_text text OUT RUNS FONT_FILE   "Hello world!" at the thesis' four deviations, RUNS times each
//     typemesh_text letters OUT FONT_FILE     every letter of Latin-1 alone at more deviations, untimed
//
// Appends to OUT. Every run does all the work anew: layout, outlines, meshing, vertices and 16-bit indices into arrays
// of the caller's. The whole is timed; in runs of their own layout, outlines and the rest, meshing; and the whole with
// a glyph cache.

#include "measured_mesh.hpp"

#ifdef _WIN32
#include <typemesh/adapt/directwrite.hpp>
#else
#include <typemesh/adapt/harfbuzz.hpp>
#endif
#include <typemesh/compat/d3dx_text.hpp>

#include <cstdlib>
#include <cstring>
#include <span>

namespace {

using namespace typemesh;

#ifdef _WIN32
using font_type = directwrite_font;
constexpr const char* maker_name = "typemesh, DirectWrite (Windows program)";
#else
using font_type = harfbuzz_font;
constexpr const char* maker_name = "typemesh, HarfBuzz (native)";
#endif

[[noreturn]] void fail(const error& e)
{
    char text[200];
    std::fprintf(stderr, "%s\n", describe(e, text));
    std::exit(1);
}

result<font_type> open(const char* path)
{
#ifdef _WIN32
    wchar_t wide[MAX_PATH] = {};
    MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, MAX_PATH);
    return font_type::open(wide);
#else
    return font_type::open(path);
#endif
}

/// A font that counts how long its two tasks take.
struct timed_font {
    using clock = std::chrono::steady_clock;
    font_type* font;
    double layout = 0.0;
    double outlines = 0.0;

    [[nodiscard]] double units_per_em() noexcept { return font->units_per_em(); }
    [[nodiscard]] fill_rule fill() noexcept { return font->fill(); }
    [[nodiscard]] line_metrics metrics(direction d) noexcept { return font->metrics(d); }
    error shape(text_view text, const text_item& item, const shape_options& o, buffer<shaped_glyph>& glyphs) noexcept
    {
        const auto start = clock::now();
        const error e = font->shape(text, item, o, glyphs);
        layout += std::chrono::duration<double, std::micro>(clock::now() - start).count();
        return e;
    }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        const auto start = clock::now();
        const error e = font->outline(id, sink);
        outlines += std::chrono::duration<double, std::micro>(clock::now() - start).count();
        return e;
    }
};

/// A run of one text: plan and write, into arrays that are there already.
template <class Maker>
struct text_work {
    Maker& maker;
    std::vector<d3dx_vertex> vertices = {};
    std::vector<std::uint16_t> indices = {};

    void operator()(const std::u16string& text, double deviation)
    {
        const auto plan = maker.plan(text, {.deviation = deviation, .extrusion = 0.3});
        if (!plan) fail(plan.error());
        vertices.resize(static_cast<std::size_t>(plan->size().vertices));
        indices.resize(static_cast<std::size_t>(plan->size().indices()));
        if (const auto done = plan->write(std::span{vertices}, std::span{indices}); !done) fail(done.error());
    }
};

}  // namespace

int main(int argc, char** argv)
{
    const bool letters = argc == 4 && std::strcmp(argv[1], "letters") == 0;
    if (!letters && argc != 5)
        return std::fputs("usage: typemesh_text text OUT RUNS FONT_FILE | letters OUT FONT_FILE\n", stderr), 2;
    const char* path = argv[argc - 1];
    std::FILE* out = std::fopen(argv[2], "ab");
    auto font = open(path);
    if (out == nullptr) return 1;
    if (!font) fail(font.error());
    bench::measured_mesh m;
    m.maker = maker_name;
    m.font = bench::name_of(path);

    d3dx_text maker{*font};
    text_work<d3dx_text<>> work{maker};
    const auto keep = [&](const std::u16string& text, double deviation) {
        work(text, deviation);
        m.text = text, m.deviation = deviation;
        m.vertices.resize(work.vertices.size());
        if (!work.vertices.empty())
            std::memcpy(m.vertices.data(), work.vertices.data(), sizeof m.vertices[0] * m.vertices.size());
        m.indices.assign(work.indices.begin(), work.indices.end());
        if (!bench::write(out, m)) std::exit(1);
    };

    if (letters) {
        for (const double deviation : bench::letter_deviations)
            for (const char16_t letter : bench::latin_letters()) keep(std::u16string(1, letter), deviation);
    } else {
        const int runs = std::atoi(argv[3]);
        timed_font timed{&*font};
        d3dx_text apart{timed};
        text_work<decltype(apart)> work_apart{apart};
        work_apart(bench::hello, bench::deviations[0]);
        m.first_time = timed.layout + timed.outlines;

        glyph_cache cache;
        d3dx_text quick{*font, cached_in{cache, 1}};
        text_work<decltype(quick)> quick_work{quick};
        for (const double deviation : bench::deviations) {
            std::vector<double> shaping, drawing, meshing;
            for (int i = 0; i < runs; ++i) {
                timed.layout = timed.outlines = 0.0;
                const auto start = timed_font::clock::now();
                work_apart(bench::hello, deviation);
                const std::chrono::duration<double, std::micro> all = timed_font::clock::now() - start;
                shaping.push_back(timed.layout);
                drawing.push_back(timed.outlines);
                meshing.push_back(all.count() - timed.layout - timed.outlines);
            }
            m.layout = bench::median(shaping), m.outlines = bench::median(drawing), m.meshing = bench::median(meshing);
            const auto times = bench::time_of(runs, [&] { work(bench::hello, deviation); });
            m.microseconds = times.median, m.best = times.best;
            m.cached = bench::time_of(runs, [&] { quick_work(bench::hello, deviation); }).median;
            keep(bench::hello, deviation);
        }
    }
    std::fclose(out);
}
