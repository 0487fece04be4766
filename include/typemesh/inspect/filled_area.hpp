// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/inspect/impl/boxed_edge.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

namespace detail {

/// An edge from left to right, and its effect on the winding number above it.
struct slab_edge {
    grid_point a, b;
    std::int32_t winding_delta = 0;

    [[nodiscard]] long double height_at(long double x) const noexcept
    {
        return a.y + (x - a.x) * (b.y - a.y) / (static_cast<long double>(b.x) - a.x);
    }
};

/// The parameter on edge p, 0 at its start and 1 at its end, where p meets the line of q. False if they are parallel.
[[nodiscard]] inline bool crossing_share(grid_point pa, grid_point pb, grid_point qa, grid_point qb,
                                         long double& share) noexcept
{
    using real = long double;
    const real px = real(pb.x) - pa.x, py = real(pb.y) - pa.y, qx = real(qb.x) - qa.x, qy = real(qb.y) - qa.y;
    const real cross = px * qy - py * qx;
    if (!(cross < 0 || cross > 0)) return false;
    share = ((real(qa.x) - pa.x) * qy - (real(qa.y) - pa.y) * qx) / cross;
    return true;
}

}  // namespace detail

/// Twice the area that loops fill, in square cells, however they cross. Cuts the plane into slabs in which no two edges
/// cross. Rounded like any sum of long doubles. Cost: O(n^2) and worse.
[[nodiscard]] inline double doubled_filled_area(const std::vector<loop>& loops, fill_rule rule)
{
    using detail::slab_edge;
    std::vector<slab_edge> edges;
    std::vector<long double> cuts;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            cuts.push_back(a.x);
            if (a.x < b.x) edges.push_back({a, b, 1});
            if (b.x < a.x) edges.push_back({b, a, -1});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const slab_edge& p, const slab_edge& q) { return p.a.x < q.a.x; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const slab_edge& p = edges[i];
        for (std::size_t j = i + 1; j < edges.size() && edges[j].a.x < p.b.x; ++j) {
            const slab_edge& q = edges[j];
            if (side(p.a, p.b, q.a) * side(p.a, p.b, q.b) > 0 || side(q.a, q.b, p.a) * side(q.a, q.b, p.b) > 0)
                continue;
            long double share = 0;
            if (detail::crossing_share(p.a, p.b, q.a, q.b, share))
                cuts.push_back(p.a.x + (static_cast<long double>(p.b.x) - p.a.x) * share);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    const auto equal = [](long double x, long double y) { return !(x < y) && !(y < x); };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), equal), cuts.end());

    long double area = 0;
    std::vector<std::pair<long double, std::int32_t>> heights;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const long double x = (cuts[c] + cuts[c + 1]) / 2;
        heights.clear();
        for (const slab_edge& e : edges) {
            if (e.a.x >= x) break;
            if (e.b.x > x) heights.emplace_back(e.height_at(x), e.winding_delta);
        }
        std::sort(heights.begin(), heights.end());
        std::int32_t w = 0;
        for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
            w += heights[i].second;
            if (is_filled(rule, w)) area += (cuts[c + 1] - cuts[c]) * (heights[i + 1].first - heights[i].first);
        }
    }
    return static_cast<double>(2 * area);
}

/// Loops with every edge rerouted through the grid points nearest to its crossings with others. They fill the same area
/// as the resolved loops, unless rerouting makes new crossings.
struct rerouted_loops {
    std::vector<std::vector<grid_point>> all;  ///< the loops, rerouted
    double bent_length = 0.0;  ///< the total length of the edges with crossings that are not grid points, in cells

    [[nodiscard]] std::vector<loop> loops() const { return {all.begin(), all.end()}; }
};
/// Inserts a point, rounded to the grid, wherever an edge of the loops is crossed.
[[nodiscard]] inline rerouted_loops reroute_through_crossings(const std::vector<loop>& loops)
{
    const std::vector<boxed_edge> edges = boxed_edges(loops);
    std::vector<std::vector<std::pair<long double, grid_point>>> on(edges.size());  // the crossings of each edge
    std::vector<bool> bends(edges.size(), false);
    each_close_pair(edges, [&](const boxed_edge& p, const boxed_edge& q) {
        if (side(p.a, p.b, q.a) * side(p.a, p.b, q.b) >= 0 || side(q.a, q.b, p.a) * side(q.a, q.b, p.b) >= 0)
            return true;
        long double u = 0, v = 0;
        if (!detail::crossing_share(p.a, p.b, q.a, q.b, u) || !detail::crossing_share(q.a, q.b, p.a, p.b, v))
            return true;
        const grid_point x{
            static_cast<std::int32_t>(std::floor(p.a.x + (static_cast<long double>(p.b.x) - p.a.x) * u + 0.5L)),
            static_cast<std::int32_t>(std::floor(p.a.y + (static_cast<long double>(p.b.y) - p.a.y) * u + 0.5L))};
        on[p.number].emplace_back(u, x);
        on[q.number].emplace_back(v, x);
        if (side(p.a, p.b, x) != 0) bends[p.number] = true;
        if (side(q.a, q.b, x) != 0) bends[q.number] = true;
        return true;
    });
    rerouted_loops made;
    std::size_t number = 0;
    for (const loop l : loops) {
        auto& out = made.all.emplace_back();
        for (std::size_t i = 0; i < l.size(); ++i, ++number) {
            out.push_back(l[i]);
            auto& mine = on[number];
            std::sort(mine.begin(), mine.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
            for (const auto& crossed : mine) out.push_back(crossed.second);
            const grid_point b = l[(i + 1) % l.size()];
            if (bends[number]) made.bent_length += std::hypot(double(b.x) - l[i].x, double(b.y) - l[i].y);
        }
    }
    return made;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
