// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// Whether any two edges cross, touch or overlap (neighbours: in more than their common point), or a loop has one or
/// two points. Tests all pairs of edges whose boxes overlap.
[[nodiscard]] inline bool is_crossing(const std::vector<loop>& loops)
{
    struct edge {
        grid_point a, b;
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
            edges.push_back({a, b, l, i, n, (std::min)(a.x, b.x), (std::max)(a.x, b.x), (std::min)(a.y, b.y),
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

/// The winding numbers just outside and just inside loop `of`; no two loops may touch or cross.
struct separated {
    std::int32_t outside = 0;
    std::int32_t inside = 0;
};
[[nodiscard]] inline separated separated_by(const std::vector<loop>& loops, std::size_t of) noexcept
{
    std::int32_t outside = 0;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (k != of) outside += winding(loops[k], loops[of][0]);
    return {outside, outside + (doubled_area(loops[of]) > 0 ? 1 : -1)};
}

/// Whether loops bound a region as they are, without touching: the winding number is 1 left of every edge, 0 right.
[[nodiscard]] inline bool is_region(const std::vector<loop>& loops)
{
    if (is_crossing(loops)) return false;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (loops[l].empty()) continue;
        const separated s = separated_by(loops, l);
        if ((std::min)(s.outside, s.inside) != 0 || (std::max)(s.outside, s.inside) != 1) return false;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
