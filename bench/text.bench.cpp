// SPDX-License-Identifier: MIT
//
// Whole texts: from characters to vertices and indices, extruded, curve normals, texture coordinates, 1/800 em, 32-byte vertices,
// 32-bit indices, nothing cached. Beside it, in the same run, the floors: HarfBuzz shaping and outline extraction of the same
// text, and a memcpy of the finished mesh. Ratios are what counts: "of_floor" is the time by that of the floor.
//
//     text_bench                       fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace typemesh;
using vertex = bench::full_vertex;

struct sample {
    const char* name;
    const char* font;
    const char* package;
    std::string text;
};

std::string line_of(const char* file, int line)
{
    std::ifstream in{std::string{TYPEMESH_TEST_DATA "/workload/"} + file};
    std::string text;
    for (int i = 0; i <= line; ++i) std::getline(in, text);
    return text;
}

std::string path_of(const char* font)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    return std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + font;
}

/// Shaping and outline extraction alone.
void floor_of(harfbuzz_font& font, const std::string& text, glyph_run& run)
{
    ignore_outline sink;
    if (layout(font, text, {}, {}, run)) std::abort();
    for (const placed_glyph& g : run.glyphs)
        if (font.outline(g.id, sink)) std::abort();
}

double nanoseconds_each(auto&& work)
{
    using clock = std::chrono::steady_clock;
    double best = 1e30;
    for (int round = 0; round < 15; ++round) {
        const auto start = clock::now();
        constexpr int times = 200;
        for (int i = 0; i < times; ++i) work();
        best = std::min(best, std::chrono::duration<double, std::nano>(clock::now() - start).count() / times);
    }
    return best;
}

struct stage_clock {
    using clock = std::chrono::steady_clock;
    double nanoseconds[7] = {};
    stage now = stage::idle;
    clock::time_point since;

    void operator()(stage next) noexcept
    {
        const auto t = clock::now();
        nanoseconds[static_cast<int>(now)] += std::chrono::duration<double, std::nano>(t - since).count();
        now = next;
        since = t;
    }
};

void register_sample(const sample& s)
{
    static std::map<std::string, harfbuzz_font> fonts;
    auto opened = harfbuzz_font::open(path_of(s.font).c_str());
    if (!opened) {
        std::fprintf(stderr, "left out: %s (%s; Debian package %s)\n", s.name, opened.error().message(), s.package);
        return;
    }
    harfbuzz_font& font = fonts.try_emplace(s.name, std::move(*opened)).first->second;

    benchmark::RegisterBenchmark((std::string{"floor/"} + s.name).c_str(), [&font, s](benchmark::State& state) {
        glyph_run run;
        for (auto _ : state) floor_of(font, s.text, run);
    });
    for (const bool reuse : {false, true})
    benchmark::RegisterBenchmark((std::string{reuse ? "reuse/" : "extruded/"} + s.name).c_str(), [&font, s, reuse](benchmark::State& state) {
        glyph_run run;
        const double floor = nanoseconds_each([&] { floor_of(font, s.text, run); });
        text_mesher mesher{font};
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        const auto work = [&] {
            const auto made = mesher.build(s.text, into(vertices, indices), {.reuse = reuse});
            if (!made) std::abort();
        };
        const double all = nanoseconds_each(work);
        for (auto _ : state) work();
        state.counters["of_floor"] = all / floor;
        state.counters["vertices"] = static_cast<double>(vertices.size());
        state.counters["triangles"] = static_cast<double>(indices.size() / 3);
    });
    benchmark::RegisterBenchmark((std::string{"plan_only/"} + s.name).c_str(), [&font, s](benchmark::State& state) {
        text_mesher mesher{font};
        for (auto _ : state) benchmark::DoNotOptimize(mesher.plan(s.text)->size());
    });
    benchmark::RegisterBenchmark((std::string{"write_only/"} + s.name).c_str(), [&font, s](benchmark::State& state) {
        text_mesher mesher{font};
        auto plan = mesher.plan(s.text);
        std::vector<vertex> vertices(plan->size().vertices);
        std::vector<std::uint32_t> indices(plan->size().indices());
        for (auto _ : state) {
            if (plan->write(into(std::span{vertices}, std::span{indices}))) std::abort();
            benchmark::ClobberMemory();
        }
    });
    benchmark::RegisterBenchmark((std::string{"memcpy/"} + s.name).c_str(), [&font, s](benchmark::State& state) {
        text_mesher mesher{font};
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        if (!mesher.build(s.text, into(vertices, indices))) std::abort();
        auto vertices_to = vertices;
        auto indices_to = indices;
        for (auto _ : state) {
            std::memcpy(static_cast<void*>(vertices_to.data()), vertices.data(), vertices.size() * sizeof(vertex));
            std::memcpy(indices_to.data(), indices.data(), indices.size() * 4);
            benchmark::ClobberMemory();
        }
    });
    benchmark::RegisterBenchmark((std::string{"stages/"} + s.name).c_str(), [&font, s](benchmark::State& state) {
        auto mesher = text_mesher{font}.with(stage_clock{});
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        for (auto _ : state)
            if (!mesher.build(s.text, into(vertices, indices))) std::abort();
        const char* names[] = {"shape", "outline", "discretise", "fill", "triangulate", "extrude"};
        for (int i = 0; i < 6; ++i)
            state.counters[names[i]] = benchmark::Counter(mesher.observer().nanoseconds[i], benchmark::Counter::kAvgIterations);
    });
}

}  // namespace

int main(int argc, char** argv)
{
    const sample samples[] = {
        {"hello", "truetype/liberation/LiberationSans-Regular.ttf", "fonts-liberation", line_of("phrases-latin.txt", 0)},
        {"lorem", "truetype/liberation/LiberationSans-Regular.ttf", "fonts-liberation", line_of("long-latin.txt", 0)},
        {"hello_cff", "opentype/comic-neue/ComicNeue-Regular.otf", "fonts-comic-neue", line_of("phrases-latin.txt", 0)},
        {"arabic", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "fonts-hosny-amiri", line_of("phrases-arabic.txt", 0)},
        {"japanese", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf", "fonts-sawarabi-mincho", line_of("phrases-japanese.txt", 0)},
        {"chinese", "truetype/wqy/wqy-microhei.ttc", "fonts-wqy-microhei", line_of("phrases-chinese.txt", 0)},
    };
    for (const sample& s : samples) register_sample(s);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
