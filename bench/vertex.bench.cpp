// SPDX-License-Identifier: MIT
//
// Vertex layouts and packed formats: one planned text of 1,000 letters, written again and again. "of_32" is the time by
// that of the 32-byte vertex (position, normal, texture coordinates) in the same run, indices included; "ns" is that of
// one vertex. First what attributes cost, and that those not taken cost nothing; then each packed format in place of
// its floats; then one stream an attribute. Last 100,000 letters into vectors that are made anew each time: "of_fresh" is
// by spans over memory that is allocated anew, both by the processor's clock, medians of turns. Liberation Sans, extruded, curve normals, 1/800 em, 32-bit indices.
//
//     bench_vertex                     fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <typemesh/vertex/computed_stream.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/octahedral.hpp>
#include <typemesh/vertex/octahedral_tangent.hpp>
#include <typemesh/vertex/position_box.hpp>
#include <typemesh/vertex/ten_bit.hpp>
#include <typemesh/vertex/uninitialised_allocator.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace typemesh;

/// Whatever one attribute or several become, by a function.
template <attribute Wants, class Make>
struct writer {
    static constexpr attribute wants = Wants;
    Make make;
    auto operator()(const surface_point<wants>& s) const noexcept { return make(s); }
};
template <attribute Wants, class Make>
writer<Wants, Make> makes(Make make)
{
    return {make};
}

constexpr attribute places = attribute::position, lit = places | attribute::normal, full = lit | attribute::uv,
                    framed = full | attribute::tangent;

struct text {
    harfbuzz_font font;
    text_mesher<> mesher{font};
    std::string letters{};
    std::vector<std::byte> vertices = std::vector<std::byte>(80u << 20);
    std::vector<std::uint32_t> indices = std::vector<std::uint32_t>(8u << 20);
};

text& sample()
{
    static text* t = [] {
        const char* folder = std::getenv("TYPEMESH_FONT_DIR");
        const std::string path = std::string{folder != nullptr ? folder : "/usr/share/fonts"} +
                                 "/truetype/liberation/LiberationSans-Regular.ttf";
        auto font = harfbuzz_font::open(path.c_str());
        if (!font) {
            std::fprintf(stderr, "%s: %s (Debian package fonts-liberation)\n", path.c_str(), font.error().message());
            std::exit(1);
        }
        auto* made = new text{std::move(*font)};
        for (int i = 0; i < 1000; ++i) made->letters += static_cast<char>('!' + i % 94);
        return made;
    }();
    return *t;
}

template <class F>
double best_of(F&& f)
{
    double least = 1e30;
    for (int i = 0; i < 25; ++i) {
        const auto start = std::chrono::steady_clock::now();
        f();
        least =
            std::min(least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    }
    return least;
}

template <class Writer>
auto array_of(text& t, Writer w)
{
    using vertex = decltype(w(surface_point<Writer::wants>{}));
    return into(std::span{reinterpret_cast<vertex*>(t.vertices.data()), t.vertices.size() / sizeof(vertex)},
                std::span{t.indices}, w);
}

/// sink_of(text) makes the sink anew for each writing.
template <class SinkOf>
void layout_of(const char* name, SinkOf sink_of)
{
    benchmark::RegisterBenchmark(name, [sink_of](benchmark::State& state) {
        text& t = sample();
        auto plan = t.mesher.plan(t.letters);
        if (!plan) std::abort();
        const auto work = [&] {
            if (!plan->write(sink_of(t))) std::abort();
            benchmark::ClobberMemory();
        };
        const auto usual = [&] {
            if (!plan->write(array_of(t, vertex_traits<bench::full_vertex>{}))) std::abort();
            benchmark::ClobberMemory();
        };
        usual();
        const double floor = best_of(usual), own = best_of(work);
        for (auto _ : state) work();
        state.counters["of_32"] = own / floor;
        state.counters["ns"] = own / static_cast<double>(plan->size().vertices);
    });
}

template <class Writer>
void vertex_of(const char* name, Writer w)
{
    layout_of(name, [w](text& t) { return array_of(t, w); });
}

/// Seconds of the processor's time.
template <class F>
double busy(F&& f)
{
    const std::clock_t start = std::clock();
    f();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <template <class> class Allocator>
void fresh(benchmark::State& state)
{
    using vertex = bench::full_vertex;
    text& t = sample();
    std::string letters;
    for (int i = 0; i < 100; ++i) letters += t.letters + '\n';
    auto plan = t.mesher.plan(letters);
    if (!plan) std::abort();
    const auto count = static_cast<std::size_t>(plan->size().vertices),
               indices = static_cast<std::size_t>(plan->size().indices());
    std::vector<double> floor, own;
    for (auto _ : state) {
        auto* v = static_cast<vertex*>(std::malloc(count * sizeof(vertex)));
        auto* i = static_cast<std::uint32_t*>(std::malloc(indices * sizeof(std::uint32_t)));
        if (v == nullptr || i == nullptr) std::abort();
        floor.push_back(busy([&] {
            if (!plan->write(into(std::span{v, count}, std::span{i, indices}))) std::abort();
            benchmark::ClobberMemory();
        }));
        std::free(v);
        std::free(i);
        std::vector<vertex, Allocator<vertex>> vertices;
        std::vector<std::uint32_t, Allocator<std::uint32_t>> triangles;
        own.push_back(busy([&] {
            if (!plan->write(into(vertices, triangles))) std::abort();
            benchmark::ClobberMemory();
        }));
    }
    std::sort(floor.begin(), floor.end());
    std::sort(own.begin(), own.end());
    state.counters["of_fresh"] = own[own.size() / 2] / floor[floor.size() / 2];
}
BENCHMARK(fresh<std::allocator>)->Name("fresh/vectors")->Iterations(5)->Unit(benchmark::kMillisecond);
BENCHMARK(fresh<uninitialised_allocator>)
    ->Name("fresh/uninitialised_vectors")
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

const int registered = [] {
    struct three {
        vec3 a;
    };
    struct lit_vertex {
        vec3 a, n;
    };
    struct framed_vertex {
        vec3 a, n;
        vec2 uv;
        vec4 t;
    };
    struct named_vertex {
        vec3 a, n;
        vec2 uv;
        std::uint32_t glyph, cluster, part;
    };
    vertex_of("attributes/position", makes<places>([](const auto& s) noexcept { return three{s.position}; }));
    vertex_of("attributes/position_normal",
              makes<lit>([](const auto& s) noexcept { return lit_vertex{s.position, s.normal}; }));
    vertex_of("attributes/position_normal_uv",
              makes<full>([](const auto& s) noexcept { return bench::full_vertex{s.position, s.normal, s.uv}; }));
    // The same 32 bytes, from a point that has everything: what the compiler drops when the vertex does not take it.
    vertex_of("attributes/all_wanted_three_taken", makes < framed | attribute::glyph | attribute::cluster |
                                                       attribute::part > ([](const auto& s) noexcept {
                                                           return bench::full_vertex{s.position, s.normal, s.uv};
                                                       }));
    vertex_of("attributes/and_tangent", makes<framed>([](const auto& s) noexcept {
                  return framed_vertex{s.position, s.normal, s.uv, s.tangent};
              }));
    vertex_of("attributes/and_glyph_cluster_part",
              makes < full | attribute::glyph | attribute::cluster |
                  attribute::part > ([](const auto& s) noexcept {
                      return named_vertex{s.position, s.normal,  s.uv,
                                          s.glyph,    s.cluster, static_cast<std::uint32_t>(s.part)};
                  }));

    struct half_uv {
        vec3 a, n;
        half u, v;
    };
    struct byte_normal {
        vec3 a;
        snorm8 n[4];
        vec2 uv;
    };
    struct short_normal {
        vec3 a;
        snorm16 n[4];
        vec2 uv;
    };
    struct ten_normal {
        vec3 a;
        snorm10 n;
        vec2 uv;
    };
    struct oct16_normal {
        vec3 a;
        octahedral16 n;
        vec2 uv;
    };
    struct oct32_normal {
        vec3 a;
        octahedral32 n;
        vec2 uv;
    };
    struct boxed {
        box_position a;
        vec3 n;
        vec2 uv;
    };
    struct byte_tangent {
        vec3 a, n;
        vec2 uv;
        snorm8 t[4];
    };
    struct oct_tangent {
        vec3 a, n;
        vec2 uv;
        octahedral_tangent32 t;
    };
    struct smallest {
        box_position a;
        octahedral16 n;
        half u, v;
    };
    vertex_of("packed/half_uv",
              makes<full>([](const auto& s) noexcept { return half_uv{s.position, s.normal, s.uv.x, s.uv.y}; }));
    vertex_of("packed/snorm8_normal", makes<full>([](const auto& s) noexcept {
                  return byte_normal{s.position, {s.normal.x, s.normal.y, s.normal.z, 0.0f}, s.uv};
              }));
    vertex_of("packed/snorm16_normal", makes<full>([](const auto& s) noexcept {
                  return short_normal{s.position, {s.normal.x, s.normal.y, s.normal.z, 0.0f}, s.uv};
              }));
    vertex_of("packed/snorm10_normal", makes<full>([](const auto& s) noexcept {
                  return ten_normal{s.position, {s.normal.x, s.normal.y, s.normal.z}, s.uv};
              }));
    vertex_of("packed/octahedral16_normal", makes<full>([](const auto& s) noexcept {
                  return oct16_normal{s.position, {s.normal.x, s.normal.y, s.normal.z}, s.uv};
              }));
    vertex_of("packed/octahedral32_normal", makes<full>([](const auto& s) noexcept {
                  return oct32_normal{s.position, {s.normal.x, s.normal.y, s.normal.z}, s.uv};
              }));
    const auto box = position_box::around({0, -1, -1}, {800, 1, 0});
    vertex_of("packed/unorm16_position",
              makes<full>([box](const auto& s) noexcept { return boxed{box(s.position), s.normal, s.uv}; }));
    vertex_of("packed/snorm8_tangent", makes<framed>([](const auto& s) noexcept {
                  return byte_tangent{s.position, s.normal, s.uv, {s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w}};
              }));
    vertex_of("packed/octahedral32_tangent", makes<framed>([](const auto& s) noexcept {
                  return oct_tangent{s.position, s.normal, s.uv, {s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w}};
              }));
    vertex_of("packed/twelve_bytes", makes<full>([box](const auto& s) noexcept {
                  return smallest{box(s.position), {s.normal.x, s.normal.y, s.normal.z}, s.uv.x, s.uv.y};
              }));

    layout_of("streams/three_arrays", [](text& t) {
        const std::span<std::byte> bytes{t.vertices};
        const std::size_t third = bytes.size() / 3 / 64 * 64;
        return stream_sink{std::span{t.indices}, stream<attribute::position, vec3>::in(bytes.first(third), 0),
                           stream<attribute::normal, vec3>::in(bytes.subspan(third, third), 0),
                           stream<attribute::uv, vec2>::in(bytes.subspan(2 * third), 0)};
    });
    layout_of("streams/interleaved", [](text& t) {
        const std::span<std::byte> bytes{t.vertices};
        return stream_sink{std::span{t.indices}, stream<attribute::position, vec3>::in(bytes, 0, 32),
                           stream<attribute::normal, vec3>::in(bytes, 12, 32),
                           stream<attribute::uv, vec2>::in(bytes, 24, 32)};
    });
    return 0;
}();

}  // namespace

BENCHMARK_MAIN();
