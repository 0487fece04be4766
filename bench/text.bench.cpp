// SPDX-License-Identifier: MIT
//
// Whole texts: from characters to vertices and indices, extruded, curve normals, texture coordinates, 1/800 em, 32-byte
// vertices, 32-bit indices, one thread. What counts are the ratios, taken in one run:
//
//     cold_of_floor          nothing cached, every letter built anew, by the floor: HarfBuzz shaping and outline extraction
//     cold_reuse_of_floor    nothing cached, a letter that occurs again built once
//     warm_of_hand           all glyphs cached, by shaping and a hand-written loop over meshed letters that adds pen
//                            position and base index
//     cold_us_per_glyph      the first of these without the floor, by the letters that are drawn, in microseconds
//     memcpy_of_hand         a memcpy of the finished mesh, by that loop
//     moved_of_plain         10,000 letters written anew with a motion, by the plain write: letters/still, shifted, turned
//                            (with normals), sheared
//     instances_of_plain     only one map for each letter, by the plain write
//     mallocs_of_font        allocations a text, of any kind, of shaping and outline extraction alone
//     mallocs_of_typemesh    what a text adds to them after warm-up, nothing cached: 0
//
// "bevelled/..." is the same with chamfers of 2 % of the em along front and back.
//
//     text_bench                       fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts)

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <vector>

static std::size_t mallocs = 0;

#if defined( \
    __GLIBC__)  // every allocation of the process is counted, HarfBuzz's and the aligned operator new's among them
extern "C" {
void* __libc_malloc(std::size_t) noexcept;
void* __libc_calloc(std::size_t, std::size_t) noexcept;
void* __libc_realloc(void*, std::size_t) noexcept;
void* __libc_memalign(std::size_t, std::size_t) noexcept;
void* malloc(std::size_t n) noexcept { return ++mallocs, __libc_malloc(n); }
void* calloc(std::size_t n, std::size_t size) noexcept { return ++mallocs, __libc_calloc(n, size); }
void* realloc(void* p, std::size_t n) noexcept { return ++mallocs, __libc_realloc(p, n); }
void* memalign(std::size_t alignment, std::size_t n) noexcept { return ++mallocs, __libc_memalign(alignment, n); }
void* aligned_alloc(std::size_t alignment, std::size_t n) noexcept { return ++mallocs, __libc_memalign(alignment, n); }
int posix_memalign(void** out, std::size_t alignment, std::size_t n) noexcept
{
    ++mallocs;
    void* block = __libc_memalign(alignment, n);
    if (block != nullptr) *out = block;
    return block != nullptr ? 0 : ENOMEM;
}
}
#endif

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
    static plain_layout layout;
    if (!layout(font, text, {}, {}, run)) std::abort();
    for (const placed_glyph& g : run.glyphs)
        if (font.outline(g.id, sink)) std::abort();
}

/// The best of many short rounds, so that what else runs on the machine falls out.
double nanoseconds_each(auto&& work)
{
    using clock = std::chrono::steady_clock;
    const auto nanoseconds = [](auto d) { return std::chrono::duration<double, std::nano>(d).count(); };
    work();
    auto start = clock::now();
    work();
    const int times = 1 + static_cast<int>(200'000.0 / (1.0 + nanoseconds(clock::now() - start)));
    double best = 1e30;
    for (int round = 0; round < 300; ++round) {
        start = clock::now();
        for (int i = 0; i < times; ++i) work();
        best = std::min(best, nanoseconds(clock::now() - start) / times);
    }
    return best;
}

/// What one would write by hand for letters that are meshed already: for each, its vertices moved to the pen, its
/// indices raised to where they lie.
class by_hand {
public:
    template <class Plan>
    explicit by_hand(const Plan& plan)
    {
        if (!plan.write_meshes(into(vertices_, indices_))) std::abort();
        letters_.resize(plan.glyphs().size());
        plan.write_instances([&](const glyph_instance& i) noexcept {
            const glyph_mesh& m = plan.meshes()[i.mesh];
            const bool last = i.mesh + 1 == plan.meshes().size();
            const auto end_vertex = last ? static_cast<std::uint32_t>(vertices_.size()) : (&m)[1].first_vertex;
            const auto end_index = last ? static_cast<std::uint32_t>(indices_.size()) : (&m)[1].first_index;
            letters_[i.glyph] = {i.translation, m.first_vertex, end_vertex, m.first_index, end_index};
        });
    }

    void write(std::vector<vertex>& vertices, std::vector<std::uint32_t>& indices) const
    {
        vertex* to = vertices.data();
        std::uint32_t* index = indices.data();
        std::uint32_t base = 0;
        for (const letter l : letters_) {
            const vertex* from = vertices_.data() + l.first_vertex;
            const std::uint32_t count = l.end_vertex - l.first_vertex;
            for (std::uint32_t i = 0; i < count; ++i) {
                const vertex& v = from[i];
                to[i] = {{v.position.x + l.pen.x, v.position.y + l.pen.y, v.position.z + l.pen.z}, v.normal, v.uv};
            }
            const std::uint32_t* index_from = indices_.data() + l.first_index;
            const std::uint32_t index_count = l.end_index - l.first_index, raise = base - l.first_vertex;
            for (std::uint32_t i = 0; i < index_count; ++i) index[i] = index_from[i] + raise;
            to += count;
            index += index_count;
            base += count;
        }
        benchmark::ClobberMemory();
    }

private:
    struct letter {
        vec3 pen;
        std::uint32_t first_vertex, end_vertex, first_index, end_index;
    };
    std::vector<vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<letter> letters_;
};

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

/// One text, by a mesher with this extruder.
template <class Extruder>
void run_text(benchmark::State& state, harfbuzz_font& font, const std::string& text, const Extruder& raise)
{
    glyph_run run;
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto times = [&](auto& mesher, bool reuse) {
        return nanoseconds_each([&] {
            if (!mesher.build(text, into(vertices, indices), {.reuse = reuse})) std::abort();
        });
    };
    glyph_cache cache;
    auto cold = text_mesher{font}.with(raise);
    auto warm = text_mesher{font}.with(raise).with(cached_in{cache, 1});
    const double floor = nanoseconds_each([&] { floor_of(font, text, run); });
    plain_layout layout;
    const double shaping = nanoseconds_each([&] {
        if (!layout(font, text, {}, {}, run)) std::abort();
    });
    if (!warm.build(text, into(vertices, indices))) std::abort();
    const by_hand loop{*warm.plan(text)};
    const double hand = nanoseconds_each([&] { loop.write(vertices, indices); });
    const double cold_each = times(cold, false);
    state.counters["cold_of_floor"] = cold_each / floor;
    state.counters["cold_us_per_glyph"] =
        (cold_each - floor) / 1000.0 / static_cast<double>(warm.plan(text)->glyphs().size());
    state.counters["cold_reuse_of_floor"] = times(cold, true) / floor;
    const double cached = times(warm, true);
    state.counters["warm_of_floor"] = cached / floor;
    state.counters["warm_of_hand"] = cached / (shaping + hand);
    auto vertices_to = vertices;
    auto indices_to = indices;
    state.counters["memcpy_of_hand"] =
        nanoseconds_each([&] {
            std::memcpy(static_cast<void*>(vertices_to.data()), vertices.data(), vertices.size() * sizeof(vertex));
            std::memcpy(indices_to.data(), indices.data(), indices.size() * 4);
            benchmark::ClobberMemory();
        }) /
        hand;
    state.counters["shaping_ns"] = shaping;
    state.counters["hand_ns"] = hand;
    state.counters["vertices"] = static_cast<double>(vertices.size());
    state.counters["triangles"] = static_cast<double>(indices.size() / 3);
    for (auto _ : state)
        if (!warm.build(text, into(vertices, indices))) std::abort();
    const auto counted = [](auto&& work) {
        work();
        const std::size_t before = mallocs;
        work();
        return static_cast<double>(mallocs - before);
    };
    const double of_font = counted([&] { floor_of(font, text, run); });
    state.counters["mallocs_of_font"] = of_font;
    state.counters["mallocs_of_typemesh"] = counted([&] {
                                                if (!cold.build(text, into(vertices, indices), {.reuse = false}))
                                                    std::abort();
                                            }) -
                                            of_font;
}

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
    benchmark::RegisterBenchmark((std::string{"text/"} + s.name).c_str(),
                                 [&font, s](benchmark::State& state) { run_text(state, font, s.text, extruded<>{}); });
    benchmark::RegisterBenchmark((std::string{"bevelled/"} + s.name).c_str(),
                                 [&font, s](benchmark::State& state) { run_text(state, font, s.text, bevelled{}); });
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
            if (!plan->write(into(std::span{vertices}, std::span{indices}))) std::abort();
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
        stage_clock clock;
        text_mesher mesher{font, observer_ref{clock}};
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        for (auto _ : state)
            if (!mesher.build(s.text, into(vertices, indices))) std::abort();
        const char* names[] = {"shape", "outline", "discretise", "fill", "triangulate", "extrude"};
        for (int i = 0; i < 6; ++i)
            state.counters[names[i]] = benchmark::Counter(clock.nanoseconds[i], benchmark::Counter::kAvgIterations);
    });
}

/// 10,000 letters that are planned once and written again with a motion.
template <class Motion>
void register_motion(const char* name, Motion motion)
{
    benchmark::RegisterBenchmark((std::string{"letters/"} + name).c_str(), [motion](benchmark::State& state) {
        auto font = harfbuzz_font::open(path_of("truetype/liberation/LiberationSans-Regular.ttf").c_str());
        if (!font) return state.SkipWithError("fonts-liberation is not installed");
        std::string text;
        while (text.size() < 12'000) text += line_of("long-latin.txt", 0).substr(0, 400) + '\n';
        text_mesher mesher{*font};
        auto plan = mesher.plan(text);
        if (!plan || !plan->find_letters(text)) std::abort();
        std::vector<vertex> vertices(plan->size().vertices);
        std::vector<std::uint32_t> indices(plan->size().indices());
        const auto sink = [&] { return into(std::span{vertices}, std::span{indices}); };
        const auto best_of = [&](const auto& write) {
            double best = 1e30;
            for (int round = 0; round < 40; ++round) {
                const auto start = std::chrono::steady_clock::now();
                write();
                best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            }
            return best;
        };
        const auto write = [&] { return plan->write(sink(), motion).error() ? std::abort() : void(); };
        for (auto _ : state) write();
        state.counters["letters"] = static_cast<double>(plan->letters().letters.size());
        const double plain = best_of([&] { return plan->write(sink()).error() ? std::abort() : void(); });
        state.counters["moved_of_plain"] = best_of(write) / plain;
        affine3 last;
        state.counters["instances_of_plain"] =
            best_of([&] {
                plan->write_instances(motion, [&](const glyph_instance&, const affine3& map) noexcept { last = map; });
                benchmark::DoNotOptimize(last);
            }) /
            plain;
    });
}

}  // namespace

int main(int argc, char** argv)
{
#if defined(__GLIBC__)
    const std::size_t before = mallocs;
    const memory source = heap();
    source.deallocate(source.user, source.allocate(source.user, 64, 64), 64, 64);
    if (mallocs == before) return std::fputs("what typemesh takes from its heap is not counted\n", stderr), 1;
#endif
    const sample samples[] = {
        {"hello", "truetype/liberation/LiberationSans-Regular.ttf", "fonts-liberation",
         line_of("phrases-latin.txt", 0)},
        {"lorem", "truetype/liberation/LiberationSans-Regular.ttf", "fonts-liberation", line_of("long-latin.txt", 0)},
        {"hello_cff", "opentype/comic-neue/ComicNeue-Regular.otf", "fonts-comic-neue", line_of("phrases-latin.txt", 0)},
        {"arabic", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "fonts-hosny-amiri",
         line_of("phrases-arabic.txt", 0)},
        {"japanese", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf", "fonts-sawarabi-mincho",
         line_of("phrases-japanese.txt", 0)},
        {"chinese", "truetype/wqy/wqy-microhei.ttc", "fonts-wqy-microhei", line_of("phrases-chinese.txt", 0)},
    };
    for (const sample& s : samples) register_sample(s);
    register_motion("still", [](const letter_place&) noexcept { return affine3{}; });
    register_motion("shifted", letter_wave{});
    register_motion("turned", [](const letter_place& l) noexcept {
        return turned({0.0f, 0.6f, 0.8f}, 0.01 * l.index).about(l.letter.pivot);
    });
    register_motion("sheared", [](const letter_place& l) noexcept {
        return affine3{{1.0f, 0.0f, 0.0f}, {0.3f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {}}.about(l.letter.pivot);
    });
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
