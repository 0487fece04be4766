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

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <benchmark/benchmark.h>
#include <hb.h>

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

// --- glyphs as polygons ------------------------------------------------------------------------------------------

using polygon = std::vector<std::vector<grid_point>>;

struct flattener {
    double tolerance;
    polygon loops;
    point at;
    grid cells;

    void add(point p)
    {
        const grid_point g = cells.snap(p);
        if (loops.back().empty() || !(loops.back().back() == g)) loops.back().push_back(g);
    }
    static point of(float x, float y) { return {double{x}, double{y}}; }
    static flattener& self(void* data) { return *static_cast<flattener*>(data); }

    void move(point p)
    {
        loops.emplace_back();
        add(at = p);
    }
    void line(point p) { add(at = p); }
    void quadratic_to(point b, point c)
    {
        const quadratic q{at, b, c};
        const int n =
            (std::max)(1, static_cast<int>(std::ceil(std::sqrt(length(q.p0 - 2.0 * b + c) / (4.0 * tolerance)))));
        for (int i = 1; i <= n; ++i) add(i == n ? c : q.at(double(i) / n));
        at = c;
    }
    void cubic_to(point b, point c, point d)
    {
        const cubic q{at, b, c, d};
        const double bend = (std::max)(length(q.p0 - 2.0 * b + c), length(b - 2.0 * c + d));
        const int n = (std::max)(1, static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance))));
        for (int i = 1; i <= n; ++i) add(i == n ? d : q.at(double(i) / n));
        at = d;
    }
    void close()
    {
        while (loops.back().size() > 1 && loops.back().back() == loops.back().front()) loops.back().pop_back();
        if (loops.back().size() < 3) loops.pop_back();
    }
};

hb_draw_funcs_t* drawing()
{
    hb_draw_funcs_t* f = hb_draw_funcs_create();
    hb_draw_funcs_set_move_to_func(
        f,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float y, void*) {
            flattener::self(d).move(flattener::of(x, y));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(
        f,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float y, void*) {
            flattener::self(d).line(flattener::of(x, y));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_quadratic_to_func(
        f,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float a, float b, float x, float y, void*) {
            flattener::self(d).quadratic_to(flattener::of(a, b), flattener::of(x, y));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(
        f,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float a, float b, float p, float q, float x, float y, void*) {
            flattener::self(d).cubic_to(flattener::of(a, b), flattener::of(p, q), flattener::of(x, y));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_close_path_func(
        f, [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, void*) { flattener::self(d).close(); }, nullptr, nullptr);
    hb_draw_funcs_make_immutable(f);
    return f;
}

std::vector<polygon> glyphs_of(const char* file, double tolerance, unsigned most)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    const std::string path = std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + file;
    hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
    hb_face_t* face = hb_face_create(blob, 0);
    hb_font_t* font = hb_font_create(face);
    const auto scale = static_cast<int>(hb_face_get_upem(face));
    hb_font_set_scale(font, scale, scale);
    hb_draw_funcs_t* draw = drawing();
    std::vector<polygon> all;
    const unsigned count = hb_face_get_glyph_count(face), step = count > most ? count / most : 1;
    for (unsigned g = 0; g < count; g += step) {
        flattener f{tolerance, {}, {}, {}};
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font, g, draw, &f);
#else
        hb_font_get_glyph_shape(font, g, draw, &f);
#endif
        if (!f.loops.empty()) all.push_back(std::move(f.loops));
    }
    hb_draw_funcs_destroy(draw);
    hb_font_destroy(font);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return all;
}

contours contours_of(const polygon& loops)
{
    contours c;
    bool fits = c.starts.push_back(0);
    for (const auto& l : loops) {
        for (const grid_point p : l) fits = fits && c.points.push_back(p) && c.edges.push_back({0, 0.0f, 1.0f});
        fits = fits && c.starts.push_back(static_cast<std::uint32_t>(c.points.size()));
    }
    if (!fits) std::abort();
    return c;
}

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

// --- shapes of all sizes -----------------------------------------------------------------------------------------

std::uint64_t next_random(std::uint64_t& state)
{
    std::uint64_t z = state += 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9u;
    return z ^ z >> 27;
}

grid_point on_circle(double cx, double cy, double radius, double turn)
{
    const double angle = 6.283185307179586 * turn;
    return {static_cast<std::int32_t>(std::lround(cx + radius * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(cy + radius * std::sin(angle)))};
}

polygon circle(int n)
{
    polygon p(1);
    for (int i = 0; i < n; ++i) p[0].push_back(on_circle(0, 0, 2.5e8, double(i) / n));
    return p;
}
polygon comb(int n)  // all teeth begin in one column
{
    polygon p(1);
    for (int i = 0; i < n / 3; ++i) p[0].insert(p[0].end(), {{0, 64 * i}, {0, 64 * i + 32}, {10'000'000, 64 * i + 40}});
    p[0].push_back({20'000'000, 64 * (n / 3)});
    p[0].push_back({20'000'000, -1});
    std::reverse(p[0].begin(), p[0].end());
    return p;
}
polygon spiral(int n)
{
    polygon p(1);
    const double turns = std::sqrt(n / 20.0), step = 2e8 / turns;
    for (int i = 0; i <= n / 2; ++i)
        p[0].push_back(on_circle(0, 0, step * (0.5 + turns * i / (n / 2)), turns * i / (n / 2)));
    for (int i = n / 2; i >= 0; --i)
        p[0].push_back(on_circle(0, 0, step * (0.8 + turns * i / (n / 2)), turns * i / (n / 2)));
    std::reverse(p[0].begin(), p[0].end());
    return p;
}
polygon star(int n)
{
    polygon p(1);
    std::uint64_t seed = 1;
    for (int i = 0; i < n; ++i)
        p[0].push_back(
            on_circle(0, 0, 5e7 + 2e8 * static_cast<double>(next_random(seed) >> 11) * 0x1p-53, double(i) / n));
    return p;
}
polygon parabola(int n, bool upwards)
{
    polygon p(1);
    const double half = n / 2;
    for (int i = 0; i < n; ++i) {
        const double x = (i - half) / half;
        p[0].push_back(
            {static_cast<std::int32_t>(std::lround(2.5e8 * x)), static_cast<std::int32_t>(std::lround(2.5e8 * x * x))});
    }
    if (!upwards)
        for (grid_point& q : p[0]) q = {-q.y, q.x};
    return p;
}
polygon square_with_holes(int n)
{
    const int rows = (std::max)(1, static_cast<int>(std::sqrt(n / 16.0)));
    const std::int32_t pitch = 2000, side = pitch * rows;
    polygon p{{{0, 0}, {side, 0}, {side, side}, {0, side}}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rows; ++x) {
            p.emplace_back();
            for (int i = 16; i-- != 0;)
                p.back().push_back(on_circle((x + 0.5) * pitch, (y + 0.5) * pitch, 0.4 * pitch, i / 16.0));
        }
    return p;
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
    sets.reserve(100);
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
        const std::pair<const char*, polygon> shapes[] = {{"circle", circle(n)},
                                                          {"comb", comb(n)},
                                                          {"spiral", spiral(n)},
                                                          {"star", star(n)},
                                                          {"square with holes", square_with_holes(n)},
                                                          {"parabola", parabola(n, true)},
                                                          {"parabola on its side", parabola(n, false)}};
        for (const auto& [name, p] : shapes) {
            set s{std::string{name} + " of " + std::to_string(n), {}, {}, 0, 0};
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
