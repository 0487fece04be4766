// SPDX-License-Identifier: MIT
//
// Both triangulators, a stream of different glyphs (a loop over one glyph trains the branch predictor and flatters by a factor of
// 2 to 4), beside the floor in the same run: std::sort of the same points packed into 64-bit keys.
//
//     bench_delaunay                             every set that has its font, then shapes of 10^2 to 10^6 points
//     bench_delaunay --benchmark_filter=Sans
//
// ns_per_point is the best pass of several in processor time, of_floor that by the floor's best. A set states its tolerance in font
// units and prints how many points a glyph it gives; glyphs whose contours cross or touch are left out and counted. Configured
// with -DTYPEMESH_BENCH_PEERS=ON, GLU's tessellator and CGAL's constrained Delaunay triangulation (GPL; never installed, nothing of
// it in the library) run on the same glyphs, and are stopped after 10 s a case.
//
// Fonts: packages fonts-liberation, fonts-mplus.

#include "polygons.hpp"

#include <typemesh/fill/orient.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <benchmark/benchmark.h>

#ifdef TYPEMESH_BENCH_PEERS
#include "peers.hpp"
#endif

#include <cstdio>
#include <ctime>
#include <functional>

namespace {

using namespace typemesh;

struct set {
    std::string name;
    std::vector<contours> loops;  ///< of the glyphs that are regions
    std::vector<region> regions;  ///< of the same
    std::size_t refused = 0;
    double points = 0;
    int passes = 5;

    void take(const std::vector<bench::polygon>& polygons)
    {
        workspace space;
        triangle_list out;
        for (const bench::polygon& p : polygons) {
            contours c = bench::contours_of(p);
            orient(c);
            out.clear();
            if (!monotone{}.prove(c, space, out)) {
                ++refused;
                continue;
            }
            points += static_cast<double>(c.points.size());
            loops.push_back(std::move(c));
        }
        for (const contours& c : loops) {
            out.clear();
            regions.push_back(*monotone{}.prove(c, space, out));
        }
    }
};

/// Of processor time, which others on the machine disturb less than the wall's; f again and again for 2 ms at least.
double nanoseconds(const std::function<void()>& f)
{
    const std::clock_t begin = std::clock();
    std::clock_t now = begin;
    int times = 0;
    do {
        f();
        ++times;
        now = std::clock();
    } while (now - begin < CLOCKS_PER_SEC / 500);
    return 1e9 * static_cast<double>(now - begin) / CLOCKS_PER_SEC / times;
}

void sort_points(const set& s, std::vector<std::uint64_t>& keys)
{
    for (const contours& c : s.loops) {
        keys.clear();
        for (const grid_point p : c.points)
            keys.push_back(static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x) ^ 0x8000'0000u) << 32 |
                           (static_cast<std::uint32_t>(p.y) ^ 0x8000'0000u));
        std::sort(keys.begin(), keys.end());
        benchmark::DoNotOptimize(keys.data());
    }
}

/// All glyphs once: proven and triangulated, or triangulated on trust.
template <class Triangulator>
void pass(const set& s, bool proving, workspace& space, triangle_list& out, const Triangulator& triangulate = {})
{
    for (std::size_t i = 0; i < s.loops.size(); ++i) {
        out.clear();
        if (proving ? !triangulate.prove(s.loops[i], space, out)
                    : static_cast<bool>(triangulate(s.regions[i], space, out)))
            std::abort();
        benchmark::DoNotOptimize(out.data());
    }
}

void run(benchmark::State& state, const set& s, const std::function<void(workspace&, triangle_list&)>& f)
{
    workspace space;
    triangle_list out;
    std::vector<std::uint64_t> keys;
    double floor = 1e300, best = 1e300;
    for ([[maybe_unused]] auto unused : state) {
        for (int i = 0; i < s.passes; ++i) {
            floor = (std::min)(floor, nanoseconds([&] { sort_points(s, keys); }));
            best = (std::min)(best, nanoseconds([&] { f(space, out); }));
        }
    }
    state.counters["floor"] = floor / s.points;
    state.counters["ns_per_point"] = best / s.points;
    state.counters["of_floor"] = best / floor;
    state.counters["points"] = s.points / static_cast<double>(s.loops.size());
    state.counters["glyphs"] = static_cast<double>(s.loops.size());
    state.counters["refused"] = static_cast<double>(s.refused);
}

#ifdef TYPEMESH_BENCH_PEERS
void run_peer(benchmark::State& state, const set& s, void (*peer)(const contours&))
{
    double ns = 0;
    for ([[maybe_unused]] auto unused : state)
        ns = bench::seconds_within(10, [&] {
            double best = 1e300;
            for (int i = 0; i < (std::min)(s.passes, 3); ++i)
                best = (std::min)(best, nanoseconds([&] {
                                      for (const contours& c : s.loops) peer(c);
                                  }));
            return best;
        });
    if (ns <= 0) return state.SkipWithError("stopped after 10 s");
    state.counters["ns_per_point"] = ns / s.points;
}
#endif

void add(const set& s)
{
    const auto entry = [&s](const char* name, std::function<void(workspace&, triangle_list&)> f) {
        benchmark::RegisterBenchmark((s.name + " / " + name).c_str(),
                                     [&s, f](benchmark::State& state) { run(state, s, f); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    };
    entry("monotone proving", [&s](workspace& w, triangle_list& out) { pass<monotone>(s, true, w, out); });
    entry("monotone trusting", [&s](workspace& w, triangle_list& out) { pass<monotone>(s, false, w, out); });
    entry("delaunay proving", [&s](workspace& w, triangle_list& out) { pass<constrained_delaunay>(s, true, w, out); });
    entry("delaunay trusting",
          [&s](workspace& w, triangle_list& out) { pass<constrained_delaunay>(s, false, w, out); });
    entry("delaunay by slabs, trusting",
          [&s](workspace& w, triangle_list& out) { pass(s, false, w, out, constrained_delaunay{.max_flips = 0}); });
#ifdef TYPEMESH_BENCH_PEERS
    for (const auto& [name, peer] : bench::peers())
        benchmark::RegisterBenchmark((s.name + " / " + name).c_str(),
                                     [&s, peer = peer](benchmark::State& state) { run_peer(state, s, peer); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
#endif
}

}  // namespace

int main(int argc, char** argv)
{
    struct font_set {
        const char* name;
        const char* file;
        double tolerance;  ///< font units
        unsigned most;     ///< glyphs
    };
    const font_set fonts[] = {
        {"Liberation Sans, 1.5 units", "truetype/liberation/LiberationSans-Regular.ttf", 1.5, 100'000},
        {"Liberation Sans, 0.06 units", "truetype/liberation/LiberationSans-Regular.ttf", 0.06, 100'000},
        {"M+ 1, 0.1 units", "opentype/mplus/Mplus1-Regular.otf", 0.1, 2000},
    };
    std::vector<set> sets;
    sets.reserve(200);
    for (const font_set& f : fonts) {
        set s{f.name, {}, {}, 0, 0, 7};
        s.take(bench::glyphs_of(f.file, f.tolerance, f.most));
        if (s.loops.empty()) {
            std::fprintf(stderr, "left out, no such font: %s\n", f.file);
            continue;
        }
        sets.push_back(std::move(s));
        add(sets.back());
    }
    for (int n = 100; n <= 1'000'000; n *= 10) {
        for (const auto& [name, p] : bench::shapes_of(n)) {
            set s{name + " of " + std::to_string(n), {}, {}, 0, 0, n < 100'000 ? 5 : 2};
            s.take({p});
            if (s.loops.empty()) {
                std::fprintf(stderr, "left out, not simple on the grid: %s\n", s.name.c_str());
                continue;
            }
            sets.push_back(std::move(s));
            add(sets.back());
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
