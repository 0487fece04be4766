// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/impl/boxed_edge.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// Whether two edges cross, touch or overlap (neighbours may share only their common point), or a loop has one or two
/// points. Tests all pairs of edges whose boxes overlap.
[[nodiscard]] inline bool is_crossing(const std::vector<loop>& loops)
{
    for (const loop l : loops) {
        const std::size_t n = l.size();
        if (n == 0) continue;
        if (n < 3) return true;
        for (std::size_t i = 0; i < n; ++i) {
            const grid_point a = l[i], b = l[(i + 1) % n], c = l[(i + 2) % n];
            if (a == b) return true;
            if (lies_on(c, a, b) || lies_on(a, b, c)) return true;  // the loop doubles back
        }
    }
    return !each_close_pair(boxed_edges(loops), [&](const boxed_edge& p, const boxed_edge& q) {
        const std::size_t n = loops[p.loop].size();
        const bool neighbours = p.loop == q.loop && ((p.index + 1) % n == q.index || (q.index + 1) % n == p.index);
        return neighbours || !meet(p.a, p.b, q.a, q.b);
    });
}

/// The winding numbers just outside and just inside loop `of`; no two loops may touch or cross.
struct separated {
    std::int32_t outside = 0;
    std::int32_t inside = 0;
};
/// The winding numbers beside loop `of`, which is not empty.
[[nodiscard]] inline separated separated_by(const std::vector<loop>& loops, std::size_t of) noexcept
{
    std::int32_t outside = 0;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (k != of) outside += winding(loops[k], loops[of][0]);
    return {outside, outside + (doubled_area(loops[of]) > 0 ? 1 : -1)};
}

/// Whether loops bound a region without touching: the winding number is 1 left of every edge, 0 right of it.
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
