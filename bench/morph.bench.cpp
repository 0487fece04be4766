// SPDX-License-Identifier: MIT
//
// A text of 40 letters whose weight moves, written for each frame at another place of the axis. The aim is 0.2 ms.
//
//     vertices       of the mesh
//     ns_a_vertex    of a frame
//
//     bench_morph                    fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/vertex/array_sink.hpp>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace typemesh;

constexpr const char* font_file = "truetype/inter-vf/Inter-roman.var.ttf";
constexpr const char* letters = "Breathing letters that keep their triangle too";  // 40 without spaces

struct placed {
    vec3 position;
};
struct shaded {
    vec3 position, normal;
};

/// A frame: all vertices and all triangles.
template <class Vertex, class Writer>
void frame(benchmark::State& state, double tolerance, const Writer& vertex_of)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    auto font =
        harfbuzz_font::open((std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + font_file).c_str());
    if (!font) return state.SkipWithError(font.error().message());
    auto weight = harfbuzz_axis::open(*font, "wght");
    if (!weight) return state.SkipWithError(weight.error().message());
    axis_morph morph{*weight};
    auto plan = morph.plan(letters, {.tolerance = tolerance});
    if (!plan || plan->section_count() == 0) return state.SkipWithError("no plan");
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t s = 0; s < plan->section_count(); ++s)
        if (plan->size(s).vertices > vertices.size()) {
            vertices.resize(plan->size(s).vertices);
            indices.resize(plan->size(s).indices());
        }
    const double low = weight->coordinate(weight->low()), high = weight->coordinate(weight->high());
    std::size_t times = 0;
    const std::clock_t begin = std::clock();
    for (auto unused : state) {
        (void)unused;
        const double share = static_cast<double>(times++ % 97) / 96.0;
        const double at = low + share * (high - low);
        const std::size_t s = plan->section_at(at);
        const std::span all{vertices.data(), plan->size(s).vertices};
        const std::span corners{indices.data(), plan->size(s).indices()};
        const auto done = plan->write_at(at, into(all, corners, vertex_of));
        if (!done) return state.SkipWithError(done.error().message());
        benchmark::DoNotOptimize(vertices.data());
    }
    const double once = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / static_cast<double>(times);
    state.counters["vertices"] = static_cast<double>(plan->size(0).vertices);
    state.counters["ns_a_vertex"] = 1e9 * once / static_cast<double>(plan->size(0).vertices);
}

constexpr auto place = [](const surface_point<attribute::position>& s) noexcept { return placed{s.position}; };
constexpr auto shade = [](const surface_point<attribute::position | attribute::normal>& s) noexcept {
    return shaded{s.position, s.normal};
};

void positions(benchmark::State& state) { frame<placed>(state, quality::high, place); }
void positions_and_normals(benchmark::State& state) { frame<shaded>(state, quality::high, shade); }
void normal_quality(benchmark::State& state) { frame<shaded>(state, quality::normal, shade); }

BENCHMARK(positions);
BENCHMARK(positions_and_normals);
BENCHMARK(normal_quality);

}  // namespace

BENCHMARK_MAIN();
