// SPDX-License-Identifier: MIT
//
// Refinement of the first 500 glyphs of a font, one after the other, beside CGAL's mesher and beside the triangulation that it
// begins with.
//
//     bench_refine                             every set that has its font, then polygons
//     bench_refine --benchmark_filter=Serif
//
// ns_per_triangle is the best pass of several, in processor time; of_floor the same by the time of constrained_delaunay,
// the floor, on the same glyphs. below counts the triangles with an angle below the aim, kept those that the refiner
// leaves on purpose. Configured with -DTYPEMESH_BENCH_PEERS=ON, CGAL's Delaunay mesher (GPL; never installed, nothing of
// it in the library) refines the same glyphs to the same angle and size. cgal_triangles and cgal_time are its triangles
// and its time, as multiples; its time begins with its own triangulation, and ours with the region's triangles.
//
// The rows "squares" are quadtree_refined; of_delaunay is the number of its triangles as a multiple of
// delaunay_refined's with the same longest edge and 25 degrees, below the number with an angle below 15 degrees.
// The rows "right triangles" are non_obtuse; of_delaunay is the same, kept counts the triangles with an angle above 90 degrees
// that rounding does not explain.
// The rows "maze", "circle" and "square with holes" refine one polygon of 10^2 to 10^5 points; per_point is the number of triangles
// for each of them. "squares" have edges of at most the polygon's extent by the square root of the number of points.
// The rows "inflated" solve membrane.hpp on the same glyphs, with its default longest edge: ms_per_glyph is the best pass,
// of_refined the same by the time of delaunay_refined alone with that edge.
//
// Fonts: packages fonts-dejavu-core, fonts-liberation.

#include "../tests/support/font_path.hpp"
#include "polygons.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/inflate/membrane.hpp>
#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#ifdef TYPEMESH_BENCH_PEERS
#include "refine_peer.hpp"
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;

/// A glyph's region with memory of its own, and its triangles.
struct glyph {
    contours loops;
    std::vector<curve> curves;
    region filled;
    triangle_list cap;
};

struct set {
    std::string name;
    std::vector<glyph> glyphs;
    delaunay_refined how;
};

/// All glyphs of a font, up to `most`.
std::vector<glyph> glyphs_of(const std::string& file, double tolerance, std::uint32_t most)
{
    std::vector<glyph> all;
    auto font = harfbuzz_font::open(file.c_str());
    if (!font) return all;
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    workspace space;
    for (std::uint32_t id = 0; id < std::min(most, font->glyph_count()); ++id) {
        const auto made = builder.build_region(*font, id, {.tolerance = tolerance}, cap_policies{flatten, cut, nobody});
        if (!made || made->points().empty()) continue;
        glyph& g = all.emplace_back();
        g.curves.assign(made->curves().begin(), made->curves().end());
        (void)g.loops.points.append(made->points());
        (void)g.loops.edges.append(made->edges());
        (void)g.loops.starts.append(made->starts());
        g.loops.grid = made->grid();
        g.loops.tolerance = made->tolerance();
        g.filled = *made;  // its counts; the views are set once the vector does not grow any more
    }
    for (glyph& g : all) {
        g.loops.curves = g.curves;
        g.filled = region::proven(g.loops, g.filled.holes(), g.filled.outers(), g.filled.is_touching());
        (void)cut(g.filled, space, g.cap);
    }
    return all;
}

/// A polygon of n points whose em is its extent.
glyph glyph_of(const bench::polygon& p)
{
    glyph g;
    g.loops = bench::contours_of(p);
    orient(g.loops);
    workspace space;
    const auto proven = monotone{}.prove(g.loops, space, g.cap);
    g.cap.clear();
    if (!proven) return g;
    box extent;
    for (const grid_point q : g.loops.points) extent.add({double(q.x), double(q.y)});
    g.loops.grid = {.cells = 1.0, .units_per_em = extent.high.x - extent.low.x};
    g.filled = region::proven(g.loops, proven->holes(), proven->outers(), proven->is_touching());
    (void)constrained_delaunay{}(g.filled, space, g.cap);
    return g;
}

double seconds(const auto& f)
{
    const std::clock_t begin = std::clock();
    f();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// The triangles with an angle below so many degrees.
std::size_t count_below(const contours& loops, const buffer<grid_point>& inner, const triangle_list& triangles,
                        double degrees)
{
    const double tangent = std::tan(degrees * 0.017453292519943295);
    const auto at = [&](std::uint32_t i) {
        return i < loops.points.size() ? loops.points[i] : inner[i - loops.points.size()];
    };
    std::size_t count = 0;
    for (const triangle t : triangles) {
        const grid_point p[] = {at(t.a), at(t.b), at(t.c)};
        bool is_below = false;
        for (int k = 0; k < 3; ++k) {
            const grid_point o = p[k], a = p[(k + 1) % 3], b = p[(k + 2) % 3];
            const double cosine = (double(a.x) - o.x) * (double(b.x) - o.x) + (double(a.y) - o.y) * (double(b.y) - o.y);
            is_below = is_below || static_cast<double>(orientation(o, a, b)) < tangent * cosine * (1.0 - 1e-12);
        }
        count += is_below;
    }
    return count;
}

/// Refines all glyphs of a set, and counts the triangles with an angle below so many degrees. Returns how many triangles
/// there are, and how long it took.
template <class Refiner>
std::pair<std::size_t, double> refine_all(benchmark::State& state, const set& s, const Refiner& how, double degrees)
{
    typename Refiner::scratch scratch;
    workspace space;
    contours loops;
    buffer<grid_point> inner;
    triangle_list triangles;
    std::uint32_t kept = 0;
    std::size_t count = 0, below = 0, all_kept = 0;
    const auto refine = [&](const glyph& g) {
        return !how(g.filled, g.cap.view(), scratch, {loops, inner, triangles, kept});
    };
    double floor = 1e300, best = 1e300;
    for ([[maybe_unused]] auto unused : state) {
        for (const glyph& g : s.glyphs) {
            if (!refine(g)) continue;
            count += triangles.size();
            all_kept += kept;
            below += count_below(loops, inner, triangles, degrees);
        }
        for (int pass = 0; pass < 5; ++pass) {
            floor = std::min(floor, seconds([&] {
                                 for (const glyph& g : s.glyphs) {
                                     triangles.clear();
                                     (void)constrained_delaunay{}(g.filled, space, triangles);
                                 }
                             }));
            best = std::min(best, seconds([&] {
                                for (const glyph& g : s.glyphs) (void)refine(g);
                            }));
        }
    }
    state.counters["ns_per_triangle"] = 1e9 * best / static_cast<double>(count);
    state.counters["of_floor"] = best / floor;
    state.counters["triangles"] = static_cast<double>(count);
    state.counters["below"] = static_cast<double>(below);
    state.counters["kept"] = static_cast<double>(all_kept);
    return {count, best};
}

/// Another refiner, and the number of its triangles as a multiple of delaunay_refined's.
template <class Refiner>
void run_other(benchmark::State& state, const set& s, const Refiner& how)
{
    const float longest = how.max_edge;
    const std::size_t count = refine_all(state, s, how, 15.0).first;
    delaunay_refined::scratch scratch;
    contours loops;
    buffer<grid_point> inner;
    triangle_list triangles;
    std::uint32_t kept = 0;
    std::size_t others = 0;
    for (const glyph& g : s.glyphs)
        if (!delaunay_refined{25.0f, longest}(g.filled, g.cap.view(), scratch, {loops, inner, triangles, kept}))
            others += triangles.size();
    state.counters["of_delaunay"] = static_cast<double>(count) / static_cast<double>(others);
}

void run(benchmark::State& state, const set& s)
{
    [[maybe_unused]] const auto [count, best] = refine_all(state, s, s.how, static_cast<double>(s.how.min_angle));
#ifdef TYPEMESH_BENCH_PEERS
    std::size_t theirs = 0;
    const double time = seconds([&] {
        for (const glyph& g : s.glyphs) theirs += bench::cgal_triangles(g.filled, s.how);
    });
    state.counters["cgal_triangles"] = static_cast<double>(theirs) / static_cast<double>(count);
    state.counters["cgal_time"] = time / best;
#endif
}

void run_inflated(benchmark::State& state, const std::vector<glyph>& glyphs)
{
    constexpr float edge = 0.03f;
    membrane sheet;
    delaunay_refined::scratch scratch;
    contours loops;
    buffer<grid_point> inner;
    triangle_list triangles;
    std::uint32_t kept = 0;
    const refined_cap out{loops, inner, triangles, kept};
    double refined = 1e300, best = 1e300;
    std::size_t points = 0;
    for ([[maybe_unused]] auto unused : state) {
        for (const glyph& g : glyphs) {
            if (sheet.inflate(g.filled, g.cap.view(), {.edge = edge}, out)) continue;
            points += inner.size();
        }
        for (int pass = 0; pass < 5; ++pass) {
            refined = std::min(refined, seconds([&] {
                                   for (const glyph& g : glyphs)
                                       (void)delaunay_refined{.max_edge = edge}(g.filled, g.cap.view(), scratch, out);
                               }));
            best = std::min(best, seconds([&] {
                                for (const glyph& g : glyphs)
                                    (void)sheet.inflate(g.filled, g.cap.view(), {.edge = edge}, out);
                            }));
        }
    }
    const auto count = static_cast<double>(glyphs.size());
    state.counters["ms_per_glyph"] = 1e3 * best / count;
    state.counters["of_refined"] = best / refined;
    state.counters["unknowns"] = static_cast<double>(points) / count;
}

/// A row for a polygon.
template <class Refiner>
void add_shape(const set& s, const char* way, const Refiner& how)
{
    benchmark::RegisterBenchmark((s.name + " / " + way).c_str(),
                                 [&s, how](benchmark::State& state) {
                                     const auto count = static_cast<double>(refine_all(state, s, how, 15.0).first);
                                     const std::size_t points = s.glyphs[0].filled.points().size();
                                     state.counters["per_point"] = count / static_cast<double>(points);
                                 })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv)
{
    static std::vector<set> sets;
    struct font {
        const char *name, *file;
    };
    for (const font& f : {font{"DejaVu Sans", "truetype/dejavu/DejaVuSans.ttf"},
                          font{"Liberation Serif", "truetype/liberation/LiberationSerif-Regular.ttf"}}) {
        const std::string file = font_path(f.file).string();
        if (!std::filesystem::exists(file)) {
            std::fprintf(stderr, "%s is not installed: left out\n", f.file);
            continue;
        }
        for (const int tolerance : {160, 800})
            for (const float angle : {20.0f, 25.0f, 30.0f})
                for (const float longest : {0.0f, 0.05f}) {
                    char name[100];
                    std::snprintf(name, sizeof name, "%s 1/%d em / %g degrees / longest edge %g em", f.name, tolerance,
                                  double{angle}, double{longest});
                    sets.push_back({name, glyphs_of(file, 1.0 / tolerance, 500), {angle, longest}});
                }
    }
    for (std::size_t i = 0; i < sets.size(); i += 12)
        benchmark::RegisterBenchmark(("inflated " + sets[i].name).c_str(),
                                     [i](benchmark::State& state) { run_inflated(state, sets[i].glyphs); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    for (const set& s : sets) {
        if (s.how.min_angle == 25.0f && s.how.max_edge == 0.0f) {
            const std::string of = s.name.substr(0, s.name.find(" / 25"));
            const auto add = [&](const char* way, auto how) {
                const std::string name =
                    of + " / " + way + " / longest edge " + std::to_string(how.max_edge).substr(0, 4) + " em";
                benchmark::RegisterBenchmark(name.c_str(),
                                             [&s, how](benchmark::State& state) { run_other(state, s, how); })
                    ->Iterations(1)
                    ->Unit(benchmark::kMillisecond);
            };
            for (const float longest : {0.02f, 0.05f, 0.1f}) add("squares", quadtree_refined{longest});
            for (const float longest : {0.0f, 0.05f}) add("right triangles", non_obtuse{longest});
        }
        benchmark::RegisterBenchmark(s.name.c_str(), [&s](benchmark::State& state) { run(state, s); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
    static std::vector<set> shapes;
    shapes.reserve(100);
    for (int n = 100; n <= 100'000; n *= 10)
        for (const auto& [name, p] : {std::pair{"maze", bench::maze(n)},
                                      {"circle", bench::circle(n)},
                                      {"square with holes", bench::square_with_holes(n)}}) {
            set& s = shapes.emplace_back();
            s.name = std::string{name} + " of " + std::to_string(n);
            s.glyphs.push_back(glyph_of(p));
            if (s.glyphs[0].filled.points().empty()) continue;
            add_shape(s, "triangles", delaunay_refined{});
            add_shape(s, "squares", quadtree_refined{1.0f / std::sqrt(static_cast<float>(n))});
            add_shape(s, "right triangles", non_obtuse{});
        }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
