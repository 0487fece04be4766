// SPDX-License-Identifier: MIT
//
// The ways to mesh a letter, side by side: the rows of docs/meshing.md. About 500 glyphs of a font, equally far apart in
// it, one after the other, from the font to the planned mesh.
//
//     bench_meshing                             every font that is installed
//     bench_meshing --benchmark_filter=Serif
//
// us_per_glyph is the best pass of several, in processor time; of_monotone the same by the time of `monotone`.
// triangles are those seen from the front, per glyph. The counters 015, 030, ... 180 are the shares of all their angles
// in steps of 15 degrees, in percent: 015 counts the angles below 15 degrees, 030 the angles from 15 to 30. least is the
// least angle in degrees, greatest the greatest. Refined meshes have edges of at most 0.05 em; bent ones lie on a cylinder of
// 2 em, and their angles are measured before they are bent.
//
// The rows "levels" are levels of detail (coarsened.hpp) of extruded letters, the finest at 1/800 em: points is the
// number of contour points per glyph, points_of_fresh the same by that of letters that are flattened at the level's
// tolerance, time_of_fresh the time likewise. step_of_fresh is the time of the step alone, which makes the level of a
// region that is there already, with its triangles: by the time from the font to region and triangles at the level's
// tolerance.
//
// Fonts: packages fonts-dejavu-core, fonts-liberation, fonts-sawarabi-mincho.

#include "../tests/support/font_path.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;

constexpr double fine = quality::high;

struct font_to_mesh {
    std::string name;
    harfbuzz_font font;
    glyph_run run;  ///< each glyph once, at the origin
};

double seconds(const auto& f)
{
    const std::clock_t begin = std::clock();
    f();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// The best of several plans of all glyphs, in microseconds per glyph of the mesh.
template <class Mesher>
double us_per_glyph(Mesher& mesher, const glyph_run& run, double tolerance)
{
    double best = 1e300;
    std::size_t glyphs = 1;
    for (int pass = 0; pass < 5; ++pass)
        best = std::min(best, seconds([&] {
                            const auto plan = mesher.plan(run, {.tolerance = tolerance});
                            if (plan) glyphs = plan->glyphs().size();
                        }));
    return 1e6 * best / static_cast<double>(std::max<std::size_t>(1, glyphs));
}

/// The angles of triangles.
struct angle_histogram {
    std::size_t triangles = 0, bins[12] = {};
    double least = 180.0, greatest = 0.0;

    void add(grid_point a, grid_point b, grid_point c)
    {
        ++triangles;
        const grid_point p[] = {a, b, c};
        for (int k = 0; k < 3; ++k) {
            const grid_point o = p[k], q = p[(k + 1) % 3], r = p[(k + 2) % 3];
            const double cosine = (double(q.x) - o.x) * (double(r.x) - o.x) + (double(q.y) - o.y) * (double(r.y) - o.y);
            const double degrees =
                std::atan2(std::fabs(static_cast<double>(orientation(o, q, r))), cosine) * 57.29577951308232;
            ++bins[std::min(11, static_cast<int>(degrees / 15.0))];
            least = std::min(least, degrees);
            greatest = std::max(greatest, degrees);
        }
    }
};

template <class Solid, class Triangulator>
void run_way(benchmark::State& state, font_to_mesh& f, const Solid& solid, const Triangulator& cut)
{
    text_mesher mesher{f.font, solid, cut};
    text_mesher plain{f.font, flat{}};
    double best = 0.0, floor = 1.0;
    for ([[maybe_unused]] auto unused : state) {
        best = us_per_glyph(mesher, f.run, fine);
        floor = us_per_glyph(plain, f.run, fine);
    }
    angle_histogram angles;
    const auto plan = mesher.plan(f.run, {.tolerance = fine});
    if (!plan) return state.SkipWithError(plan.error().message());
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
        plan->each_seen_from_front(g, [&](grid_point a, grid_point b, grid_point c) { angles.add(a, b, c); });
    state.counters["us_per_glyph"] = best;
    state.counters["of_monotone"] = best / floor;
    state.counters["triangles"] = static_cast<double>(angles.triangles) / static_cast<double>(plan->glyphs().size());
    state.counters["least"] = angles.least;
    state.counters["greatest"] = angles.greatest;
    for (int k = 0; k < 12; ++k) {
        char below[8];
        std::snprintf(below, sizeof below, "%03d", 15 * (k + 1));
        state.counters[below] =
            100.0 * static_cast<double>(angles.bins[k]) / (3.0 * static_cast<double>(angles.triangles));
    }
}

/// A region with memory of its own.
struct kept_region {
    contours loops;
    std::vector<curve> curves;
    region filled;
};

/// Makes the regions of all glyphs, and keeps them if `out` is not null.
void fill_all(font_to_mesh& f, double tolerance, std::deque<kept_region>* out)
{
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    static glyph_builder builder;
    for (const placed_glyph& g : f.run.glyphs) {
        const auto fill = [&] {
            return builder.build_region(f.font, g.id, {.tolerance = tolerance}, cap_policies{flatten, cut, nobody});
        };
        if (out == nullptr) {
            (void)fill();
            continue;
        }
        const auto made = fill();
        if (!made || made->points().empty()) continue;
        kept_region& kept = out->emplace_back();
        kept.curves.assign(made->curves().begin(), made->curves().end());
        (void)kept.loops.points.append(made->points());
        (void)kept.loops.edges.append(made->edges());
        (void)kept.loops.starts.append(made->starts());
        kept.loops.grid = made->grid();
        kept.loops.tolerance = made->tolerance();
        kept.loops.curves = kept.curves;
        kept.filled = region::proven(kept.loops, made->holes(), made->outers(), made->is_touching());
    }
}

/// The time of the step alone, by that of making regions at the level's tolerance.
double step_of_fresh(font_to_mesh& f, const coarsened& levels, double tolerance)
{
    std::deque<kept_region> regions;
    fill_all(f, fine, &regions);
    cap_builder own, further;
    const monotone cut;
    coarsened::scratch scratch;
    double ours = 1e300, theirs = 1e300;
    for (int pass = 0; pass < 5; ++pass) {
        theirs = std::min(theirs, seconds([&] { fill_all(f, tolerance, nullptr); }));
        ours = std::min(ours, seconds([&] {
                            for (const kept_region& r : regions) {
                                scratch.clear();
                                region_caps caps{own, further, cut, {}};
                                (void)levels(r.filled, scratch, caps);
                            }
                        }));
    }
    return ours / theirs;
}

void run_level(benchmark::State& state, font_to_mesh& f, std::uint32_t level)
{
    coarsened levels{.tolerances = {quality::normal, 1.0 / 60, 1.0 / 25}, .level = level};
    const double tolerance = level == 0 ? fine : levels.tolerances[level - 1];
    text_mesher mesher{f.font, levels}, fresh{f.font};
    double ours = 0.0, theirs = 1.0, points = 0.0, fresh_points = 1.0, glyphs = 1.0;
    for ([[maybe_unused]] auto unused : state) {
        ours = us_per_glyph(mesher, f.run, fine);
        theirs = us_per_glyph(fresh, f.run, tolerance);
    }
    if (const auto plan = mesher.plan(f.run, {.tolerance = fine})) {
        points = static_cast<double>(plan->contour_points());
        glyphs = static_cast<double>(plan->glyphs().size());
    }
    if (const auto plan = fresh.plan(f.run, {.tolerance = tolerance}))
        fresh_points = static_cast<double>(plan->contour_points());
    if (level != 0) state.counters["step_of_fresh"] = step_of_fresh(f, levels, tolerance);
    state.counters["us_per_glyph"] = ours;
    state.counters["time_of_fresh"] = ours / theirs;
    state.counters["points"] = points / glyphs;
    state.counters["points_of_fresh"] = points / fresh_points;
}

template <class Solid, class Triangulator>
void add_way(font_to_mesh& f, const char* name, const Solid& solid, const Triangulator& cut)
{
    benchmark::RegisterBenchmark((f.name + " / " + name).c_str(),
                                 [&f, solid, cut](benchmark::State& state) { run_way(state, f, solid, cut); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

void add_ways(font_to_mesh& f)
{
    constexpr float longest = 0.05f;
    const constrained_delaunay delaunay;
    add_way(f, "monotone", flat{}, monotone{});
    add_way(f, "constrained_delaunay", flat{}, delaunay);
    add_way(f, "delaunay_refined", refined<flat>{}, delaunay);
    add_way(f, "delaunay_refined, 0.05 em", refined<flat>{.how = {.max_edge = longest}}, delaunay);
    add_way(f, "quadtree_refined, 0.05 em", refined<flat, quadtree_refined>{.how = {.max_edge = longest}}, delaunay);
    add_way(f, "non_obtuse", refined<flat, non_obtuse>{}, delaunay);
    add_way(f, "flat_curved", flat_curved{}, delaunay);
    add_way(f, "bent", bent<on_cylinder, flat>{.how = {.radius = 2.0}}, delaunay);
    for (std::uint32_t level = 0; level <= 3; ++level)
        benchmark::RegisterBenchmark((f.name + " / levels / " + std::to_string(level)).c_str(),
                                     [&f, level](benchmark::State& state) { run_level(state, f, level); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv)
{
    static std::deque<font_to_mesh> fonts;
    struct font {
        const char *name, *file;
    };
    for (const font& f : {font{"DejaVu Sans", "truetype/dejavu/DejaVuSans.ttf"},
                          font{"Liberation Serif", "truetype/liberation/LiberationSerif-Regular.ttf"},
                          font{"Sawarabi Mincho", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf"}}) {
        const std::string file = font_path(f.file).string();
        auto opened = harfbuzz_font::open(file.c_str());
        if (!opened) {
            std::fprintf(stderr, "%s is not installed: left out\n", f.file);
            continue;
        }
        font_to_mesh& one = fonts.emplace_back(font_to_mesh{f.name, std::move(*opened), glyph_run{}});
        one.run.units_per_em = one.font.units_per_em();
        const glyph_id step = std::max<glyph_id>(1, one.font.glyph_count() / 500);
        for (glyph_id id = 0; id < one.font.glyph_count(); id += step)
            (void)one.run.glyphs.push_back({.id = id, .cluster = id});
        add_ways(one);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
