// SPDX-License-Identifier: MIT
//
// The texts of d3dx_create_text, made by typemesh::d3dx_text: natively with HarfBuzz, as a Windows program with DirectWrite.
//
//     typemesh_text OUT RUNS FONT_FILE FAMILY [FONT_FILE FAMILY]...       (FAMILY is not looked at)
//
// Every run does all the work anew: layout, outlines, meshing, vertices and indices of 16 bits into arrays of the caller's.

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
constexpr const char* maker = "typemesh, DirectWrite (Windows program)";
#else
using font_type = harfbuzz_font;
constexpr const char* maker = "typemesh, HarfBuzz (native)";
#endif

[[noreturn]] void fail(const error& e)
{
    char text[200];
    std::fprintf(stderr, "%s\n", describe(e, text));
    std::exit(1);
}

/// A run of one text: plan and write, into arrays that are there already.
struct text_work {
    d3dx_text<font_type>& texts;
    std::vector<d3dx_vertex> vertices;
    std::vector<std::uint16_t> indices;

    void operator()(const std::u16string& text, const d3dx_text_options& options)
    {
        const auto plan = texts.plan(text, options);
        if (!plan) fail(plan.error());
        vertices.resize(plan->size().vertices);
        indices.resize(plan->size().indices());
        if (error e = plan->write(std::span{vertices}, std::span{indices})) fail(e);
    }
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 5 || argc % 2 == 0) return std::fputs("usage: typemesh_text OUT RUNS FONT_FILE FAMILY...\n", stderr), 2;
    std::FILE* out = std::fopen(argv[1], "wb");
    if (out == nullptr) return 1;
    const int runs = std::atoi(argv[2]);

    for (int i = 3; i < argc; i += 2) {
        auto font = font_type::open(argv[i]);
        if (!font) fail(font.error());
        bench::measured_mesh m;
        m.maker = maker;
        m.font = bench::name_of(argv[i]);

        glyph_run run;
        const feature plain[] = {{"kern", 0}, {"liga", 0}, {"clig", 0}};
        const auto shape = [&] {
            if (error e = layout(*font, bench::hello, {.features = plain}, {}, run)) fail(e);
        };
        const auto draw = [&] {
            ignore_outline sink;
            for (const placed_glyph& g : run.glyphs)
                if (error e = font->outline(g.id, sink)) fail(e);
        };
        const auto start = std::chrono::steady_clock::now();
        shape(), draw();
        m.first_time = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
        m.shaping = bench::time_of(runs, shape).median;
        m.outlines = bench::time_of(runs, draw).median;

        d3dx_text<font_type> texts{*font};
        text_work work{texts, {}, {}};
        const auto keep = [&](const std::u16string& text, double deviation) {
            work(text, {.deviation = deviation, .extrusion = 0.3});
            m.text = text, m.deviation = deviation;
            m.vertices.resize(work.vertices.size());
            if (!work.vertices.empty())
                std::memcpy(m.vertices.data(), work.vertices.data(), sizeof m.vertices[0] * m.vertices.size());
            m.indices.assign(work.indices.begin(), work.indices.end());
            if (!bench::write(out, m)) std::exit(1);
        };
        for (const double deviation : bench::deviations) {
            const auto times = bench::time_of(runs, [&] { work(bench::hello, {.deviation = deviation, .extrusion = 0.3}); });
            m.microseconds = times.median, m.best = times.best;
            keep(bench::hello, deviation);
        }
        m.microseconds = m.best = m.shaping = m.outlines = m.first_time = 0.0;
        for (const double deviation : bench::letter_deviations)
            for (const char16_t letter : bench::latin_letters()) keep(std::u16string(1, letter), deviation);
    }
    std::fclose(out);
}
