// SPDX-License-Identifier: MIT
//
// The texts of d3dx_create_text, made by typemesh::d3dx_text: natively with HarfBuzz, as a Windows program with
// DirectWrite.
//
//     typemesh_text text OUT RUNS FONT_FILE   "Hello world!" at the thesis' four deviations, RUNS times each
//     typemesh_text letters OUT FONT_FILE     every letter of Latin-1 alone at more deviations, untimed
//
// Appends to OUT. Every run does all the work anew: layout, outlines, meshing, vertices and 16-bit indices into arrays
// of the caller's. Layout and outlines are timed apart as well, and the whole with a glyph cache.

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
        if (error e = plan->write(std::span{vertices}, std::span{indices})) fail(e);
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
    text_work<d3dx_text<font_type>> work{maker};
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
        glyph_run run;
        const feature plain[] = {{"kern", 0}, {"liga", 0}, {"clig", 0}};
        const auto shape = [&] {
            if (error e = layout(*font, bench::hello, {.features = plain}, {}, run)) fail(e);
        };
        std::vector<glyph_id> different;  // a letter that comes again is drawn and meshed once
        const auto draw = [&] {
            ignore_outline sink;
            for (const glyph_id id : different)
                if (error e = font->outline(id, sink)) fail(e);
        };
        const auto start = std::chrono::steady_clock::now();
        shape();
        for (const placed_glyph& g : run.glyphs)
            if (std::find(different.begin(), different.end(), g.id) == different.end()) different.push_back(g.id);
        draw();
        m.first_time = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();

        glyph_cache cache;
        d3dx_text quick{*font, cached_in{cache, 1}};
        text_work<decltype(quick)> quick_work{quick};
        for (const double deviation : bench::deviations) {
            m.layout = bench::time_of(runs, shape).median;
            m.outlines = bench::time_of(runs, draw).median;
            const auto times = bench::time_of(runs, [&] { work(bench::hello, deviation); });
            m.microseconds = times.median, m.best = times.best;
            m.cached = bench::time_of(runs, [&] { quick_work(bench::hello, deviation); }).median;
            keep(bench::hello, deviation);
        }
    }
    std::fclose(out);
}
