// SPDX-License-Identifier: MIT
//
// What contours that cross cost: the overlapping glyphs of a font against its simple ones, per contour point that the
// discretiser gives, each set a stream of different glyphs; and how the cost grows with the size of a shape.
//
//     bench_resolve                              every set that has its font
//     bench_resolve --benchmark_filter=Inter
//
// Columns: ns_per_point (best pass of five; points before resolving); of_simple (that by the simple glyphs' of the same
// font in the same run: at most 5 is asked of "all", the refused first try included).
//
//     simple       orient, prove and triangulate: the whole way of a simple outline
//     touching     the same of outlines that only touch in points: refused, walked anew and proven, not resolved
//     all          orient, refuse, resolve, triangulate: the whole way of contours that cross
//     refuse, resolve, triangulate     its parts, each on its own: it sorts the points, which "all" does once
//     guarded      the whole way of an outline that crosses, build() less discretising it once: the filter of
//                  intersections and its rounds are in it; of_simple: by the same of the simple outlines
//
// ns_per_log (resolve): nanoseconds of processor time by N log2 N, where N counts the pieces that the edges are cut
// into, n + k: flat from 100 to 100,000 points where resolving takes O((n + k) log n). Shapes of these sizes: combs and
// random stars, alone, doubled and shifted, fans and strips of nearly parallel edges, pinwheels, discs, chords.
// What rises from 10,000 points on is mostly the memory's latency.
//
// Fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts); packages fonts-inter-variable,
// fonts-hosny-amiri, fonts-noto-cjk, fonts-noto-cjk-extra, fonts-wqy-microhei, fonts-liberation.

#include "../tests/support/font_path.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/typemesh.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;

struct polygon {
    std::vector<grid_point> points;
    std::vector<contour_edge> edges;
    std::vector<std::uint32_t> starts;

    void give(contours& loops) const
    {
        loops.clear();
        (void)loops.points.append(points);
        (void)loops.edges.append(edges);
        (void)loops.starts.append(starts);
    }
};

enum class way { simple, touching, all, refuse, resolve, triangulate, guarded };

struct drawing {
    outline shape;
    grid cells;
};

struct set {
    std::string name;
    std::vector<polygon> simple, touching, crossing;
    double simple_ns = 0;                                               // a point
    std::vector<drawing> simple_drawings = {}, crossing_drawings = {};  // of the same glyphs; none for other shapes
    double tolerance = 0;                                               // of these, in font units

    [[nodiscard]] const std::vector<polygon>& glyphs(way w) const
    {
        return w == way::simple ? simple : w == way::touching ? touching : crossing;
    }
};

double run_once(const set& s, way w, cap_builder& caps, workspace& space, triangle_list& out)
{
    contours& loops = caps.loops();
    const std::vector<polygon>& glyphs = s.glyphs(w);
    double spent = 0;
    std::size_t points = 0;
    using clock = std::chrono::steady_clock;
    const auto all_start = clock::now();
    for (const polygon& p : glyphs) {
        points += p.points.size();
        p.give(loops);
        out.clear();
        if (w == way::simple || w == way::touching || w == way::all) {
            benchmark::DoNotOptimize(caps.fill({}, monotone{}));
        } else if (w == way::refuse) {
            orient(loops);
            benchmark::DoNotOptimize(monotone{}.prove(loops, space, out));
        } else if (w == way::resolve) {
            benchmark::DoNotOptimize(resolve(loops, fill_rule::non_zero, space));
        } else {
            const auto made = resolve(loops, fill_rule::non_zero, space);
            const auto start = clock::now();
            if (made) benchmark::DoNotOptimize(monotone{}(*made, space, out).code);
            spent += std::chrono::duration<double>(clock::now() - start).count();
        }
    }
    if (w != way::triangulate) spent = std::chrono::duration<double>(clock::now() - all_start).count();
    return 1e9 * spent / static_cast<double>(points);
}

std::size_t points_of(const std::vector<polygon>& all)
{
    std::size_t n = 0;
    for (const polygon& p : all) n += p.points.size();
    return n;
}

/// Seconds for a run over all drawings, the best of some: from outlines to triangles, or discretising alone.
double draw(const std::vector<drawing>& all, double tolerance, bool whole, int passes)
{
    cap_builder caps;
    no_observer nobody;
    double best = 1e300;
    for (int i = 0; i <= passes; ++i) {
        const auto start = std::chrono::steady_clock::now();
        for (const drawing& d : all) {
            if (whole)
                benchmark::DoNotOptimize(
                    caps.build(d.shape, tolerance, d.cells, {}, policies{certified{}, monotone{}, flat{}, nobody}));
            else
                benchmark::DoNotOptimize(caps.flatten(d.shape, certified{}, tolerance, d.cells).error().code);
        }
        best = (std::min)(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

void run_guarded(benchmark::State& state, const set& s, int passes)
{
    const auto ns_per_point = [&](const std::vector<drawing>& all, const std::vector<polygon>& glyphs) {
        return 1e9 * (draw(all, s.tolerance, true, passes) - draw(all, s.tolerance, false, passes)) /
               static_cast<double>(points_of(glyphs));
    };
    for (auto _ : state) {
        const double guarded = ns_per_point(s.crossing_drawings, s.crossing);
        state.counters["ns_per_point"] = guarded;
        state.counters["of_simple"] = guarded / ns_per_point(s.simple_drawings, s.simple);
    }
}

/// Nanoseconds of processor time for a pass of resolving.
double processor_time(const set& s, cap_builder& caps, workspace& space, triangle_list& out)
{
    for (int passes = 1;; passes *= 2) {
        const std::clock_t start = std::clock();
        for (int i = 0; i < passes; ++i) (void)run_once(s, way::resolve, caps, space, out);
        const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (spent > 0.05) return 1e9 * spent / passes;
    }
}

void run(benchmark::State& state, set& s, way w, int passes)
{
    workspace space;
    cap_builder caps;
    triangle_list out;
    double best = 1e300;
    for (auto _ : state) {
        (void)run_once(s, w, caps, space, out);
        for (int i = 0; i < passes; ++i) best = (std::min)(best, run_once(s, w, caps, space, out));
    }
    if (w == way::simple) s.simple_ns = best;
    state.counters["ns_per_point"] = best;
    if (w == way::resolve) {
        double work = 0;
        for (const polygon& p : s.crossing) {
            p.give(caps.loops());
            resolve_effort effort;
            benchmark::DoNotOptimize(resolve(caps.loops(), fill_rule::non_zero, space, {.effort = &effort}));
            work += effort.pieces * std::log2(effort.pieces + 1.0);
        }
        state.counters["ns_per_log"] = processor_time(s, caps, space, out) / work;
    }
    if (s.simple_ns > 0) state.counters["of_simple"] = best / s.simple_ns;
}

void add(set& s, int passes)
{
    const std::pair<const char*, way> all[] = {{"simple", way::simple},   {"touching", way::touching},
                                               {"all", way::all},         {"refuse", way::refuse},
                                               {"resolve", way::resolve}, {"triangulate", way::triangulate}};
    for (const auto& [name, w] : all) {
        if (s.glyphs(w).empty()) continue;
        benchmark::RegisterBenchmark((s.name + " / " + name).c_str(),
                                     [&s, w = w, passes](benchmark::State& state) { run(state, s, w, passes); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
    if (s.crossing_drawings.empty() || s.simple_drawings.empty()) return;
    benchmark::RegisterBenchmark((s.name + " / guarded").c_str(),
                                 [&s, passes](benchmark::State& state) { run_guarded(state, s, 3 * passes); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

bool glyphs_of(const char* file, double tolerance, std::uint32_t most, set& s)
{
    const std::string path = font_path(file).string();
    auto font = harfbuzz_font::open(path.c_str());
    if (!font) return false;
    outline drawn;
    cap_builder caps;
    const contours& loops = caps.loops();
    std::uint32_t count = 0;
    while (count < 0xFFFF && record(*font, count, drawn).has_value()) ++count;
    const std::uint32_t step = count > most ? count / most : 1;
    for (std::uint32_t g = 0; g < count; g += step) {
        if (!record(*font, g, drawn) || drawn.curves.empty()) continue;
        const auto cells = grid::fitting(font->units_per_em(), drawn.bounds);
        if (!cells || !caps.flatten(drawn, certified{}, tolerance * font->units_per_em(), *cells)) continue;
        if (loops.points.empty()) continue;
        const polygon p{{loops.points.begin(), loops.points.end()},
                        {loops.edges.begin(), loops.edges.end()},
                        {loops.starts.begin(), loops.starts.end()}};
        const auto proven = caps.prove(monotone{});
        (!proven ? s.crossing : proven->is_touching() ? s.touching : s.simple).push_back(p);
        if (!proven || !proven->is_touching()) {
            (!proven ? s.crossing_drawings : s.simple_drawings).push_back({std::move(drawn), *cells});
            drawn = outline{};
        }
    }
    s.tolerance = tolerance * font->units_per_em();
    const auto points = [](const std::vector<polygon>& all) {
        return all.empty() ? 0.0 : static_cast<double>(points_of(all)) / static_cast<double>(all.size());
    };
    std::printf("%s: %zu simple glyphs of %.0f points, %zu that touch in points of %.0f, %zu others of %.0f\n",
                s.name.c_str(), s.simple.size(), points(s.simple), s.touching.size(), points(s.touching),
                s.crossing.size(), points(s.crossing));
    return true;
}

// --- shapes of all sizes -----------------------------------------------------------------------------------------

std::uint64_t next_random(std::uint64_t& state)
{
    std::uint64_t z = state += 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9u;
    return z ^ z >> 27;
}

grid_point on_circle(double radius, double turn)
{
    const double angle = 6.283185307179586 * turn;
    return {static_cast<std::int32_t>(std::lround(radius * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(radius * std::sin(angle)))};
}

polygon from(const std::vector<std::vector<grid_point>>& loops)
{
    polygon p;
    p.starts.push_back(0);
    for (const auto& l : loops) {
        for (const grid_point q : l) {
            p.edges.push_back({static_cast<std::uint32_t>(p.points.size()), 0, 1});
            p.points.push_back(q);
        }
        p.starts.push_back(static_cast<std::uint32_t>(p.points.size()));
    }
    return p;
}

std::vector<grid_point> comb(int n, bool upright)
{
    std::vector<grid_point> l;
    for (int i = 0; i < n / 3; ++i) l.insert(l.end(), {{0, 64 * i}, {0, 64 * i + 32}, {10'000'000, 64 * i + 40}});
    l.push_back({20'000'000, 64 * (n / 3)});
    l.push_back({20'000'000, -1});
    if (upright)
        for (grid_point& p : l) p = {p.y, p.x};
    return l;
}
std::vector<grid_point> star(int n)
{
    std::vector<grid_point> l;
    std::uint64_t seed = 1;
    for (int i = 0; i < n; ++i)
        l.push_back(on_circle(5e7 + 2e8 * static_cast<double>(next_random(seed) >> 11) * 0x1p-53, double(i) / n));
    return l;
}

std::vector<std::pair<const char*, polygon>> shapes(int n)
{
    std::vector<std::pair<const char*, polygon>> all;
    const auto shifted = [](std::vector<grid_point> l, grid_point by) {
        for (grid_point& p : l) p = {p.x + by.x, p.y + by.y};
        return l;
    };
    const auto flat_comb = comb(n / 2, false), upright_comb = comb(n / 2, true), sun = star(n / 2);
    all.emplace_back("comb, its first point pulled across", from({comb(n, false)}));
    all.back().second.points[0] = {100, 1000};
    all.emplace_back("comb, doubled", from({flat_comb, flat_comb}));
    all.emplace_back("comb, doubled and shifted", from({flat_comb, shifted(flat_comb, {1001, 13})}));
    all.emplace_back("upright comb, doubled and shifted", from({upright_comb, shifted(upright_comb, {13, 1001})}));
    all.emplace_back("star, doubled", from({sun, sun}));
    all.emplace_back("star, doubled and shifted", from({sun, shifted(sun, {20'000, 30'000})}));
    all.emplace_back("random star, corners exchanged", from({star(n)}));
    for (std::size_t i = 2; i < all.back().second.points.size(); i += 3)
        std::swap(all.back().second.points[i], all.back().second.points[i - 1]);
    std::vector<std::vector<grid_point>> fans;  // of long, nearly parallel edges from two points side by side
    for (int i = 0; i < n / 6; ++i) {
        if (i % 8 == 0) fans.resize(fans.size() + 2);
        for (int side = 0; side < 2; ++side) {
            const int foot = 400 * (i / 8) + side, end = 32 * i - 8 * side;
            auto& fan = fans[fans.size() - 2 + std::size_t(side)];
            fan.insert(fan.end(), {{0, foot}, {200'000'000, end}, {200'000'000, end + 16}});
        }
    }
    all.emplace_back("fans of nearly parallel edges", from(fans));
    std::vector<grid_point> pinwheel;
    for (int i = 0; i < n / 3; ++i)
        pinwheel.insert(pinwheel.end(), {{0, 0}, on_circle(2e8, 3.0 * i / n), on_circle(2e8, 3.0 * (i + 0.5) / n)});
    all.emplace_back("pinwheel", from({pinwheel}));
    std::vector<std::vector<grid_point>> chain;
    for (int i = 0; i < n / 16; ++i) {
        chain.emplace_back();
        for (int k = 0; k < 16; ++k)
            chain.back().push_back(shifted({on_circle(1000, k / 16.0)}, {1500 * (i % 100), 1500 * (i / 100)})[0]);
    }
    all.emplace_back("overlapping discs", from(chain));

    // Long edges that run together. A knot on a tiny grid beside some of them asks for snap rounding of the whole.
    std::vector<grid_point> knot;
    std::uint64_t seed = 7;
    const auto roll = [&seed](int count) { return static_cast<std::int32_t>(next_random(seed) % unsigned(count)); };
    for (int i = 0; i < 40; ++i) knot.push_back({-3000 + (i % 2) * 2900 + roll(3), -3000 + (i % 2) * 1000 + roll(3)});
    std::vector<grid_point> slanted;
    for (int i = 0; i < n / 3; ++i)
        slanted.insert(slanted.end(), {{4 * i, 0}, {4 * i + 2, 0}, {100'000'000 + 4 * i, 100'000'000}});
    slanted.push_back({4 * n, 200'000'000});
    slanted.push_back({4 * n, -1});
    all.emplace_back("slanted comb and a knot", from({slanted, knot}));
    for (const int apart : {1, 4}) {
        std::vector<grid_point> strip;
        for (int i = 0; i < n / 2; ++i)
            strip.insert(strip.end(), {{roll(4), apart * i + roll(3)}, {200'000'000 + roll(4), apart * i + roll(3)}});
        all.emplace_back(apart == 1 ? "strip of long edges, 1 cell apart" : "strip of long edges, 4 cells apart",
                         from({strip}));
    }
    std::vector<grid_point> chords;  // each leaps by a few corners, so that k grows with n
    for (int i = 0; i < n; ++i) chords.push_back(on_circle(2e8, (double(i) + double(roll(8))) / n));
    all.emplace_back("chords of a circle", from({chords}));
    return all;
}

}  // namespace

int main(int argc, char** argv)
{
    struct font_set {
        const char* name;
        const char* file;
        double tolerance;  ///< em
    };
    const font_set fonts[] = {
        {"Inter variable, low", "truetype/inter-vf/Inter.var.ttf", quality::low},
        {"Inter variable, high", "truetype/inter-vf/Inter.var.ttf", quality::high},
        {"Amiri, high", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf", quality::high},
        {"Noto Sans CJK, high", "opentype/noto/NotoSansCJK-Regular.ttc", quality::high},
        {"Noto Serif CJK Bold, high", "opentype/noto/NotoSerifCJK-Bold.ttc", quality::high},
        {"WenQuanYi Micro Hei, high", "truetype/wqy/wqy-microhei.ttc", quality::high},
        {"Liberation Sans, high", "truetype/liberation/LiberationSans-Regular.ttf", quality::high},
    };
    std::vector<set> sets;
    sets.reserve(100);
    for (const font_set& f : fonts) {
        sets.push_back({f.name, {}, {}, {}});
        if (!glyphs_of(f.file, f.tolerance, 10'000, sets.back())) {
            std::fprintf(stderr, "left out, no such font: %s\n", f.file);
            sets.pop_back();
            continue;
        }
        add(sets.back(), 5);
    }
    for (int n = 100; n <= 100'000; n *= 10) {
        for (auto& [name, p] : shapes(n)) {
            sets.push_back({std::string{name} + " of " + std::to_string(n), {}, {}, {}});
            sets.back().crossing.push_back(std::move(p));
            add(sets.back(), n < 10'000 ? 5 : 1);
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
