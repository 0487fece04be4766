// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/core/version.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// An edge of a loop, its position among the loops, and its bounding box.
struct boxed_edge {
    grid_point a, b;
    std::size_t loop, index;  ///< from point `index` of the loop to the next
    std::size_t number;       ///< among the edges of all loops
    std::int32_t left, right, bottom, top;
};

/// The edges of all loops, ordered by their left ends.
[[nodiscard]] inline std::vector<boxed_edge> boxed_edges(const std::vector<loop>& loops)
{
    std::vector<boxed_edge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t i = 0; i < loops[l].size(); ++i) {
            const grid_point a = loops[l][i], b = loops[l][(i + 1) % loops[l].size()];
            edges.push_back({a, b, l, i, edges.size(), (std::min)(a.x, b.x), (std::max)(a.x, b.x), (std::min)(a.y, b.y),
                             (std::max)(a.y, b.y)});
        }
    std::sort(edges.begin(), edges.end(), [](const boxed_edge& p, const boxed_edge& q) { return p.left < q.left; });
    return edges;
}

/// Calls visit(p, q) once for every two edges whose boxes overlap. If a call returns false, stops and returns false.
///
/// Cost   O(n) for n edges, plus the pairs that overlap in x
template <class Visit>
bool each_close_pair(const std::vector<boxed_edge>& edges, Visit&& visit)
{
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const boxed_edge& p = edges[i];
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= p.right; ++j) {
            const boxed_edge& q = edges[j];
            if (q.bottom <= p.top && q.top >= p.bottom && !visit(p, q)) return false;
        }
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
