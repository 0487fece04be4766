// SPDX-License-Identifier: MIT
#pragma once

// Snap rounding by its definition: every pair of edges, every pixel, in integers. Slow, plain, and without code in common
// with the library. For |coordinate| < 2^15.

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/point.hpp>

#include "support/oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test::oracle {

using place = std::pair<std::int64_t, std::int64_t>;  // x, y

/// Directed pieces with the number of times that each is traversed from left to right.
using pieces = std::map<std::pair<place, place>, int>;

inline std::int64_t turn(place a, place b, place c)
{
    return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

/// Whether the closed segment ab has a point in the pixel [-1/2, 1/2) x [-1/2, 1/2) around p. The part of it within each
/// pair of half planes is one interval of its parameter, open at the upper sides.
inline bool comes_through_cell(place a, place b, place p)
{
    struct fraction {
        std::int64_t top, bottom;  // bottom > 0
    };
    fraction low{0, 1}, high{1, 1};
    bool low_open = false, high_open = false;
    const auto compare = [](fraction f, fraction g) {
        const std::int64_t u = f.top * g.bottom, v = g.top * f.bottom;
        return u < v ? -1 : u > v ? 1 : 0;
    };
    const auto from = [&](fraction f, bool open) {
        const int c = compare(f, low);
        if (c > 0) low = f;
        if (c >= 0) low_open = open || (c == 0 && low_open);
    };
    const auto until = [&](fraction f, bool open) {
        const int c = compare(f, high);
        if (c < 0) high = f;
        if (c <= 0) high_open = open || (c == 0 && high_open);
    };
    for (const bool x : {true, false}) {
        const std::int64_t start = 2 * (x ? a.first : a.second), way = 2 * (x ? b.first : b.second) - start;
        const std::int64_t left = 2 * (x ? p.first : p.second) - 1 - start, right = left + 2;
        if (way == 0 && (left > 0 || right <= 0)) return false;
        if (way > 0) from({left, way}, false), until({right, way}, true);
        if (way < 0) from({-right, -way}, true), until({-left, -way}, false);
    }
    const int c = compare(low, high);
    return c < 0 || (c == 0 && !low_open && !high_open);
}

/// The pieces that resolve() promises to cut edges into. Edges between two points that cancel (under even_odd: every pair)
/// do not count. Hot are the contours' points and the grid points nearest to crossings, with halves up. An edge is cut in
/// every hot point that it passes through. The pieces between that must bend somewhere are routed through every hot pixel
/// that they pass through.
inline pieces snapped(const std::vector<loop>& loops, typemesh::fill_rule rule)
{
    const bool parity = rule == typemesh::fill_rule::even_odd;
    const auto is_none = [&](int t) { return parity ? t % 2 == 0 : t == 0; };
    pieces net;
    std::set<place> hot, bent;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point p = l[i], q = l[(i + 1) % l.size()];
            const place a{p.x, p.y}, b{q.x, q.y};
            hot.insert(a);
            if (a < b) ++net[{a, b}];
            if (b < a) --net[{b, a}];
        }
    }
    std::vector<std::pair<std::pair<place, place>, int>> edges;
    for (const auto& e : net)
        if (!is_none(e.second)) edges.push_back(e);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i].first;
        for (std::size_t k = 0; k < i; ++k) {
            const auto [c, d] = edges[k].first;
            const auto apart = [](std::int64_t u, std::int64_t v) { return (u < 0 && v > 0) || (u > 0 && v < 0); };
            if (!apart(turn(a, b, c), turn(a, b, d)) || !apart(turn(c, d, a), turn(c, d, b))) continue;
            std::int64_t part = turn(c, d, a), whole = part - turn(c, d, b);
            if (whole < 0) part = -part, whole = -whole;
            const std::int64_t x = a.first * whole + (b.first - a.first) * part,
                               y = a.second * whole + (b.second - a.second) * part;
            const auto floor = [](std::int64_t v, std::int64_t w) { return v / w - (v % w < 0); };
            const place nearest{floor(2 * x + whole, 2 * whole), floor(2 * y + whole, 2 * whole)};
            hot.insert(nearest);
            if (x % whole != 0 || y % whole != 0) bent.insert(nearest);
        }
    }
    const auto along = [](place a, place b) {
        return [=](place p, place q) {
            const std::int64_t dx = b.first - a.first, dy = b.second - a.second;
            return p.first * dx + p.second * dy < q.first * dx + q.second * dy;
        };
    };
    std::vector<std::vector<place>> cells(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i].first;
        for (const place& p : hot)
            if (p != a && p != b && comes_through_cell(a, b, p)) cells[i].push_back(p);
        std::sort(cells[i].begin(), cells[i].end(), along(a, b));
    }
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const auto [a, b] = edges[i].first;
            const auto is_exact = [&, a = a, b = b](place p) { return turn(a, b, p) == 0; };
            for (auto part = cells[i].begin(); part != cells[i].end();) {
                const auto end = std::find_if(part, cells[i].end(), is_exact);
                if (std::any_of(part, end, [&](place p) { return bent.count(p) != 0; }))
                    for (; part != end; ++part) more |= bent.insert(*part).second;
                part = end == cells[i].end() ? end : end + 1;
            }
        }
    }
    pieces cut;
    const auto add = [&](place a, place b, int t) {
        std::vector<place> on;
        for (const place& p : hot)
            if (p != a && p != b && turn(a, b, p) == 0 && (std::min)(a, b) < p && p < (std::max)(a, b)) on.push_back(p);
        std::sort(on.begin(), on.end(), along(a, b));
        on.push_back(b);
        for (const place& p : on) {
            cut[{(std::min)(a, p), (std::max)(a, p)}] += a < p ? t : -t;
            a = p;
        }
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        auto [a, b] = edges[i].first;
        const place start = a;
        for (const place& p : cells[i]) {
            if (turn(start, b, p) != 0 && bent.count(p) == 0) continue;
            add(a, p, edges[i].second);
            a = p;
        }
        add(a, b, edges[i].second);
    }
    for (auto i = cut.begin(); i != cut.end();) i = is_none(i->second) ? cut.erase(i) : std::next(i);
    return cut;
}

/// The pieces that bound the filled area, directed so that the area lies on their left.
inline std::set<std::pair<place, place>> boundary_of(const pieces& all, typemesh::fill_rule rule)
{
    std::set<std::pair<place, place>> boundary;
    for (const auto& [piece, t] : all) {
        const auto [a, b] = piece;
        const place middle{a.first + b.first, a.second + b.second};  // doubled
        std::int32_t below = 0;  // the winding number on its right: counted down from the middle, or from left to right
        for (const auto& [other, u] : all) {
            if (other == piece) continue;
            place c{2 * other.first.first, 2 * other.first.second}, d{2 * other.second.first, 2 * other.second.second};
            int crossed = u;
            if (a.first == b.first) {  // vertical: along the ray to the right
                if (c.second > d.second) std::swap(c, d), crossed = -u;
                if (c.second <= middle.second && middle.second < d.second && turn(c, d, middle) > 0) below += crossed;
            } else if (c.first <= middle.first && middle.first < d.first && turn(c, d, middle) > 0) {
                below += crossed;
            }
        }
        const bool is_left = typemesh::is_filled(rule, below + t), is_right = typemesh::is_filled(rule, below);
        if (is_left && !is_right) boundary.insert({a, b});
        if (!is_left && is_right) boundary.insert({b, a});
    }
    return boundary;
}

/// The edges of loops, each once; `twice` is set if one occurs more often.
inline std::set<std::pair<place, place>> edges_of(const std::vector<loop>& loops, bool& twice)
{
    std::set<std::pair<place, place>> edges;
    twice = false;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point p = l[i], q = l[(i + 1) % l.size()];
            twice |= !edges.insert({place{p.x, p.y}, place{q.x, q.y}}).second;
        }
    }
    return edges;
}

/// Loops as cyclic sequences of points, each from its smallest rotation, sorted.
inline std::vector<std::vector<place>> cyclic(const std::vector<loop>& loops)
{
    std::vector<std::vector<place>> all;
    for (const loop l : loops) {
        std::vector<place> points;
        for (const grid_point p : l) points.emplace_back(p.x, p.y);
        std::vector<place> smallest = points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::rotate(points.begin(), points.begin() + 1, points.end());
            smallest = (std::min)(smallest, points);
        }
        all.push_back(smallest);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace test::oracle
