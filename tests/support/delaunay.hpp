// SPDX-License-Identifier: MIT
#pragma once

// Whether triangles are Delaunay, judged edge by edge with numbers of 128 bits: the textbook determinant, not the library's.

#include "support/regions.hpp"

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace test::oracle {

__extension__ using int128 = __int128;

/// 1: d lies inside the circle through a, b, c, which turn counter-clockwise; 0: on it; -1: outside.
inline int circle_side(grid_point a, grid_point b, grid_point c, grid_point d)
{
    const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y, bx = std::int64_t{b.x} - d.x,
                       by = std::int64_t{b.y} - d.y;
    const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
    const int128 determinant = int128{ax * ax + ay * ay} * (bx * cy - by * cx) -
                               int128{bx * bx + by * by} * (ax * cy - ay * cx) +
                               int128{cx * cx + cy * cy} * (ax * by - ay * bx);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

inline bool comes_first(grid_point a, grid_point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// What keeps triangles that obey all laws from being the Delaunay ones; empty when nothing does. Among points on one circle the
/// diagonal must leave the smallest.
inline std::string broken_delaunay(const typemesh::region& r, std::span<const typemesh::triangle> triangles)
{
    const auto points = r.points();
    struct side_of_edge {
        std::uint64_t edge;  // both ends, the smaller one first
        std::uint32_t apex;
    };
    std::vector<side_of_edge> sides;
    sides.reserve(3 * triangles.size());
    const auto add = [&](std::uint64_t p, std::uint64_t q, std::uint32_t apex) {
        sides.push_back({(std::min)(p, q) << 32 | (std::max)(p, q), apex});
    };
    for (const typemesh::triangle t : triangles) add(t.a, t.b, t.c), add(t.b, t.c, t.a), add(t.c, t.a, t.b);
    std::sort(sides.begin(), sides.end(),
              [](const side_of_edge& s, const side_of_edge& t) { return s.edge < t.edge; });
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].edge != sides[i - 1].edge) continue;
        grid_point a = points[sides[i].edge >> 32], b = points[sides[i].edge & 0xFFFF'FFFF];
        const grid_point c = points[sides[i].apex], d = points[sides[i - 1].apex];
        if (typemesh::orientation(a, b, c) < 0) std::swap(a, b);
        const int side = circle_side(a, b, c, d);
        if (side > 0) return "an edge is not Delaunay";
        if (side < 0) continue;
        const grid_point smallest = (std::min)({a, b, c, d}, comes_first);
        if (!(smallest == a) && !(smallest == b))
            return "a diagonal among points on one circle does not leave the smallest";
    }
    return {};
}

/// The triangles by their points' numbers, each from its smallest on, sorted: equal when the sets are equal.
inline std::vector<std::array<std::uint32_t, 3>> as_set(std::span<const typemesh::triangle> triangles)
{
    std::vector<std::array<std::uint32_t, 3>> set;
    set.reserve(triangles.size());
    for (const typemesh::triangle t : triangles) {
        if (t.a < t.b && t.a < t.c)
            set.push_back({t.a, t.b, t.c});
        else if (t.b < t.c)
            set.push_back({t.b, t.c, t.a});
        else
            set.push_back({t.c, t.a, t.b});
    }
    std::sort(set.begin(), set.end());
    return set;
}

using placed_triangle = std::array<grid_point, 3>;

inline bool operator_less(const placed_triangle& s, const placed_triangle& t)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (!(s[i] == t[i])) return comes_first(s[i], t[i]);
    return false;
}

/// The triangles as places, each from its smallest corner on, sorted: equal when the sets are equal, however points are numbered.
inline std::vector<placed_triangle> as_set(std::span<const grid_point> points,
                                           std::span<const typemesh::triangle> triangles)
{
    std::vector<placed_triangle> set;
    for (const typemesh::triangle t : triangles) {
        placed_triangle p{points[t.a], points[t.b], points[t.c]};
        std::rotate(p.begin(), (std::min_element)(p.begin(), p.end(), comes_first), p.end());
        set.push_back(p);
    }
    std::sort(set.begin(), set.end(), operator_less);
    return set;
}

}  // namespace test::oracle
