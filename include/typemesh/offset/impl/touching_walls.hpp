// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Counts the places where walls on the last level of a swept region would touch themselves or the swept area:
///
///       \  /            Another wall, or the swept area, passes through the point on which a wall stands. Both are
///     ---p---           counted, whatever the distance at which the other came there: heights that differ by less than
///       /  \            32-bit numbers can show are equal.
///
///     ==========        Two walls stand back to back, where the remaining area is as thin as a line; the cap omits it.
///
/// Fails  error::out_of_memory
/// Cost   O(n log n) for n nodes
[[nodiscard]] inline result<std::uint32_t> count_touching_walls(const swept_region& swept, workspace& space) noexcept
{
    struct wall {
        grid_point from, to;
    };
    struct place {
        grid_point at;
        bool is_swept = false;  // by an edge that ended here and carries no wall
    };
    const auto before = [](grid_point p, grid_point q) noexcept { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    const std::size_t first = swept.at_level[swept.at_level.size() - 2], end = swept.at_level.back();
    const std::size_t most = swept.nodes.size() + (end - first);
    workspace::scope scratch{space};
    auto* const walls = scratch.take<wall>(end - first);
    auto* const places = scratch.take<place>(most);
    auto* const stands = scratch.take<bool>(swept.nodes.size());  // whether a wall stands on a node
    if ((walls == nullptr && end != first) || (most != 0 && (places == nullptr || stands == nullptr)))
        return error::out_of_memory;
    std::fill_n(stands, swept.nodes.size(), false);
    std::size_t n = 0, m = 0;
    for (std::size_t i = first; i < end; ++i) {
        const auto [edge, a, b] = swept.edges_at[i];
        const wall w{swept.nodes[a].at, swept.nodes[b].at};
        if (w.from == w.to) continue;
        stands[a] = stands[b] = true;
        walls[n++] = w;
        places[m++] = {w.from};
    }
    for (std::size_t i = 0; i < swept.nodes.size(); ++i)
        if (!stands[i]) places[m++] = {swept.nodes[i].at, true};
    std::uint32_t found = 0;
    std::sort(places, places + m, [&before](const place& p, const place& q) noexcept {
        return p.at != q.at ? before(p.at, q.at) : p.is_swept < q.is_swept;
    });
    for (std::size_t i = 1; i < m; ++i)  // the walls of a point come first
        found += places[i].at == places[i - 1].at && !places[i - 1].is_swept ? 1u : 0u;
    for (std::size_t i = 0; i < n; ++i)
        if (before(walls[i].to, walls[i].from)) std::swap(walls[i].from, walls[i].to);
    std::sort(walls, walls + n, [&before](const wall& v, const wall& w) noexcept {
        return v.from != w.from ? before(v.from, w.from) : before(v.to, w.to);
    });
    for (std::size_t i = 1; i < n; ++i)
        found += walls[i].from == walls[i - 1].from && walls[i].to == walls[i - 1].to ? 1u : 0u;
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI
