// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/inspect/mesh_view.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The faults that keep a mesh from being the surface of solids that do not touch. Vertices at equal positions are
/// welded.
///
///        \ | /        Every edge has two faces, one on each side. The faces around every point form a closed fan.
///       -- p --       At a pinched point they form several fans: for example, two that meet in their tips. Programs
///        / | \        that compute with solids reject both kinds of fault.
struct manifoldness {
    std::size_t open_edges = 0;      ///< the number of undirected edges with one face, or with two faces in one
                                     ///< direction
    std::size_t crowded_edges = 0;   ///< the number of edges with more than two faces
    std::size_t pinched_points = 0;  ///< the number of positions whose faces form more than one fan
    std::size_t bad_triangles = 0;   ///< the number of triangles with two corners at one position, or with a corner
                                     ///< that is no vertex or not finite

    /// Whether there is no fault of any kind.
    [[nodiscard]] constexpr bool is_manifold() const noexcept
    {
        return open_edges + crowded_edges + pinched_points + bad_triangles == 0;
    }
};

/// Counts the faces of every edge and the fans of every point.
///
/// Cost   O(vertices) and O(n log n) for n triangles
template <class Vertex, class Index, class Position>
[[nodiscard]] manifoldness check_manifoldness(const mesh_view<Vertex, Index, Position>& mesh)
{
    struct side {
        std::uint32_t low, high;  // the edge's ends
        std::uint32_t corner;     // 3 * triangle + the corner where the edge begins
        bool forwards;            // the triangle runs from low to high
    };
    const welded_places places = weld(mesh);
    manifoldness found;
    std::vector<side> sides;
    std::vector<std::uint32_t> at(3 * mesh.triangle_count());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        std::array<std::uint32_t, 3> p{};
        const bool drawable = mesh.is_drawable(corners);
        for (std::size_t k = 0; drawable && k < 3; ++k) p[k] = places.of[corners[k]];
        if (!drawable || p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
            ++found.bad_triangles;
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = p[k], to = p[(k + 1) % 3];
            at[3 * t + k] = from;
            sides.push_back(
                {(std::min)(from, to), (std::max)(from, to), static_cast<std::uint32_t>(3 * t + k), from < to});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const side& a, const side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    // Two corners at one point belong to one fan if their triangles share an edge there.
    std::vector<std::uint32_t> fan(at.size());
    std::iota(fan.begin(), fan.end(), 0u);
    const auto fan_of = [&](std::uint32_t corner) {
        while (fan[corner] != corner) corner = fan[corner] = fan[fan[corner]];
        return corner;
    };
    const auto after = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
        if (end - i > 2) {
            ++found.crowded_edges;
        } else if (end - i == 1 || sides[i].forwards == sides[i + 1].forwards) {
            ++found.open_edges;
        } else {
            const std::uint32_t a = sides[i].corner, b = sides[i + 1].corner;
            fan[fan_of(a)] = fan_of(after(b));
            fan[fan_of(after(a))] = fan_of(b);
        }
    }
    std::vector<std::uint32_t> tips;  // one point for each fan
    for (const side& s : sides)
        if (fan_of(s.corner) == s.corner) tips.push_back(at[s.corner]);
    std::sort(tips.begin(), tips.end());
    for (std::size_t i = 0, end = 0; i < tips.size(); i = end) {
        for (end = i; end < tips.size() && tips[end] == tips[i];) ++end;
        if (end - i > 1) ++found.pinched_points;
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
