// SPDX-License-Identifier: MIT
#pragma once

// What benchmarks triangulate: all glyphs of a font, flattened by equal steps of t and snapped to 1/512 unit, and shapes of any size.
// Fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts).

#include "../tests/support/font_path.hpp"

#include <typemesh/core/contours.hpp>

#include <hb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using namespace typemesh;

// --- glyphs as polygons ----------------------------------------------------------------------------------------------------

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

inline hb_draw_funcs_t* drawing()
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

inline std::vector<polygon> glyphs_of(const char* file, double tolerance, unsigned most)
{
    const std::string path = font_path(file).string();
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

inline contours contours_of(const polygon& loops)
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

// --- shapes of all sizes ---------------------------------------------------------------------------------------------------

inline std::uint64_t next_random(std::uint64_t& state)
{
    std::uint64_t z = state += 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9u;
    return z ^ z >> 27;
}

inline grid_point on_circle(double cx, double cy, double radius, double turn)
{
    const double angle = 6.283185307179586 * turn;
    return {static_cast<std::int32_t>(std::lround(cx + radius * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(cy + radius * std::sin(angle)))};
}

inline polygon circle(int n)
{
    polygon p(1);
    for (int i = 0; i < n; ++i) p[0].push_back(on_circle(0, 0, 2.5e8, double(i) / n));
    return p;
}
inline polygon comb(int n)  // all teeth begin in one column
{
    polygon p(1);
    for (int i = 0; i < n / 3; ++i) p[0].insert(p[0].end(), {{0, 64 * i}, {0, 64 * i + 32}, {10'000'000, 64 * i + 40}});
    p[0].push_back({20'000'000, 64 * (n / 3)});
    p[0].push_back({20'000'000, -1});
    std::reverse(p[0].begin(), p[0].end());
    return p;
}
inline polygon spiral(int n)
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
inline polygon star(int n)
{
    polygon p(1);
    std::uint64_t seed = 1;
    for (int i = 0; i < n; ++i)
        p[0].push_back(
            on_circle(0, 0, 5e7 + 2e8 * static_cast<double>(next_random(seed) >> 11) * 0x1p-53, double(i) / n));
    return p;
}
inline polygon parabola(int n, bool upwards)
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
inline polygon square_with_holes(int n)
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

/// A fine circle with a ring of 16-gons in it.
inline polygon circle_with_holes(int n)
{
    polygon p = circle(n / 2);
    const int holes = (std::max)(1, n / 32);
    const double radius = (std::min)(4e7, 5e8 / holes);
    for (int i = 0; i < holes; ++i) {
        const grid_point c = on_circle(0, 0, 2e8, double(i) / holes);
        p.emplace_back();
        for (int k = 16; k-- != 0;) p.back().push_back(on_circle(c.x, c.y, radius, k / 16.0));
    }
    return p;
}

/// Every other point of a parabola moved, so that nothing is smooth.
inline polygon rough_parabola(int n, bool upwards)
{
    polygon p = parabola(n, true);
    const std::int32_t step = 250'000'000 / n;
    for (std::size_t i = 2; i + 2 < p[0].size(); i += 2) p[0][i].y += step;
    if (!upwards)
        for (grid_point& q : p[0]) q = {-q.y, q.x};
    return p;
}

/// Two parabolas that bend towards each other: every joint between them is one of two convex chains.
inline polygon facing_parabolas(int n)
{
    polygon p(1);
    const auto bow = [&](int i) {
        const double x = 4.0 * i / n - 1.0;
        return static_cast<std::int32_t>(std::lround(1e8 * x * x));
    };
    const std::int32_t step = 500'000'000 / n;
    for (int i = 0; i < n / 2; ++i) p[0].push_back({step * i, -bow(i)});
    for (int i = n / 2; i-- != 0;) p[0].push_back({step * i + step / 2, 50'000'000 + bow(i)});
    return p;
}

/// Two chains from left to right whose points jump up and down.
inline polygon random_monotone(int n)
{
    polygon p(1);
    std::uint64_t seed = 2;
    const auto height = [&] { return 1 + static_cast<std::int32_t>(next_random(seed) >> 38); };
    const std::int32_t step = 500'000'000 / n;
    for (int i = 0; i < n / 2; ++i) p[0].push_back({step * i, -height()});
    for (int i = n / 2; i-- != 0;) p[0].push_back({step * i + step / 2, height()});
    return p;
}

/// Teeth as high as the whole is long, on an edge that is cut as often as there are teeth.
inline polygon sawtooth(int n)
{
    polygon p(1);
    const int teeth = n / 3;
    for (int i = 0; i < teeth; ++i) p[0].push_back({100 * i + i % 7, -50});
    p[0].push_back({100 * teeth, -50});
    for (int i = teeth; i-- != 0;) {
        p[0].push_back({100 * i + 50, 100 * teeth});
        p[0].push_back({100 * i, i % 3});
    }
    return p;
}

inline polygon nested_squares(int n)
{
    polygon p;
    const int depth = (std::max)(1, n / 4);
    for (int i = 0; i < depth; ++i) {
        const std::int32_t low = 10 * i, high = 10 * (2 * depth - i);
        p.push_back({{low, low}, {high, low}, {high, high}, {low, high}});
        if (i % 2 == 1) std::reverse(p.back().begin(), p.back().end());
    }
    return p;
}

/// A random polygon: around a random tree on a square of n / 4 cells, with each corner moved at random.
inline polygon maze(int n)
{
    const int side = (std::max)(1, static_cast<int>(std::sqrt(n / 4.0))), pitch = 250'000'000 / side;
    constexpr int across[] = {0, 1, 0, -1}, along[] = {-1, 0, 1, 0};  // south, east, north, west
    std::vector<unsigned> open(static_cast<std::size_t>(side * side), 0u);
    std::uint64_t seed = 3;
    std::vector<int> path{0};
    for (open[0] = 16; !path.empty();) {
        const int at = path.back();
        int next = -1, free = 0, wall = 0;
        for (int w = 0; w < 4; ++w) {
            const int x = at % side + across[w], y = at / side + along[w];
            if (x < 0 || y < 0 || x >= side || y >= side || open[static_cast<std::size_t>(y * side + x)] != 0) continue;
            if (next_random(seed) % static_cast<unsigned>(++free) == 0) next = y * side + x, wall = w;
        }
        if (next < 0) {
            path.pop_back();
            continue;
        }
        open[static_cast<std::size_t>(at)] |= 1u << wall;
        open[static_cast<std::size_t>(next)] |= 16u | 1u << (wall ^ 2);
        path.push_back(next);
    }
    polygon p(1);
    const auto moved = [&](double v) {
        return static_cast<std::int32_t>(pitch * (v + 0.25 * (double(next_random(seed) >> 11) * 0x1p-53 - 0.5)));
    };
    int at = 0, corner = 0;  // of a cell: 0 to 3, before the walls of the same numbers
    do {
        const double x = at % side, y = at / side;
        p[0].push_back({moved(x + (corner == 1 || corner == 2 ? 0.75 : 0.25)), moved(y + (corner < 2 ? 0.25 : 0.75))});
        if ((open[static_cast<std::size_t>(at)] >> corner & 1u) != 0) {
            at += across[corner] + side * along[corner];
            corner = (corner + 3) % 4;
        } else {
            corner = (corner + 1) % 4;
        }
    } while (at != 0 || corner != 0);
    return p;
}

/// All shapes, of about n points each.
inline std::vector<std::pair<std::string, polygon>> shapes_of(int n)
{
    return {{"spiral", spiral(n)},
            {"comb", comb(n)},
            {"star", star(n)},
            {"parabola", parabola(n, true)},
            {"parabola on its side", parabola(n, false)},
            {"circle with holes", circle_with_holes(n)},
            {"square with holes", square_with_holes(n)},
            {"rough parabola", rough_parabola(n, true)},
            {"rough parabola on its side", rough_parabola(n, false)},
            {"facing parabolas", facing_parabolas(n)},
            {"random monotone chains", random_monotone(n)},
            {"sawtooth", sawtooth(n)},
            {"nested squares", nested_squares(n)}};
}

}  // namespace bench
