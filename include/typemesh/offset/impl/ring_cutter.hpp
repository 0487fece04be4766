// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Triangulates small simple polygons, and large ones that rise from one edge and come down to it. The cells of a
/// straight skeleton are such mountains over the edge that has swept them.
///
/// If a simple polygon is cut into counter-clockwise triangles, they cover it exactly once, however they were found
/// (their number over any point is the winding number of the boundary). So it is enough to test each triangle's own
/// orientation.
class ring_cutter {
public:
    explicit ring_cutter(memory source) noexcept : left_{source} {}

    /// Appends the triangles of a ring of 3 nodes or more. All are counter-clockwise, and none is flat.
    ///
    /// Fails  error::crossing_contours: no triangulation was found, so the ring is not simple; `out` is unchanged
    ///        error::out_of_memory
    /// Cost   O(n) for mountains; for others usually O(n^2), O(n^3) in the worst case
    [[nodiscard]] error operator()(const buffer<std::uint32_t>& ring, const buffer<swept_node>& nodes,
                                   triangle_list& out) noexcept
    {
        const std::size_t before = out.size();
        if (ring.size() == 4 && cut_quadrilateral(ring, nodes, out)) return error::none;
        if (out.append(ring.size() - 2) == nullptr || !left_.reserve(ring.size())) return error::out_of_memory;
        out.truncate(before);  // append() grows by more than requested, reserve() does not
        if (cut_mountain(ring, nodes, out)) return error::none;
        out.truncate(before);
        if (cut_ears(ring, nodes, out)) return error::none;
        out.truncate(before);
        return error::crossing_contours;
    }

private:
    static bool is_ear(const buffer<swept_node>& nodes, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        return orientation(nodes[a].at, nodes[b].at, nodes[c].at) > 0;
    }

    /// The result of cut_mountain() for most rings. False if more steps are needed, or if out of memory.
    static bool cut_quadrilateral(const buffer<std::uint32_t>& ring, const buffer<swept_node>& nodes,
                                  triangle_list& out) noexcept
    {
        std::size_t base = 0;
        std::int64_t longest = -1;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::int64_t size = squared_distance(nodes[ring[i]].at, nodes[ring[(i + 1) % 4]].at);
            if (size <= longest) continue;
            longest = size;
            base = i;
        }
        const std::uint32_t a = ring[(base + 1) % 4], b = ring[(base + 2) % 4], c = ring[(base + 3) % 4],
                            d = ring[base];
        if (!is_ear(nodes, a, b, c) || !is_ear(nodes, a, c, d)) return false;
        triangle* const two = out.append(2);
        if (two == nullptr) return false;
        two[0] = {a, b, c};
        two[1] = {a, c, d};
        return true;
    }

    /// Goes from the end of the longest edge around to its beginning, and cuts off every triangle that it can at once.
    bool cut_mountain(const buffer<std::uint32_t>& ring, const buffer<swept_node>& nodes, triangle_list& out) noexcept
    {
        const std::size_t n = ring.size();
        std::size_t base = 0;
        std::int64_t longest = -1;
        for (std::size_t i = 0; i < n; ++i) {
            const std::int64_t size = squared_distance(nodes[ring[i]].at, nodes[ring[i + 1 == n ? 0 : i + 1]].at);
            if (size <= longest) continue;
            longest = size;
            base = i;
        }
        left_.clear();
        for (std::size_t i = 1; i <= n; ++i) {
            const std::size_t at = base + i;
            const std::uint32_t c = ring[at < n ? at : at - n];
            while (left_.size() >= 2 && is_ear(nodes, left_[left_.size() - 2], left_.back(), c)) {
                out.push_back_unchecked({left_[left_.size() - 2], left_.back(), c});
                left_.truncate(left_.size() - 1);
            }
            left_.push_back_unchecked(c);
        }
        return left_.size() == 2;
    }

    /// Cuts off ears that hold no other node, as long as there are any.
    bool cut_ears(const buffer<std::uint32_t>& ring, const buffer<swept_node>& nodes, triangle_list& out) noexcept
    {
        left_.clear();
        for (const std::uint32_t node : ring) left_.push_back_unchecked(node);
        std::size_t i = 0, misses = 0;
        while (left_.size() > 3) {
            const std::size_t n = left_.size();
            if (misses++ > n) return false;
            if (++i >= n) i = 0;
            const std::uint32_t a = left_[i == 0 ? n - 1 : i - 1], b = left_[i], c = left_[i + 1 == n ? 0 : i + 1];
            if (!is_ear(nodes, a, b, c) || !is_empty(nodes, {a, b, c})) continue;
            out.push_back_unchecked({a, b, c});
            for (std::size_t k = i; k + 1 < n; ++k) left_[k] = left_[k + 1];
            left_.truncate(n - 1);
            misses = 0;
        }
        if (!is_ear(nodes, left_[0], left_[1], left_[2])) return false;
        out.push_back_unchecked({left_[0], left_[1], left_[2]});
        return true;
    }
    [[nodiscard]] bool is_empty(const buffer<swept_node>& nodes, triangle t) const noexcept
    {
        const grid_point a = nodes[t.a].at, b = nodes[t.b].at, c = nodes[t.c].at;
        for (const std::uint32_t node : left_) {
            const grid_point p = nodes[node].at;
            if (p == a || p == b || p == c) continue;
            if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return false;
        }
        return true;
    }

    buffer<std::uint32_t> left_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
