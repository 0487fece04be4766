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

/// What is done about a speck whose faces cannot be cut on the grid: a component of the region that is swept wholly
/// within a few cells, such as the crescent between two circles that are nearly the same. The triangles that it was
/// given cover it instead, as if it had not been swept.
///
///      ____----____          All their corners are the region's own, at distance 0, which is as right as a node on the
///     /__--------__\         grid may be: off by no more than `few` cells. Everything around is swept as ever.
class speck_cover {
public:
    static constexpr float few = 8.0f;

    explicit speck_cover(memory source) noexcept : covered_{source} {}

    [[nodiscard]] bool empty() const noexcept { return covered_.empty(); }
    /// Whether it covers this component of the wavefront.
    [[nodiscard]] bool covers(std::uint32_t component) const noexcept { return !empty() && covered_[component]; }

    /// Covers a component, whose cells the wavefront still holds all.
    ///
    /// Fails  error::crossing_contours: it is no speck; error::out_of_memory
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

    /// Appends a cell for each of the given triangles that lies in a covered component. It goes with the longest edge
    /// of the region that it has.
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
    /// At level 0 edge i stands from node i to the next one of its loop.
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

    buffer<bool> covered_;  // of each component; empty: none is
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
