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
// are long: circle with holes.
//
// With -DTYPEMESH_BENCH_PEERS=ON, at 2 % of the em without joins, on a sample of the glyphs: cgal_us, the time that CGAL's
// interior straight skeleton of a region takes; ours_us, that of the triangulation and the sweep together; cgal_of_ours;
// cgal_none, the glyphs of which CGAL gave no skeleton within 10 s.
//
// Fonts: packages fonts-liberation, fonts-dejavu-core, fonts-mplus.

#include "polygons.hpp"
#ifdef TYPEMESH_BENCH_PEERS
#include "every_glyph/skeleton_peer.hpp"
#include "seconds_within.hpp"
#endif

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

/// Cuts regions and sweeps them, one after another.
class sweeper {
public:
    explicit sweeper(double mitre_limit) : mitre_limit_{mitre_limit} {}

    double cut(const region& r)
    {
        triangles_.clear();
        return nanoseconds([&] {
            if (monotone{}(r, space_, triangles_)) std::abort();
        });
    }
    /// Of what was cut last.
    double sweep(const region& r, double width)
    {
        const double levels[] = {0.0, width};
        return nanoseconds([&] {
            swept_.clear();
            workspace::scope scratch{space_};
            was_refused_ = bool(
                sweep_inwards(r, triangles_.view(), {.levels = levels, .mitre_limit = mitre_limit_}, scratch, swept_));
        });
    }
    [[nodiscard]] bool was_refused() const { return was_refused_; }
    [[nodiscard]] std::size_t events() const { return swept_.events; }
    [[nodiscard]] std::size_t schedules() const { return swept_.schedules; }

private:
    double mitre_limit_;
    workspace space_;
    triangle_list triangles_;
    swept_region swept_;
    bool was_refused_ = false;
};

#ifdef TYPEMESH_BENCH_PEERS
void run_beside_cgal(benchmark::State& state, const set& s)
{
    constexpr std::size_t most = 60;
    sweeper ours{0.0};
    double of_cgal = 0, of_ours = 0, none = 0, count = 0;
    for (std::size_t i = 0; i < s.regions.size(); i += 1 + s.regions.size() / most) {
        const region& r = s.regions[i];
        const double seconds = bench::seconds_within(10, [&] {
            test::skeleton_peer peer;
            return peer.build(r) ? peer.seconds() : 0.0;
        });
        double best = 1e300;
        for (int pass = 0; pass < 3; ++pass) {
            const double cut = ours.cut(r);
            best = (std::min)(best, cut + ours.sweep(r, s.widths[i]));
        }
        none += seconds > 0.0 ? 0 : 1;
        if (!(seconds > 0.0)) continue;
        of_cgal += 1e9 * seconds;
        of_ours += best;
        ++count;
    }
    state.counters["cgal_us"] = of_cgal / 1000 / count;
    state.counters["ours_us"] = of_ours / 1000 / count;
    state.counters["cgal_of_ours"] = of_cgal / of_ours;
    state.counters["cgal_none"] = none;
}
#endif

void run(benchmark::State& state, const set& s, double mitre_limit)
{
    sweeper ours{mitre_limit};
    double floor = 1e300, best = 1e300, refused = 0, events = 0, schedules = 0;
    for ([[maybe_unused]] auto unused : state) {
        for (int pass = 0; pass < 3; ++pass) {
            double cut = 0, swept_in = 0;
            refused = events = schedules = 0;
            for (std::size_t i = 0; i < s.regions.size(); ++i) {
                cut += ours.cut(s.regions[i]);
                swept_in += ours.sweep(s.regions[i], s.widths[i]);
                refused += ours.was_refused() ? 1 : 0;
                events += static_cast<double>(ours.events());
                schedules += static_cast<double>(ours.schedules());
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
#ifdef TYPEMESH_BENCH_PEERS
    if (mitre_limit <= 0 && s.name.find(" 2 %") != std::string::npos) run_beside_cgal(state, s);
#endif
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
