// SPDX-License-Identifier: MIT
#pragma once

// Shapes built by hand, and their triangles by the plainest of methods: so that the tests of extruders rest on no other
// stage.

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace shapes {

using namespace typemesh;

inline curve line(point a, point b) { return curve::from(a, b); }
inline curve quad(point a, point b, point c) { return curve::from(quadratic{a, b, c}); }
inline curve cube(point a, point b, point c, point d) { return curve::from(cubic{a, b, c, d}); }

/// A region with its curves, each cut into `pieces` edges at equal steps of t.
class shape {
public:
    std::string name;
    std::vector<curve> curves;
    contours loops;
    std::vector<triangle> cap;

    /// Outer contours first. A contour whose area has the wrong sign is turned.
    shape(std::string n, std::vector<std::vector<curve>> outers, std::vector<std::vector<curve>> holes = {},
          int pieces = 4)
        : name{std::move(n)},
          holes_{static_cast<std::uint32_t>(holes.size())},
          outers_{static_cast<std::uint32_t>(outers.size())}
    {
        loops.grid.units_per_em = 1000.0;
        push(loops.starts, 0u);
        for (const auto& c : outers) add(c, pieces, true);
        for (const auto& c : holes) add(c, pieces, false);
        loops.curves = curves;
        cap = greedy_triangles();
    }

    region made() const { return region::proven(loops, holes_, outers_); }
    std::uint32_t points() const { return static_cast<std::uint32_t>(loops.points.size()); }
    std::uint32_t contour_count() const { return loops.contour_count(); }

    /// The next point of the same contour.
    std::uint32_t next(std::uint32_t i) const
    {
        for (std::uint32_t k = 0; k < contour_count(); ++k) {
            if (i + 1 == loops.starts[k + 1]) return loops.starts[k];
        }
        return i + 1;
    }
    std::uint32_t previous(std::uint32_t i) const
    {
        for (std::uint32_t k = 0; k < contour_count(); ++k) {
            if (i == loops.starts[k]) return loops.starts[k + 1] - 1;
        }
        return i - 1;
    }

private:
    template <class T>
    static void push(buffer<T>& b, T value)
    {
        if (!b.push_back(value)) std::abort();
    }

    void add(const std::vector<curve>& contour, int pieces, bool outer)
    {
        std::vector<grid_point> points;
        std::vector<contour_edge> edges;
        for (const curve& c : contour) {
            const int n = c.degree == 1 ? 1 : pieces;
            for (int i = 0; i < n; ++i) {
                const float t0 = static_cast<float>(i) / static_cast<float>(n),
                            t1 = static_cast<float>(i + 1) / static_cast<float>(n);
                points.push_back(loops.grid.snap(c.at(t0)));
                edges.push_back({static_cast<std::uint32_t>(curves.size()), t0, t1});
            }
            curves.push_back(c);
        }
        double area = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const grid_point a = points[i], b = points[(i + 1) % points.size()];
            area += double(a.x) * b.y - double(a.y) * b.x;
        }
        if ((area > 0.0) != outer) {
            const std::size_t n = points.size();
            std::vector<grid_point> turned_points;
            std::vector<contour_edge> turned_edges;
            for (std::size_t i = 0; i < n; ++i) {
                turned_points.push_back(points[(n - i) % n]);
                const contour_edge e = edges[n - 1 - i];
                turned_edges.push_back({e.curve, e.t1, e.t0});
            }
            points = turned_points;
            edges = turned_edges;
        }
        for (const auto p : points) push(loops.points, p);
        for (const auto e : edges) push(loops.edges, e);
        push(loops.starts, static_cast<std::uint32_t>(loops.points.size()));
    }

    static bool cross_or_touch(grid_point a, grid_point b, grid_point c, grid_point d)
    {
        const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
        const auto on = [](grid_point p, grid_point q, grid_point r) {
            return orientation(p, q, r) == 0 && (std::min)(p.x, q.x) <= r.x && r.x <= (std::max)(p.x, q.x) &&
                   (std::min)(p.y, q.y) <= r.y && r.y <= (std::max)(p.y, q.y);
        };
        if (sign(orientation(a, b, c)) * sign(orientation(a, b, d)) < 0 &&
            sign(orientation(c, d, a)) * sign(orientation(c, d, b)) < 0)
            return true;
        return (!(c == a) && !(c == b) && on(a, b, c)) || (!(d == a) && !(d == b) && on(a, b, d)) ||
               (!(a == c) && !(a == d) && on(c, d, a)) || (!(b == c) && !(b == d) && on(c, d, b));
    }

    /// Whether the ray from point i to `to` starts inside the region.
    bool leaves_inside(std::uint32_t i, grid_point to) const
    {
        const grid_point p = loops.points[i], before = loops.points[previous(i)], after = loops.points[next(i)];
        if (orientation(before, p, after) > 0) return orientation(p, after, to) > 0 && orientation(before, p, to) > 0;
        return !(orientation(p, after, to) <= 0 && orientation(before, p, to) <= 0);
    }

    std::vector<triangle> greedy_triangles() const
    {
        const std::uint32_t n = points();
        std::vector<std::vector<bool>> joined(n, std::vector<bool>(n));
        std::vector<std::array<std::uint32_t, 2>> lines, inner;
        for (std::uint32_t i = 0; i < n; ++i) {
            lines.push_back({i, next(i)});
            joined[i][next(i)] = joined[next(i)][i] = true;
        }
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = i + 1; j < n; ++j) {
                const grid_point a = loops.points[i], b = loops.points[j];
                if (joined[i][j] || !leaves_inside(i, b) || !leaves_inside(j, a)) continue;
                bool free = true;
                for (const auto& l : lines)
                    free = free && !cross_or_touch(a, b, loops.points[l[0]], loops.points[l[1]]);
                if (!free) continue;
                lines.push_back({i, j});
                inner.push_back({i, j});
                joined[i][j] = joined[j][i] = true;
            }
        std::vector<triangle> found;
        const auto face = [&](std::uint32_t a, std::uint32_t b) {
            std::uint32_t best = n;
            std::int64_t least = 0;
            for (std::uint32_t c = 0; c < n; ++c) {
                const std::int64_t area = orientation(loops.points[a], loops.points[b], loops.points[c]);
                if (!joined[a][c] || !joined[b][c] || area <= 0 || (best != n && area >= least)) continue;
                best = c;
                least = area;
            }
            if (best == n) std::abort();
            if (a < b && a < best)
                found.push_back({a, b, best});
            else if (b < a && b < best)
                found.push_back({b, best, a});
            else
                found.push_back({best, a, b});
        };
        for (std::uint32_t i = 0; i < n; ++i) face(i, next(i));
        for (const auto& d : inner) {
            face(d[0], d[1]);
            face(d[1], d[0]);
        }
        std::vector<triangle> once;
        for (const triangle& t : found) {
            bool seen = false;
            for (const triangle& o : once) seen = seen || o == t;
            if (!seen) once.push_back(t);
        }
        return once;
    }

    std::uint32_t holes_;
    std::uint32_t outers_;
};

inline std::vector<curve> polygon(std::vector<point> p)
{
    std::vector<curve> c;
    for (std::size_t i = 0; i < p.size(); ++i) c.push_back(line(p[i], p[(i + 1) % p.size()]));
    return c;
}

/// Four cubics, the usual circle: off by 0.027 % of its radius.
inline std::vector<curve> cubic_circle(point m, double r)
{
    const double k = 0.5522847498307936 * r;
    return {cube({m.x + r, m.y}, {m.x + r, m.y + k}, {m.x + k, m.y + r}, {m.x, m.y + r}),
            cube({m.x, m.y + r}, {m.x - k, m.y + r}, {m.x - r, m.y + k}, {m.x - r, m.y}),
            cube({m.x - r, m.y}, {m.x - r, m.y - k}, {m.x - k, m.y - r}, {m.x, m.y - r}),
            cube({m.x, m.y - r}, {m.x + k, m.y - r}, {m.x + r, m.y - k}, {m.x + r, m.y})};
}

/// Eight quadratics through the circle, tangent to it in their ends.
inline std::vector<curve> quadratic_circle(point m, double r)
{
    std::vector<curve> c;
    const double step = 3.14159265358979323846 / 4.0, out = r / std::cos(step / 2.0);
    for (int i = 0; i < 8; ++i) {
        const auto at = [&](double angle, double radius) {
            return point{m.x + radius * std::cos(angle), m.y + radius * std::sin(angle)};
        };
        c.push_back(quad(at(i * step, r), at((i + 0.5) * step, out), at((i + 1) * step, r)));
    }
    return c;
}

/// Four tips, and four corners turned inwards between them.
inline shape star()
{
    return {"star",
            {polygon({{0, 0}, {250, 100}, {500, 0}, {400, 250}, {500, 500}, {250, 400}, {0, 500}, {100, 250}})}};
}

/// A corner of 7 degrees.
inline shape spike() { return {"spike", {polygon({{0, 0}, {800, 0}, {800, 100}})}}; }

/// A notch with its tip inside the letter.
inline shape notch()
{
    return {"notch", {polygon({{0, 0}, {600, 0}, {600, 600}, {330, 600}, {300, 200}, {270, 600}, {0, 600}})}};
}

/// The area that contours enclose, in cells.
inline double area_of(const contours& loops)
{
    double twice = 0.0;
    for (std::uint32_t k = 0; k < loops.contour_count(); ++k)
        for (std::uint32_t i = loops.starts[k], end = loops.starts[k + 1]; i < end; ++i) {
            const grid_point a = loops.points[i], b = loops.points[i + 1 == end ? loops.starts[k] : i + 1];
            twice += double(a.x) * b.y - double(a.y) * b.x;
        }
    return twice / 2.0;
}

inline shape rectangle() { return {"rectangle", {polygon({{100, 0}, {500, 0}, {500, 700}, {100, 700}})}}; }

inline shape letter_e()
{
    const std::vector<point> corners{{0, 0},     {600, 0},   {600, 100}, {120, 100}, {120, 300}, {500, 300},
                                     {500, 400}, {120, 400}, {120, 600}, {600, 600}, {600, 700}, {0, 700}};
    return {"E", {polygon(corners)}};
}

/// Outer contour of cubics, hole of quadratics; both given counter-clockwise, so the hole is turned.
inline shape ring(int pieces = 4)
{
    return {"ring", {cubic_circle({400, 300}, 300)}, {quadratic_circle({400, 300}, 150)}, pieces};
}

/// A stem with a bowl: lines that run softly into curves, four corners, a hole with two corners.
inline shape letter_d(int pieces = 4)
{
    const double k = 0.5522847498307936;
    const auto bowl = [k](double x0, double x1, double y0, double r) {
        return std::vector<curve>{
            line({x0, y0}, {x1, y0}), cube({x1, y0}, {x1 + k * r, y0}, {x1 + r, y0 + r - k * r}, {x1 + r, y0 + r}),
            cube({x1 + r, y0 + r}, {x1 + r, y0 + r + k * r}, {x1 + k * r, y0 + 2 * r}, {x1, y0 + 2 * r}),
            line({x1, y0 + 2 * r}, {x0, y0 + 2 * r}), line({x0, y0 + 2 * r}, {x0, y0})};
    };
    return {"D", {bowl(0, 300, 0, 350)}, {bowl(100, 300, 100, 250)}, pieces};
}

/// A ribbon of two cubics, given clockwise, so that edges run against their curves.
inline shape ribbon(int pieces = 6)
{
    return {"S",
            {{line({0, 0}, {0, 100}), cube({0, 100}, {300, 500}, {300, -300}, {600, 100}), line({600, 100}, {600, 0}),
              cube({600, 0}, {300, -400}, {300, 400}, {0, 0})}},
            {},
            pieces};
}

/// A cubic with an exact cusp at t = 1/2, over a line.
inline shape cusp() { return {"cusp", {{cube({0, 0}, {1000, 1000}, {0, 1000}, {1000, 0}), line({1000, 0}, {0, 0})}}}; }

/// One cubic that ends where it starts, with a corner there.
inline shape drop(int pieces = 8) { return {"drop", {{cube({0, 0}, {600, 500}, {-600, 500}, {0, 0})}}, {}, pieces}; }

/// Two outer contours, one with a hole.
inline shape pair(int pieces = 3)
{
    return {"pair",
            {polygon({{0, 0}, {200, 0}, {100, 180}}), cubic_circle({600, 200}, 200)},
            {polygon({{550, 150}, {550, 250}, {650, 250}, {650, 150}})},
            pieces};
}

/// Shapes, moved into a vector: they cannot be copied.
template <class... Shapes>
std::vector<shape> several(Shapes... s)
{
    std::vector<shape> all;
    (all.push_back(std::move(s)), ...);
    return all;
}

inline std::vector<shape> all()
{
    return several(rectangle(), letter_e(), ring(), letter_d(), ribbon(), cusp(), drop(), pair());
}

}  // namespace shapes
