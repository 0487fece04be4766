// SPDX-License-Identifier: MIT
#pragma once

// Shapes that are hard to make Delaunay, and their triangles.

#include "support/delaunay.hpp"
#include "support/regions.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

struct meshed {
    std::string mistake;
    std::vector<oracle::placed_triangle> triangles;
};

/// Fills and triangulates a shape: the triangles as a set, and the first law that they break. Without laws only shapes
/// whose loops do not meet: crossings are rounded to the grid, which turning and scaling change.
inline meshed mesh_of(const shape& s, typemesh::constrained_delaunay how = {}, bool lawful = true)
{
    using namespace typemesh;
    contours loops = contours_of(s);
    workspace space;
    const result<region> filled =
        lawful ? fill(loops, fill_rule::non_zero, space) : nest(loops, fill_rule::non_zero, space);
    if (!filled) return {filled.error() == error::crossing_contours ? "" : filled.error().message(), {}};
    triangle_list out;
    if (const error e = how(*filled, space, out)) return {e.message(), {}};
    meshed m{"", oracle::as_set(filled->points(), out.view())};
    if (lawful) m.mistake = oracle::broken_law(*filled, out.view());
    if (m.mistake.empty()) m.mistake = oracle::broken_delaunay(*filled, out.view());
    return m;
}

/// Points of the grid that lie exactly on one circle, counter-clockwise.
inline polyline on_one_circle(std::int32_t squared_radius, std::int32_t scale)
{
    polyline l;
    const auto reach = static_cast<std::int32_t>(std::sqrt(squared_radius)) + 1;
    for (std::int32_t x = -reach; x <= reach; ++x)
        for (std::int32_t y = -reach; y <= reach; ++y)
            if (x * x + y * y == squared_radius) l.push_back({x * scale, y * scale});
    std::sort(l.begin(), l.end(),
              [](grid_point a, grid_point b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    return l;
}

inline shape lattice(int rows)
{
    shape s{"square lattice of square holes", {}};
    polyline outer;
    const int width = 20 * rows;
    for (int i = 0; i < width; i += 10) outer.push_back({i, 0});
    for (int i = 0; i < width; i += 10) outer.push_back({width, i});
    for (int i = width; i > 0; i -= 10) outer.push_back({i, width});
    for (int i = width; i > 0; i -= 10) outer.push_back({0, i});
    s.loops.push_back(outer);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rows; ++x) s.loops.push_back(reversed(square(20 * x + 5, 20 * y + 5, 10)));
    return s;
}

inline polyline parabola(int n, bool upwards)
{
    polyline l;
    for (int i = 0; i < n; ++i) {
        const double x = 2.0 * i / (n - 1) - 1.0;
        l.push_back({static_cast<std::int32_t>(std::lround(0x1p27 * x)),
                     static_cast<std::int32_t>(std::lround(0x1p27 * x * x))});
    }
    if (!upwards)
        for (grid_point& p : l) p = {-p.y, p.x};
    return l;
}

/// The same parabola with every other point moved, so that nothing is smooth.
inline polyline rough_parabola(int n, bool upwards)
{
    polyline l = parabola(n, upwards);
    const std::int32_t step = (1 << 28) / n;
    for (std::size_t i = 2; i + 2 < l.size(); i += 2) (upwards ? l[i].y : l[i].x) += (upwards ? 1 : -1) * step;
    return l;
}

/// Two parabolas that bend towards each other, or away: every joint between the two is between two convex chains.
inline polyline facing_parabolas(int n, bool towards)
{
    polyline l;
    const auto bow = [&](int i) {
        const double x = 4.0 * i / n - 1.0;
        return static_cast<std::int32_t>(std::lround(0x1p25 * x * x));
    };
    for (int i = 0; i < n / 2; ++i) l.push_back({(1 << 27) / n * i, towards ? -bow(i) : bow(i)});
    for (int i = n / 2; i-- != 0;) l.push_back({(1 << 27) / n * i + 3, (1 << 27) + (towards ? bow(i) : -bow(i))});
    return l;
}

/// Two chains from left to right whose points jump up and down, never as far as the middle.
inline polyline random_monotone(int n, std::uint64_t seed)
{
    dice d{seed};
    polyline l;
    for (int i = 0; i < n / 2; ++i) l.push_back({1000 * i, -1 - d.roll(1 << 26)});
    for (int i = n / 2; i-- != 0;) l.push_back({1000 * i + d.roll(999), 1 + d.roll(1 << 26)});
    return l;
}

/// Teeth as high as the whole is long, on one long edge or on an edge that is cut as well.
inline polyline sawtooth(int teeth, bool cut)
{
    polyline l{{0, -50}};
    for (int i = cut ? 1 : teeth; i < teeth; ++i) l.push_back({100 * i + i % 7, -50});
    l.push_back({100 * teeth, -50});
    for (int i = teeth; i-- != 0;) {
        l.push_back({100 * i + 50, 100 * teeth});
        l.push_back({100 * i, i % 3});
    }
    return l;
}

/// Squares that meet at their corners, as on a chess board: hundreds of points that boundaries pass through twice.
inline shape chess_board(int rows)
{
    shape s{"chess board of " + std::to_string(rows), {}};
    for (int y = 0; y < rows; ++y)
        for (int x = y % 2; x < rows; x += 2) s.loops.push_back(square(40 * x, 40 * y, 40));
    return s;
}

inline std::vector<shape> delaunay_shapes()
{
    std::vector<shape> all = generated_regions();
    all.push_back(lattice(1));
    all.push_back(lattice(6));
    all.push_back({"12 points on a circle", {on_one_circle(25, 1000)}});
    all.push_back({"36 points on a circle", {on_one_circle(5525, 100)}});
    all.push_back({"ring of points on two circles", {on_one_circle(5525, 8), reversed(on_one_circle(325, 16))}});
    all.push_back({"parabola", {parabola(500, true)}});
    all.push_back({"parabola on its side", {parabola(500, false)}});
    all.push_back({"rough parabola", {rough_parabola(1500, true)}});
    all.push_back({"rough parabola on its side", {rough_parabola(1500, false)}});
    all.push_back({"fine ring", {circle(2000, 1e8), reversed(circle(1500, 9e7))}});
    all.push_back({"thin fine ring", {circle(2000, 1e8), reversed(circle(1500, 9.99e7))}});
    all.push_back({"parabolas that bend towards each other", {facing_parabolas(600, true)}});
    all.push_back({"parabolas that bend away from each other", {facing_parabolas(600, false)}});
    all.push_back({"random monotone chains", {random_monotone(700, 3)}});
    all.push_back({"sawtooth", {sawtooth(200, false)}});
    all.push_back({"sawtooth on a cut edge", {sawtooth(200, true)}});
    return all;
}

}  // namespace test
