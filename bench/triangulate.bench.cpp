// SPDX-License-Identifier: MIT
//
// Triangulation alone, a stream of different glyphs (a loop over one glyph trains the branch predictor and flatters by
// a factor of 2 to 4), beside the floor in the same run: std::sort of the same points packed into 64-bit keys.
//
//     bench_triangulate                          every set that has its font
//     bench_triangulate --benchmark_filter=Sans
//
// Columns: ns_per_point (best pass of five) and of_floor (that by the floor's). A set states its tolerance in font
// units and prints how many points a glyph it gives. Outlines are flattened here by equal steps of t, snapped to 1/512
// unit.
//
// Fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts); packages fonts-liberation,
// fonts-dejavu-core, fonts-wqy-microhei, fonts-inter-variable, fonts-mplus.

#include "polygons.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace typemesh;
using namespace bench;

// --- timing ------------------------------------------------------------------------------------------------------

/// Nanoseconds a point: the best of `passes` over all of `work`.
template <class Work, class F>
double best_pass(const Work& work, double points, int passes, F&& f)
{
    double best = 1e300;
    for (int i = 0; i < passes; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        for (auto& w : work) f(w);
        best = (std::min)(best,
                          std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
    }
    return best / points;
}

struct set {
    std::string name;
    std::vector<contours> simple;  ///< what monotone accepts
    std::vector<contours> given;   ///< the same, before orient()
    std::size_t refused = 0;
    double points = 0;

    void take(const polygon& p, workspace& space, triangle_list& out)
    {
        contours raw = contours_of(p), c = contours_of(p);
        orient(c);
        out.clear();
        if (!monotone{}.prove(c, space, out)) {
            ++refused;
            return;
        }
        points += static_cast<double>(c.points.size());
        given.push_back(std::move(raw));
        simple.push_back(std::move(c));
    }
};

void sort_points(const contours& c, std::vector<std::uint64_t>& keys)
{
    keys.clear();
    for (const grid_point p : c.points)
        keys.push_back(static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x) ^ 0x8000'0000u) << 32 |
                       (static_cast<std::uint32_t>(p.y) ^ 0x8000'0000u));
    std::sort(keys.begin(), keys.end());
    benchmark::DoNotOptimize(keys.data());
}

enum class what { sort, prove, trust, orient, fill };

/// One pass over the set a benchmark iteration; the floor is measured beside it.
void run(benchmark::State& state, const set& s, what w, int passes)
{
    workspace space;
    triangle_list out;
    std::vector<std::uint64_t> keys;
    std::vector<region> regions;
    for (const contours& c : s.simple) {
        out.clear();
        regions.push_back(*monotone{}.prove(c, space, out));
    }
    std::vector<const contours*> simple;
    for (const contours& c : s.simple) simple.push_back(&c);

    double floor = 1e300, best = 1e300;
    for ([[maybe_unused]] auto unused : state) {
        for (int pass = 0; pass < passes; ++pass) {
            floor =
                (std::min)(floor, best_pass(simple, s.points, 1, [&](const contours* c) { sort_points(*c, keys); }));
            double now = floor;
            if (w == what::prove)
                now = best_pass(simple, s.points, 1, [&](const contours* c) {
                    out.clear();
                    if (!monotone{}.prove(*c, space, out)) std::abort();
                });
            if (w == what::trust)
                now = best_pass(regions, s.points, 1, [&](const region& r) {
                    out.clear();
                    if (monotone{}(r, space, out)) std::abort();
                });
            if (w == what::fill || w == what::orient) {  // both work in place: on fresh copies
                std::vector<contours> copies;
                for (const contours& c : s.given) {
                    copies.emplace_back();
                    if (!copies.back().points.append(c.points.view()) || !copies.back().edges.append(c.edges.view()) ||
                        !copies.back().starts.append(c.starts.view()))
                        std::abort();
                }
                const auto begin = std::chrono::steady_clock::now();
                for (contours& c : copies) {
                    if (w == what::orient)
                        orient(c);
                    else if (!fill(c, fill_rule::non_zero, space))
                        std::abort();
                }
                now = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() /
                      s.points;
            }
            best = (std::min)(best, now);
        }
    }
    state.counters["ns_per_point"] = best;
    state.counters["of_floor"] = best / floor;
    state.counters["points"] = s.points / static_cast<double>(s.simple.size());
    state.counters["glyphs"] = static_cast<double>(s.simple.size());
    state.counters["refused"] = static_cast<double>(s.refused);
}

void add(const set& s, int passes)
{
    const std::pair<const char*, what> all[] = {{"std::sort", what::sort},
                                                {"monotone proving", what::prove},
                                                {"monotone trusting", what::trust},
                                                {"orient", what::orient},
                                                {"fill", what::fill}};
    for (const auto& [name, w] : all)
        benchmark::RegisterBenchmark((s.name + " / " + name).c_str(),
                                     [&s, w = w, passes](benchmark::State& state) { run(state, s, w, passes); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
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
        {"Liberation Sans, 1.2 units", "truetype/liberation/LiberationSans-Regular.ttf", 1.2, 100'000},    // 60 points
        {"Liberation Sans, 0.06 units", "truetype/liberation/LiberationSans-Regular.ttf", 0.06, 100'000},  // 200 points
        {"DejaVu Sans, 1.6 units", "truetype/dejavu/DejaVuSans.ttf", 1.6, 100'000},                        // 60 points
        {"WenQuanYi Micro Hei, 0.14 units", "truetype/wqy/wqy-microhei.ttc", 0.14, 3000},                  // 200 points
        {"Inter variable, 2.6 units", "truetype/inter-vf/Inter.var.ttf", 2.6, 100'000},                    // 60 points
        {"M+ 1p, 0.1 units", "truetype/mplus/mplus-1p-regular.ttf", 0.1, 3000},
    };
    std::vector<set> sets;
    sets.reserve(200);
    workspace space;
    triangle_list out;
    for (const font_set& f : fonts) {
        set s{f.name, {}, {}, 0, 0};
        for (const polygon& p : glyphs_of(f.file, f.tolerance, f.most)) s.take(p, space, out);
        if (s.simple.empty()) {
            std::fprintf(stderr, "left out, no such font: %s\n", f.file);
            continue;
        }
        sets.push_back(std::move(s));
        add(sets.back(), 5);
    }
    for (int n = 100; n <= 1'000'000; n *= 10) {
        for (const auto& [name, p] : bench::shapes_of(n)) {
            set s{name + " of " + std::to_string(n), {}, {}, 0, 0};
            s.take(p, space, out);
            if (s.simple.empty()) {
                std::fprintf(stderr, "left out, not simple on the grid: %s\n", s.name.c_str());
                continue;
            }
            sets.push_back(std::move(s));
            add(sets.back(), n < 100'000 ? 5 : 2);
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
