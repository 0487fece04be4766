// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/offset/impl/wavefront.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The fallback for a speck whose faces cannot be divided into triangles on the grid. A speck is a component of the
/// region that is swept completely within a few cells, such as the crescent between two nearly equal circles. The
/// triangles of the given triangulation cover the speck instead, as if it had not been swept.
///
///      ____----____          All their corners are points of the region, at distance 0. This is as accurate as a node
///     /__--------__\         on the grid: the error is at most `few` cells. Everything around is swept as usual.
class speck_cover {
public:
    static constexpr float few = 8.0f;

    explicit speck_cover(memory source) noexcept : covered_{source} {}

    [[nodiscard]] bool empty() const noexcept { return covered_.empty(); }
    /// Whether it covers this component of the wavefront.
    [[nodiscard]] bool covers(std::uint32_t component) const noexcept { return !empty() && covered_[component]; }

    /// Covers a component. The wavefront must still hold all its cells.
    ///
    /// Fails  error::crossing_contours: the component is no speck; error::out_of_memory
    [[nodiscard]] error cover(std::uint32_t component, const wavefront& front) noexcept
    {
        if (front.live[component] != 0) return error::crossing_contours;
        for (const auto& c : front.outlines.cells) {
            if (front.mesh.segments[c.line].component != component) continue;
            std::uint32_t i = c.corner;
            do {
                if (front.nodes[front.outlines.corners[i].node].distance > few) return error::crossing_contours;
                i = front.outlines.corners[i].next;
            } while (i != c.corner);
        }
        while (covered_.size() < front.live.size())
            if (!covered_.push_back(false)) return error::out_of_memory;
        covered_[component] = true;
        return {};
    }

    /// Appends a cell for each given triangle in a covered component. The cell belongs to the triangle's longest edge
    /// that is an edge of the region.
    [[nodiscard]] error add(const wavefront& front, array_view<const triangle> given, swept_region& out) const noexcept
    {
        if (empty()) return {};
        for (const triangle t : given) {
            if (!covered_[front.mesh.segments[t.a].component]) continue;
            const auto first = static_cast<std::uint32_t>(out.triangles.size());
            if (!out.cells.push_back({edge_of(t, front, out), 0, first}) || !out.triangles.push_back(t))
                return error::out_of_memory;
        }
        return {};
    }

private:
    /// At level 0, edge i goes from node i to the next node of its loop.
    [[nodiscard]] static std::uint32_t edge_of(const triangle& t, const wavefront& front,
                                               const swept_region& out) noexcept
    {
        const std::uint32_t corners[] = {t.a, t.b, t.c, t.a};
        std::uint32_t best = t.a;
        std::int64_t longest = -1;
        for (int k = 0; k < 3; ++k) {
            if (out.edges_at[corners[k]].b != corners[k + 1]) continue;
            const std::int64_t size = squared_distance(front.nodes[corners[k]].at, front.nodes[corners[k + 1]].at);
            if (size <= longest) continue;
            longest = size;
            best = corners[k];
        }
        return best;
    }

    buffer<bool> covered_;  // whether each component is covered; empty: no component is covered
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
