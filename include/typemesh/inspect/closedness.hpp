// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/mesh_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The faults that keep a mesh from being closed. Vertices at equal positions are welded.
///
///           b            The edge a -> b of the left triangle matches b -> a of the right one. An unmatched edge is
///          /|\           open. An edge with more than two faces is crowded: two solids, or two loops of one, touch
///         / | \          along it. A mesh is closed if every edge occurs as often as its reverse: then it has an
///        /  |  \         inside.
///       c---a---d
struct closedness {
    std::size_t triangles = 0;        ///< the number of triangles examined
    std::size_t unmatched_edges = 0;  ///< the number of directed edges that occur more often than their reverse
    std::size_t crowded_edges = 0;    ///< the number of undirected edges with more than two faces
    std::size_t crowded_slanted = 0;  ///< the number of crowded edges that are not parallel to the depth axis
    std::size_t zero_area = 0;        ///< the number of triangles with two corners at one position
    std::size_t bad_corners = 0;      ///< the number of triangles with a corner that is no vertex or is not finite

    /// Whether the mesh is closed and every triangle valid. Crowded edges are no fault in text whose glyphs or loops
    /// touch.
    [[nodiscard]] constexpr bool is_closed() const noexcept
    {
        return unmatched_edges == 0 && zero_area == 0 && bad_corners == 0;
    }
};

/// Matches each edge of a mesh with its reverse. typemesh closes each glyph separately (or each group, if merged), so
/// both the triangles of one glyph and the whole text are closed.
///
///     depth_axis    the coordinate (0, 1, 2) along which the text is extruded
///
/// Cost   O(vertices) and O(n log n) for n triangles
template <class Vertex, class Index, class Position>
[[nodiscard]] closedness check_closedness(const mesh_view<Vertex, Index, Position>& mesh, int depth_axis = 2)
{
    const welded_places places = weld(mesh);
    closedness found;
    found.triangles = mesh.triangle_count();
    std::vector<std::uint64_t> edges;  // from << 32 | to
    edges.reserve(3 * mesh.triangle_count());
    std::vector<std::size_t> starts(places.at.size() + 1, 0);  // where the edges that leave a place begin
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        if (!mesh.is_drawable(corners)) {
            ++found.bad_corners;
            continue;
        }
        const std::uint32_t at[3] = {places.of[corners[0]], places.of[corners[1]], places.of[corners[2]]};
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) ++found.zero_area;
        for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::uint64_t{at[k]} << 32 | at[(k + 1) % 3]);
    }
    std::sort(edges.begin(), edges.end());
    for (const std::uint64_t edge : edges) ++starts[(edge >> 32) + 1];
    for (std::size_t v = 0; v < places.at.size(); ++v) starts[v + 1] += starts[v];
    const auto faces = [&](std::uint64_t edge) {
        const auto first = edges.begin() + static_cast<std::ptrdiff_t>(starts[edge >> 32]),
                   last = edges.begin() + static_cast<std::ptrdiff_t>(starts[(edge >> 32) + 1]);
        const auto range = std::equal_range(first, last, edge);
        return static_cast<std::size_t>(range.second - range.first);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i] == edges[i - 1]) continue;
        const std::uint64_t reverse = edges[i] << 32 | edges[i] >> 32;
        const std::size_t here = faces(edges[i]), back = faces(reverse);
        if (here > back) found.unmatched_edges += here - back;
        if (here + back > 2 && (edges[i] < reverse || back == 0)) {  // once for both directions
            ++found.crowded_edges;
            const place along = places.at[edges[i] >> 32] - places.at[edges[i] & 0xFFFF'FFFFu];
            const double moves[3] = {along.x, along.y, along.z};
            bool slanted = false;
            for (int k = 0; k < 3; ++k) slanted |= k != depth_axis && (moves[k] < 0.0 || moves[k] > 0.0);
            found.crowded_slanted += slanted ? 1u : 0u;
        }
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
