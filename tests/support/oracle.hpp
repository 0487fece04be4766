// SPDX-License-Identifier: MIT
#pragma once

// What is true of closed polylines, found by trying everything: slow, plain, and without a line in common with the
// library.

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace test::oracle {

using typemesh::grid_point;
using loop = std::span<const grid_point>;

inline std::vector<loop> loops_of(std::span<const grid_point> points, std::span<const std::uint32_t> starts)
{
    std::vector<loop> loops;
    for (std::size_t i = 0; i + 1 < starts.size(); ++i)
        loops.push_back(points.subspan(starts[i], starts[i + 1] - starts[i]));
    return loops;
}
inline std::vector<loop> loops_of(const typemesh::contours& c) { return loops_of(c.points.view(), c.starts.view()); }
inline std::vector<loop> loops_of(const typemesh::region& r) { return loops_of(r.points(), r.starts()); }

/// -1: c lies right of the way from a to b, 0: on the line, 1: left of it. |coordinate| <= 2^29.
inline int side(grid_point a, grid_point b, grid_point c)
{
    const std::int64_t left = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y);
    const std::int64_t right = (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    return left > right ? 1 : left < right ? -1 : 0;
}

/// p on the closed segment ab.
inline bool lies_on(grid_point p, grid_point a, grid_point b)
{
    return side(a, b, p) == 0 && (std::min)(a.x, b.x) <= p.x && p.x <= (std::max)(a.x, b.x) &&
           (std::min)(a.y, b.y) <= p.y && p.y <= (std::max)(a.y, b.y);
}

/// The closed segments have a point in common.
inline bool meet(grid_point a, grid_point b, grid_point c, grid_point d)
{
    if (lies_on(c, a, b) || lies_on(d, a, b) || lies_on(a, c, d) || lies_on(b, c, d)) return true;
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Whether any two edges cross, touch or overlap (neighbours: more than their common point), or a loop has under 3
/// points.
inline bool is_crossing(const std::vector<loop>& loops)
{
    struct edge {
        grid_point a, b, next, previous;
        std::size_t loop, index, count;
        std::int32_t left, right, bottom, top;
    };
    std::vector<edge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const std::size_t n = loops[l].size();
        if (n == 0) continue;
        if (n < 3) return true;
        for (std::size_t i = 0; i < n; ++i) {
            const grid_point a = loops[l][i], b = loops[l][(i + 1) % n], c = loops[l][(i + 2) % n];
            if (a == b) return true;
            if (lies_on(c, a, b) || lies_on(a, b, c)) return true;  // doubles back
            edges.push_back({a, b, c, a, l, i, n, (std::min)(a.x, b.x), (std::max)(a.x, b.x), (std::min)(a.y, b.y),
                             (std::max)(a.y, b.y)});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const edge& p, const edge& q) { return p.left < q.left; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const edge& p = edges[i];
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= p.right; ++j) {
            const edge& q = edges[j];
            if (q.bottom > p.top || q.top < p.bottom) continue;
            if (p.loop == q.loop && ((p.index + 1) % p.count == q.index || (q.index + 1) % p.count == p.index))
                continue;  // neighbours
            if (meet(p.a, p.b, q.a, q.b)) return true;
        }
    }
    return false;
}

/// Twice the enclosed area, counter-clockwise positive; exact when it fits into 63 bits, as it does for one loop on the
/// grid.
inline std::int64_t doubled_area(loop l)
{
    std::uint64_t sum = 0;  // may wrap on the way
    for (std::size_t i = 0; i < l.size(); ++i) {
        const grid_point a = l[i], b = l[(i + 1) % l.size()];
        sum += static_cast<std::uint64_t>(std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x);
    }
    return static_cast<std::int64_t>(sum);
}
inline std::int64_t doubled_area(const std::vector<loop>& loops)
{
    std::uint64_t sum = 0;
    for (const loop l : loops) sum += static_cast<std::uint64_t>(doubled_area(l));
    return static_cast<std::int64_t>(sum);
}

/// How often l runs round p, which must not lie on it: counted along the ray from p to the right.
inline std::int32_t winding(loop l, grid_point p)
{
    std::int32_t w = 0;
    for (std::size_t i = 0; i < l.size(); ++i) {
        const grid_point a = l[i], b = l[(i + 1) % l.size()];
        if (a.y <= p.y && b.y > p.y && side(a, b, p) > 0) ++w;
        if (b.y <= p.y && a.y > p.y && side(a, b, p) < 0) --w;
    }
    return w;
}

/// The winding numbers just outside and just inside of loop `of`; no two loops may meet.
struct separated {
    std::int32_t outside, inside;
};
inline separated separated_by(const std::vector<loop>& loops, std::size_t of)
{
    std::int32_t outside = 0;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (k != of) outside += winding(loops[k], loops[of][0]);
    return {outside, outside + (doubled_area(loops[of]) > 0 ? 1 : -1)};
}

/// Whether loops that do not meet bound a region as they are: 1 on the left of every edge, 0 on the right.
inline bool is_region(const std::vector<loop>& loops)
{
    if (is_crossing(loops)) return false;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (loops[l].empty()) continue;
        const separated s = separated_by(loops, l);
        if ((std::min)(s.outside, s.inside) != 0 || (std::max)(s.outside, s.inside) != 1) return false;
    }
    return true;
}

/// Twice the area that loops fill, which may cross as they like: cut into slabs within which no two edges cross.
/// Rounded.
inline double doubled_filled_area(const std::vector<loop>& loops, typemesh::fill_rule rule)
{
    struct edge {
        grid_point a, b;  // from left to right
        std::int32_t turn;
    };
    std::vector<edge> edges;
    std::vector<long double> cuts;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            cuts.push_back(a.x);
            if (a.x < b.x) edges.push_back({a, b, 1});
            if (b.x < a.x) edges.push_back({b, a, -1});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const edge& p, const edge& q) { return p.a.x < q.a.x; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const edge& p = edges[i];
        for (std::size_t j = i + 1; j < edges.size() && edges[j].a.x < p.b.x; ++j) {
            const edge& q = edges[j];
            if (side(p.a, p.b, q.a) * side(p.a, p.b, q.b) > 0 || side(q.a, q.b, p.a) * side(q.a, q.b, p.b) > 0)
                continue;
            const long double px = p.b.x - p.a.x, py = p.b.y - p.a.y, qx = q.b.x - q.a.x, qy = q.b.y - q.a.y;
            const long double cross = px * qy - py * qx;
            if (cross == 0) continue;
            cuts.push_back(
                p.a.x +
                px * ((static_cast<long double>(q.a.x) - p.a.x) * qy - (static_cast<long double>(q.a.y) - p.a.y) * qx) /
                    cross);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());

    long double area = 0;
    std::vector<std::pair<long double, std::int32_t>> heights;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const long double x = (cuts[c] + cuts[c + 1]) / 2;
        heights.clear();
        for (const edge& e : edges) {
            if (e.a.x >= x) break;
            if (e.b.x <= x) continue;
            heights.emplace_back(e.a.y + (x - e.a.x) * (e.b.y - e.a.y) / (static_cast<long double>(e.b.x) - e.a.x),
                                 e.turn);
        }
        std::sort(heights.begin(), heights.end());
        std::int32_t w = 0;
        for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
            w += heights[i].second;
            if (typemesh::is_filled(rule, w))
                area += (cuts[c + 1] - cuts[c]) * (heights[i + 1].first - heights[i].first);
        }
    }
    return static_cast<double>(2 * area);
}

/// Loops of which every edge is led through the grid points nearest to where others cross it.
struct led_loops {
    std::vector<std::vector<grid_point>> all;
    double bent_length = 0.0;  ///< of the edges that are crossed elsewhere than in a grid point
    [[nodiscard]] std::vector<loop> loops() const { return {all.begin(), all.end()}; }
};
inline led_loops led_through_crossings(const std::vector<loop>& loops)
{
    struct edge {
        grid_point a, b;
        std::int32_t left, right, bottom, top;
        std::size_t number;
    };
    std::vector<edge> edges;
    for (const loop l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            edges.push_back({a, b, (std::min)(a.x, b.x), (std::max)(a.x, b.x), (std::min)(a.y, b.y),
                             (std::max)(a.y, b.y), edges.size()});
        }
    std::vector<std::vector<std::pair<long double, grid_point>>> on(edges.size());
    std::vector<bool> bends(edges.size(), false);
    std::sort(edges.begin(), edges.end(), [](const edge& p, const edge& q) { return p.left < q.left; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const edge& p = edges[i];
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= p.right; ++j) {
            const edge& q = edges[j];
            if (q.bottom > p.top || q.top < p.bottom) continue;
            if (side(p.a, p.b, q.a) * side(p.a, p.b, q.b) >= 0 || side(q.a, q.b, p.a) * side(q.a, q.b, p.b) >= 0)
                continue;
            using real = long double;
            const real px = real(p.b.x) - p.a.x, py = real(p.b.y) - p.a.y, qx = real(q.b.x) - q.a.x,
                       qy = real(q.b.y) - q.a.y, gx = real(q.a.x) - p.a.x, gy = real(q.a.y) - p.a.y;
            const real turn = px * qy - py * qx, u = (gx * qy - gy * qx) / turn, v = (gx * py - gy * px) / turn;
            const grid_point x{static_cast<std::int32_t>(std::floor(p.a.x + px * u + 0.5L)),
                               static_cast<std::int32_t>(std::floor(p.a.y + py * u + 0.5L))};
            on[p.number].emplace_back(u, x);
            on[q.number].emplace_back(v, x);
            if (side(p.a, p.b, x) != 0) bends[p.number] = true;
            if (side(q.a, q.b, x) != 0) bends[q.number] = true;
        }
    }
    led_loops led;
    std::size_t number = 0;
    for (const loop l : loops) {
        auto& out = led.all.emplace_back();
        for (std::size_t i = 0; i < l.size(); ++i, ++number) {
            out.push_back(l[i]);
            auto& mine = on[number];
            std::sort(mine.begin(), mine.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
            for (const auto& [u, x] : mine) out.push_back(x);
            const grid_point b = l[(i + 1) % l.size()];
            if (bends[number]) led.bent_length += std::hypot(double(b.x) - l[i].x, double(b.y) - l[i].y);
        }
    }
    return led;
}

/// How often loops run round p.
inline std::int32_t winding(const std::vector<loop>& loops, grid_point p)
{
    std::int32_t w = 0;
    for (const loop l : loops) w += winding(l, p);
    return w;
}

/// How long all edges are together: snapping them by half a cell moves at most half of that in area.
inline double length(const std::vector<loop>& loops)
{
    double sum = 0.0;
    for (const loop l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            sum += std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        }
    return sum;
}

/// How far p is from the nearest edge.
inline double distance(const std::vector<loop>& loops, grid_point p)
{
    double nearest = 1e300;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            const double x = double(b.x) - a.x, y = double(b.y) - a.y, px = double(p.x) - a.x, py = double(p.y) - a.y;
            const double square = x * x + y * y, t = square == 0 ? 0.0 : (std::max)(0.0, (std::min)(1.0, (px * x + py * y) / square));
            nearest = (std::min)(nearest, std::hypot(px - t * x, py - t * y));
        }
    }
    return nearest;
}

/// Whether direction d lies strictly between a and b, turning counter-clockwise from a; if a and b are one direction,
/// all others do.
inline bool turns_through(grid_point p, grid_point a, grid_point d, grid_point b)
{
    const auto sector = [&](grid_point q) {  // 0: along a, 1: left of it, 2: against it, 3: right of it
        const int s = side(p, a, q);
        if (s != 0) return s > 0 ? 1 : 3;
        return (std::int64_t{a.x} - p.x) * (std::int64_t{q.x} - p.x) + (std::int64_t{a.y} - p.y) * (std::int64_t{q.y} - p.y) > 0 ? 0 : 2;
    };
    const int sd = sector(d), sb = sector(b) == 0 ? 4 : sector(b);
    if (sd == 0) return false;
    if (sd != sb) return sd < sb;
    return sd % 2 == 1 && side(p, d, b) > 0;
}

/// What keeps loops from being walks round an area, as region promises; empty when nothing does. Loops may touch in
/// points.
inline std::string broken_walk(const std::vector<loop>& loops)
{
    struct edge {
        grid_point before, a, b, after;
    };
    std::vector<edge> edges;
    for (const loop l : loops) {
        const std::size_t n = l.size();
        if (n < 3) return "a loop has fewer than three points";
        for (std::size_t i = 0; i < n; ++i) edges.push_back({l[(i + n - 1) % n], l[i], l[(i + 1) % n], l[(i + 2) % n]});
    }
    std::sort(edges.begin(), edges.end(), [](const edge& p, const edge& q) { return (std::min)(p.a.x, p.b.x) < (std::min)(q.a.x, q.b.x); });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const edge& e = edges[i];
        if (e.a == e.b) return "a point is repeated";
        if (e.a == e.after) return "a spike";
        if (lies_on(e.after, e.a, e.b) || lies_on(e.a, e.b, e.after)) return "a spike";
        for (std::size_t j = i + 1; j < edges.size() && (std::min)(edges[j].a.x, edges[j].b.x) <= (std::max)(e.a.x, e.b.x); ++j) {
            const edge& f = edges[j];
            if (!meet(e.a, e.b, f.a, f.b)) continue;
            const bool aa = e.a == f.a, ab = e.a == f.b, ba = e.b == f.a, bb = e.b == f.b;
            if (!(aa || ab || ba || bb)) return "two edges cross or touch within";
            if ((aa && bb) || (ab && ba)) return "two edges are one";
            if (aa + ab + ba + bb > 1) return "two edges overlap";
            const grid_point p = aa || ab ? e.a : e.b, q = aa || ba ? f.a : f.b, eo = aa || ab ? e.b : e.a, fo = aa || ba ? f.b : f.a;
            if (!(p == q)) return "the oracle is wrong";
            if (side(p, eo, fo) == 0 && (lies_on(fo, p, eo) || lies_on(eo, p, fo))) return "two edges overlap";
            if (aa && turns_through(p, e.b, f.b, e.before)) return "a walk leaves its wedge";
            if (aa && turns_through(p, f.b, e.b, f.before)) return "a walk leaves its wedge";
            if (bb && turns_through(p, e.after, f.a, e.a)) return "a walk leaves its wedge";
            if (bb && turns_through(p, f.after, e.a, f.a)) return "a walk leaves its wedge";
            if (ab && !(e.before == f.a) && turns_through(p, e.b, f.a, e.before)) return "a walk leaves its wedge";
            if (ba && !(e.after == f.b) && turns_through(p, e.after, f.b, e.a)) return "a walk leaves its wedge";
        }
    }
    return {};
}

/// The first law that a triangulation breaks, in words; empty when it obeys all. n + 2h - 2c triangles, each strictly
/// counter-clockwise; the region's area exactly; each edge of the region an edge of one triangle and in its own
/// direction, each other edge of two, in both directions; every point a corner.
inline std::string broken_law(const typemesh::region& r, std::span<const typemesh::triangle> triangles)
{
    const auto points = r.points();
    const std::vector<loop> loops = loops_of(r);
    std::size_t holes = 0, outers = 0;
    for (const loop l : loops) ++(doubled_area(l) < 0 ? holes : outers);
    if (r.holes() != holes || r.outers() != outers) return "holes and outer loops are miscounted";
    if (triangles.size() != points.size() + 2 * holes - 2 * outers) return "not n + 2h - 2c triangles";
    if (triangles.size() != r.triangle_count()) return "not as many triangles as the region says";

    std::vector<std::uint64_t> inner;
    std::vector<bool> used(points.size(), false);
    std::uint64_t area = 0;
    const auto directed = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
    for (const typemesh::triangle t : triangles) {
        if (t.a >= points.size() || t.b >= points.size() || t.c >= points.size())
            return "a corner is no point of the region";
        if (side(points[t.a], points[t.b], points[t.c]) <= 0) return "a triangle is not strictly counter-clockwise";
        const grid_point corners[3] = {points[t.a], points[t.b], points[t.c]};
        area += static_cast<std::uint64_t>(doubled_area(corners));
        used[t.a] = used[t.b] = used[t.c] = true;
        inner.insert(inner.end(), {directed(t.a, t.b), directed(t.b, t.c), directed(t.c, t.a)});
    }
    if (static_cast<std::int64_t>(area) != doubled_area(loops)) return "the area is not the region's";
    if (std::find(used.begin(), used.end(), false) != used.end()) return "a point is not used";

    std::sort(inner.begin(), inner.end());
    if (std::adjacent_find(inner.begin(), inner.end()) != inner.end()) return "a directed edge is there twice";
    const auto is_there = [&](std::uint64_t e) { return std::binary_search(inner.begin(), inner.end(), e); };
    std::vector<std::uint64_t> boundary;
    for (std::size_t l = 0; l + 1 < r.starts().size(); ++l) {
        const std::uint32_t begin = r.starts()[l], end = r.starts()[l + 1];
        for (std::uint32_t i = begin; i < end; ++i) boundary.push_back(directed(i, i + 1 < end ? i + 1 : begin));
    }
    std::sort(boundary.begin(), boundary.end());
    for (const std::uint64_t e : boundary) {
        if (!is_there(e)) return "an edge of the region is in no triangle";
        if (is_there(e << 32 | e >> 32)) return "an edge of the region is in two triangles";
    }
    for (const std::uint64_t e : inner)
        if (!std::binary_search(boundary.begin(), boundary.end(), e) && !is_there(e << 32 | e >> 32))
            return "an inner edge is in one triangle only";
    return {};
}

}  // namespace test::oracle
