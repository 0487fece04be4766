// SPDX-License-Identifier: MIT
//
// Extruding alone: proven regions of all glyphs of a font, streamed, to 32-byte vertices and 32-bit indices; each style of normals,
// beside a memcpy of the same output in the same run ("of_memcpy"). Liberation Sans at 1/800 em.
//
//     bench_extrude                    fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;
using vertex = bench::full_vertex;

/// One glyph as the extruder gets it. The region refers to the contours beside it, and they to the outline.
struct glyph {
    outline shape;
    cap_builder caps;
    region filled;
};

std::deque<glyph>& glyphs()
{
    static std::deque<glyph> all = [] {
        std::deque<glyph> some;
        const char* folder = std::getenv("TYPEMESH_FONT_DIR");
        const std::string path = std::string{folder != nullptr ? folder : "/usr/share/fonts"} +
                                 "/truetype/liberation/LiberationSans-Regular.ttf";
        auto font = harfbuzz_font::open(path.c_str());
        if (!font) {
            std::fprintf(stderr, "%s: %s (Debian package fonts-liberation)\n", path.c_str(), font.error().message());
            std::exit(1);
        }
        for (glyph_id id = 0; id < font->glyph_count(); ++id) {
            glyph& g = some.emplace_back();
            const double upem = font->units_per_em();
            bool good = record(*font, id, g.shape).has_value() && !g.shape.curves.empty();
            if (good) {
                const auto grid_of = grid::fitting(upem, g.shape.bounds);
                good = grid_of && g.caps.flatten(g.shape, certified{}, quality::high * upem, *grid_of).has_value();
            }
            if (good) {
                const auto filled = g.caps.fill({g.shape.rule}, monotone{});
                if ((good = bool(filled) && !filled->points().empty())) g.filled = *filled;
            }
            if (!good) some.pop_back();
        }
        return some;
    }();
    return all;
}

template <extruder Extruder>
void extrude_font(benchmark::State& state)
{
    const Extruder how;
    const placement at{.unit_per_cell = 1.0 / (512 * 2048), .unit_per_depth = 1.0, .em_per_cell = 1.0 / (512 * 2048)};
    std::vector<vertex> vertices(1u << 20);
    std::vector<std::uint32_t> indices(1u << 22);
    plan_data_of<Extruder> sides;
    no_caps nothing;
    std::size_t vertex_count = 0, triangle_count = 0;
    std::vector<std::pair<std::size_t, std::size_t>> places;  // where each glyph's vertices and indices begin
    for (const glyph& g : glyphs()) {
        places.emplace_back(vertex_count, 3 * triangle_count);
        sides.clear();
        const auto plan = plan_solid(how, g.filled, sides, nothing);
        if (!plan) std::abort();
        const mesh_size size = plan->sizes.total();
        vertex_count += size.vertices, triangle_count += size.triangles;
    }
    const auto work = [&] {
        auto place = places.begin();
        for (const glyph& g : glyphs()) {
            auto sink = into(std::span{vertices}.subspan(place->first), std::span{indices}.subspan(place->second));
            if (!extrude(g.filled, g.caps.triangles().view(), how, at, sides, sink)) std::abort();
            ++place;
        }
    };
    const auto best = [](auto&& f) {
        double least = 1e30;
        for (int i = 0; i < 9; ++i) {
            const auto start = std::chrono::steady_clock::now();
            f();
            least = std::min(
                least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
        }
        return least;
    };
    const double extruding = best(work);
    std::vector<vertex> vertices_to(vertex_count);
    std::vector<std::uint32_t> indices_to(3 * triangle_count);
    const double copying = best([&] {
        std::memcpy(static_cast<void*>(vertices_to.data()), vertices.data(), vertex_count * sizeof(vertex));
        std::memcpy(indices_to.data(), indices.data(), 12 * triangle_count);
        benchmark::ClobberMemory();
    });
    for (auto _ : state) work();
    std::size_t points = 0;
    for (const glyph& g : glyphs()) points += g.filled.points().size();
    state.counters["ns_a_point"] = extruding / static_cast<double>(points);
    state.counters["of_memcpy"] = extruding / copying;
    state.counters["vertices"] = static_cast<double>(vertex_count);
}

BENCHMARK(extrude_font<flat>);
BENCHMARK(extrude_font<extruded<shared_normals>>);
BENCHMARK(extrude_font<extruded<averaged_normals>>);
BENCHMARK(extrude_font<extruded<creased_normals>>);
BENCHMARK(extrude_font<extruded<curve_normals>>);

}  // namespace

BENCHMARK_MAIN();
