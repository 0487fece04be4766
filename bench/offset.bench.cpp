// SPDX-License-Identifier: MIT
//
// Regions swept inwards: a stream of different glyphs, and shapes of 10^2 to 10^5 points, beside the floor in the same
// run: monotone's triangulation of the same regions, which a sweep starts from.
//
//     bench_offset                             every set that has its font, then the shapes
//     bench_offset --benchmark_filter=Sans
//
// Columns: ns_per_point (best pass of three), us_per_region, of_floor (that by the floor's), events a point, schedules
// a point, refused regions. Glyphs are flattened to 1/800 em by equal steps of t and swept to a share of the em. The
// width of a shape is its area by its perimeter, half a stroke's width on average ("wide"), or a tenth of that
// ("narrow"); a regular star closes at once between the two. Few flips are left over Delaunay triangles where monotone's
// are long: circle with holes. For the time of CGAL's skeleton on the same glyphs see tests/every_glyph/every_offset.cpp.
//
// Fonts: packages fonts-liberation, fonts-dejavu-core, fonts-mplus.

#include "polygons.hpp"

#include <typemesh/fill/orient.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace typemesh;

struct set {
    std::string name;
    std::vector<contours> loops;  ///< of the regions
    std::vector<region> regions;
    std::vector<double> widths;  ///< of each, in cells
    double points = 0;

    /// A width of `share` by area and perimeter where there is no em.
    void take(const bench::polygon& p, double share, double em)
    {
        static workspace space;
        contours c = bench::contours_of(p);
        orient(c);
        triangle_list out;
        const auto proven = monotone{}.prove(c, space, out);
        if (!proven) return;
        const auto l = inspect::loops_of(c);
        const double area = static_cast<double>(inspect::doubled_area(l)) / 2;
        widths.push_back(std::floor(share * (em > 0 ? em : area / inspect::length(l))));
        points += static_cast<double>(c.points.size());
        const std::uint32_t holes = proven->holes(), outers = proven->outers();
        loops.push_back(std::move(c));
        regions.push_back(region::proven(loops.back(), holes, outers));
    }
};

/// Spikes of one size, which close at one time.
bench::polygon regular_star(int n)
{
    bench::polygon p(1);
    for (int i = 0; i < n; ++i) p[0].push_back(bench::on_circle(0, 0, i % 2 == 0 ? 1e8 : 5e7, double(i) / n));
    return p;
}

template <class F>
double nanoseconds(F&& f)
{
    const auto start = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

void run(benchmark::State& state, const set& s, double mitre_limit)
{
    workspace space;
    triangle_list triangles;
    swept_region swept;
    double floor = 1e300, best = 1e300, refused = 0, events = 0, schedules = 0;
    for ([[maybe_unused]] auto unused : state) {
        for (int pass = 0; pass < 3; ++pass) {
            double cut = 0, swept_in = 0;
            refused = events = schedules = 0;
            for (std::size_t i = 0; i < s.regions.size(); ++i) {
                triangles.clear();
                cut += nanoseconds([&] {
                    if (monotone{}(s.regions[i], space, triangles)) std::abort();
                });
                const double levels[] = {0.0, s.widths[i]};
                error e;
                swept_in += nanoseconds([&] {
                    swept.clear();
                    workspace::scope scratch{space};
                    e = sweep_inwards(s.regions[i], triangles.view(), {.levels = levels, .mitre_limit = mitre_limit},
                                      scratch, swept);
                });
                refused += e ? 1 : 0;
                events += static_cast<double>(swept.events);
                schedules += static_cast<double>(swept.schedules);
            }
            floor = (std::min)(floor, cut);
            best = (std::min)(best, swept_in);
        }
    }
    state.counters["ns_per_point"] = best / s.points;
    state.counters["us_per_region"] = best / 1000 / static_cast<double>(s.regions.size());
    state.counters["of_floor"] = best / floor;
    state.counters["events"] = events / s.points;
    state.counters["schedules"] = schedules / s.points;
    state.counters["refused"] = refused;
}

void add(const set& s, double mitre_limit)
{
    benchmark::RegisterBenchmark((s.name + (mitre_limit > 0 ? ", joins" : "")).c_str(),
                                 [&s, mitre_limit](benchmark::State& state) { run(state, s, mitre_limit); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv)
{
    const struct {
        const char* name;
        const char* file;
        double units;  ///< in an em
    } fonts[] = {{"Liberation Sans", "truetype/liberation/LiberationSans-Regular.ttf", 2048},
                 {"DejaVu Sans", "truetype/dejavu/DejaVuSans.ttf", 2048},
                 {"M+ 1", "opentype/mplus/Mplus1-Regular.otf", 1000}};
    std::vector<set> sets;
    sets.reserve(1000);
    for (const auto& f : fonts) {
        const auto glyphs = bench::glyphs_of(f.file, f.units / 800, 2000);
        for (const double share : {0.01, 0.02, 0.05}) {
            set& s = sets.emplace_back();
            s.name = std::string{f.name} + " to " + std::to_string(static_cast<int>(100 * share)) + " % of the em";
            for (const auto& p : glyphs) s.take(p, share, 512 * f.units);
            if (s.regions.empty()) {
                std::fprintf(stderr, "left out, no such font: %s\n", f.file);
                continue;
            }
            add(s, 0.0);
            add(s, 2.0);
        }
    }
    for (int n = 100; n <= 100'000; n *= 10) {
        auto shapes = bench::shapes_of(n);
        shapes.emplace_back("regular star", regular_star(n));
        for (const auto& [name, p] : shapes) {
            for (const double share : {0.1, 1.0}) {
                set& s = sets.emplace_back();
                s.name = name + " of " + std::to_string(n) + (share < 1.0 ? ", narrow" : ", wide");
                s.take(p, share, 0.0);
                if (!s.regions.empty() && s.widths[0] >= 4.0) add(s, 2.0);
            }
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
