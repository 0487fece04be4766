// SPDX-License-Identifier: MIT
//
// What each kind of letter costs, beside the same text simply extruded in the same minute: the letters of Latin up to
// U+024F that a font has, in one line, each built anew, from the font to vertices and indices.
//
//     bench_kinds                                every font that is installed
//     bench_kinds --benchmark_filter=Serif
//
// us_per_glyph is the best of several passes, in processor time; of_extruded the same by the time of `extruded`, whose
// passes take turns with these. triangles are those of the whole mesh, per glyph.
//
// Fonts: packages fonts-dejavu-core, fonts-liberation.

#include "../tests/support/font_path.hpp"
#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/plane_path.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/extrude/tapered.hpp>
#include <typemesh/extrude/tubed.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;

struct line_of_letters {
    std::string name;
    harfbuzz_font font;
    std::string text;
};

/// The vectors that all kinds write to, and what one build of a line takes.
struct written_mesh {
    std::vector<bench::full_vertex> vertices;
    std::vector<std::uint32_t> indices;

    template <class Mesher>
    double seconds(Mesher& mesher, const std::string& text)
    {
        const std::clock_t begin = std::clock();
        if (const auto done = mesher.build(text, into(vertices, indices), {.reuse = false}); !done) {
            std::fprintf(stderr, "%s\n", done.error().message());
            std::abort();
        }
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
};

template <class... Policies>
void add_kind(line_of_letters& line, const char* name, const Policies&... policies)
{
    benchmark::RegisterBenchmark((line.name + " / " + name).c_str(),
                                 [&line, policies...](benchmark::State& state) {
                                     text_mesher mesher{line.font, policies...};
                                     text_mesher plain{line.font, extruded<>{}};
                                     written_mesh mesh;
                                     double kind = 1e300, floor = 1e300;
                                     std::size_t triangles = 0;
                                     for ([[maybe_unused]] auto unused : state)
                                         for (int pass = 0; pass < 5; ++pass) {
                                             floor = std::min(floor, mesh.seconds(plain, line.text));
                                             kind = std::min(kind, mesh.seconds(mesher, line.text));
                                             triangles = mesh.indices.size() / 3;
                                         }
                                     const auto plan = plain.plan(line.text);
                                     const double glyphs = static_cast<double>(plan ? plan->glyphs().size() : 1);
                                     state.counters["us_per_glyph"] = 1e6 * kind / glyphs;
                                     state.counters["of_extruded"] = kind / floor;
                                     state.counters["triangles"] = static_cast<double>(triangles) / glyphs;
                                 })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

void add_kinds(line_of_letters& line)
{
    static plane_path ring;
    if (ring.empty()) ring.circle({0.0, 0.0}, 100.0);
    add_kind(line, "extruded", extruded<>{});
    add_kind(line, "bevelled", bevelled{});
    add_kind(line, "bold and bevelled", bevelled{}, embolden{.by = 0.01f});
    add_kind(line, "outlined", outlined<>{});
    add_kind(line, "tapered", tapered{});
    add_kind(line, "carved", carved{});
    add_kind(line, "tubed", tubed{.radius = 0.02f});
    add_kind(line, "refined, 0.05 em", refined<extruded<>>{.how = {.max_edge = 0.05f}});
    add_kind(line, "inflated", inflated{});
    add_kind(line, "on a cylinder of 100 em", bent<on_cylinder, extruded<>>{.how = {.radius = 100.0}});
    add_kind(line, "twisted by 20 degrees an em", bent<twist, extruded<>>{.how = {.degrees_per_em = 20.0}});
    add_kind(line, "on an arc", extruded<>{}, warped{arc{.degrees = 120}});
    add_kind(line, "on a path, letters turned", extruded<>{}, on_path{&ring, {}});
    add_kind(line, "on a path, letters warped", extruded<>{}, on_path{&ring, {.warp = path_warp::always}});
}

void append_utf8(std::string& text, unsigned c)
{
    if (c >= 0x80) text += static_cast<char>(0xC0 | c >> 6);
    text += static_cast<char>(c < 0x80 ? c : 0x80 | (c & 0x3F));
}

}  // namespace

int main(int argc, char** argv)
{
    static std::deque<line_of_letters> lines;
    for (const auto& [name, path] :
         {std::pair{"DejaVu Sans", "truetype/dejavu/DejaVuSans.ttf"},
          std::pair{"Liberation Serif", "truetype/liberation/LiberationSerif-Regular.ttf"}}) {
        auto opened = harfbuzz_font::open(font_path(path).string().c_str());
        if (!opened) {
            std::fprintf(stderr, "%s is not installed: left out\n", path);
            continue;
        }
        std::string letters;
        for (unsigned c = 0x21; c < 0x250; ++c)
            if (c < 0x7F || (c > 0xA0 && c != 0xAD)) append_utf8(letters, c);
        add_kinds(lines.emplace_back(line_of_letters{name, std::move(*opened), letters}));
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
