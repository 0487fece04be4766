// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An axis-aligned box on the grid; its edges belong to it. It is empty at first.
struct grid_box {
    grid_point low{0x7FFF'FFFF, 0x7FFF'FFFF};
    grid_point high{-0x7FFF'FFFF, -0x7FFF'FFFF};

    void add(grid_point p) noexcept { merge({p, p}); }
    void merge(const grid_box& b) noexcept
    {
        low = {b.low.x < low.x ? b.low.x : low.x, b.low.y < low.y ? b.low.y : low.y};
        high = {b.high.x > high.x ? b.high.x : high.x, b.high.y > high.y ? b.high.y : high.y};
    }
    /// Whether two boxes have a point in common.
    [[nodiscard]] bool meets(const grid_box& b) const noexcept
    {
        return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
    }
};

/// Boxes in a binary tree, to find those that meet a given box. Neighbours in the list share the lower nodes, so the
/// list should be in an order in which neighbours are near each other, such as the order along a contour.
///
///     nodes   [ - | root | 2 | 3 | ... | leaves ]      the children of node k are 2k and 2k + 1
///
/// Cost   O(n) to build. A query visits the nodes whose boxes meet the given box: O(log n + hits) along most contours,
///        O(n) at worst
class box_tree {
public:
    explicit box_tree(memory source = heap()) noexcept : nodes_{source} {}

    /// Makes room for `count` boxes, which are empty until set(). False if out of memory.
    [[nodiscard]] bool open(std::size_t count) noexcept
    {
        leaves_ = 1;
        while (leaves_ < count) leaves_ *= 2;
        nodes_.clear();
        grid_box* const all = nodes_.append(2 * leaves_);
        if (all == nullptr) return false;
        for (std::size_t i = 0; i < 2 * leaves_; ++i) all[i] = grid_box{};
        return true;
    }
    void set(std::size_t i, const grid_box& b) noexcept { nodes_[leaves_ + i] = b; }

    /// Call it when all boxes are set.
    void close() noexcept
    {
        for (std::size_t k = leaves_; k-- > 1;) {
            nodes_[k] = nodes_[2 * k];
            nodes_[k].merge(nodes_[2 * k + 1]);
        }
    }

    /// Calls found(i) for each box that meets `b`, in ascending order.
    template <class Found>
    void each_meeting(const grid_box& b, Found&& found) const noexcept
    {
        std::size_t waiting[64];
        std::size_t depth = 0;
        waiting[depth++] = 1;
        while (depth != 0) {
            const std::size_t k = waiting[--depth];
            if (!nodes_[k].meets(b)) continue;
            if (k >= leaves_) {
                found(k - leaves_);
                continue;
            }
            waiting[depth++] = 2 * k + 1;
            waiting[depth++] = 2 * k;
        }
    }

private:
    buffer<grid_box> nodes_;
    std::size_t leaves_ = 1;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
