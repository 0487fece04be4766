// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/mesh_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The numbers in Euler's formula. Vertices at equal positions are welded.
///
///     places - edges + triangles = 2 * solids - 2 * holes        if solids touch neither themselves nor each other:
///                                                                an o has one hole, an i is two solids, an 8 has
///                                                                two holes
struct euler_count {
    std::size_t places = 0;
    std::size_t edges = 0;  ///< the number of undirected edges
    std::size_t triangles = 0;
    std::size_t solids = 0;  ///< the number of components connected by edges

    /// places - edges + triangles: 2 for each solid without holes through it.
    [[nodiscard]] constexpr std::int64_t characteristic() const noexcept
    {
        return static_cast<std::int64_t>(places) - static_cast<std::int64_t>(edges) +
               static_cast<std::int64_t>(triangles);
    }
    /// The number of holes through closed solids that do not touch.
    [[nodiscard]] constexpr std::int64_t holes() const noexcept
    {
        return static_cast<std::int64_t>(solids) - characteristic() / 2;
    }
};

/// Counts a mesh's distinct positions, edges, triangles, solids and holes, without triangles that are not drawable.
/// Cost: O(vertices) and O(n log n) for n triangles
template <class Vertex, class Index, class Position>
[[nodiscard]] euler_count count_euler(const mesh_view<Vertex, Index, Position>& mesh)
{
    const welded_places places = weld(mesh);
    euler_count found;
    found.places = found.solids = places.at.size();
    std::vector<std::uint64_t> edges;  // the smaller end first
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        if (!mesh.is_drawable(corners)) continue;
        ++found.triangles;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = places.of[corners[k]], b = places.of[corners[(k + 1) % 3]];
            edges.push_back((std::min)(a, b) << 32 | (std::max)(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    found.edges = edges.size();

    std::vector<std::uint32_t> above(places.at.size());  // union-find: a tree per component, each root its own parent
    for (std::size_t i = 0; i < above.size(); ++i) above[i] = static_cast<std::uint32_t>(i);
    const auto root = [&](std::uint32_t i) {
        while (above[i] != i) i = above[i] = above[above[i]];
        return i;
    };
    for (const std::uint64_t e : edges) {
        const std::uint32_t a = root(static_cast<std::uint32_t>(e >> 32)), b = root(static_cast<std::uint32_t>(e));
        if (a == b) continue;
        above[a] = b;
        --found.solids;
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
