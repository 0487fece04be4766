// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Grid points in a tree of boxes. It finds the points whose pixels a segment passes through.
///
///      +-------------------+       The points are ordered by their interleaved bits (Z order), four to a leaf. Every
///      | 1  .  | .  2      |       node holds the box of consecutive leaves. If a segment misses a box by more than a
///      |   .   |      . -..|--     cell, the box is skipped with all its content.
///      |-------.---.-'-----|
///      |  __.-'|    4    . |       The pixel of a point p is half open, [-1/2, 1/2)^2 around p. A segment passes
///      | 3 .   |  .        |       through it if |2 s| < |dx| + |dy| for s = orientation(from, to, p), or touches the
///      +-------------------+       pixel in the one corner that belongs to it.
///
/// Build  O(m log m) for m points, 50 bytes per point. Query: O(sqrt m) boxes for scattered points, O(m) in the worst
///        case (points along the segment, beside it), and O(hits log hits) to sort them.
/// Exact  |coordinate| <= 2^28: s < 2^61, its double < 2^62.
/// From   Morton, A computer oriented geodetic data base (1966)
class hot_pixels {
    struct box {
        std::int32_t left, right, bottom, top;
    };
    static constexpr std::uint32_t leaf = 4;

public:
    /// A point, by its index in the input, and whether the segment passes through the point itself.
    struct hit {
        std::uint32_t number;
        bool is_exact;
    };

    /// False if out of memory. The points are distinct.
    [[nodiscard]] bool open(array_view<const grid_point> points, workspace::scope& scratch, workspace& space) noexcept
    {
        count_ = points.size();
        if (count_ == 0) return true;
        leaves_ = std::bit_ceil((count_ + leaf - 1) / leaf);
        points_ = scratch.take<grid_point>(count_);
        numbers_ = scratch.take<std::uint32_t>(count_);
        boxes_ = scratch.take<box>(2 * leaves_);
        hits_ = scratch.take<wide_sweep_key>(count_);
        workspace::scope sorting{space};
        auto* const keys = sorting.take<wide_sweep_key>(count_);
        auto* const spare = sorting.take<wide_sweep_key>(count_);
        if (points_ == nullptr || numbers_ == nullptr || boxes_ == nullptr || hits_ == nullptr || keys == nullptr ||
            spare == nullptr)
            return false;
        box all{points[0].x, points[0].x, points[0].y, points[0].y};
        for (const grid_point p : points) grow(all, {p.x, p.x, p.y, p.y});
        // Both sides get equally many bits: otherwise the boxes of a flat set would be columns of its full height.
        const auto bits = [](std::int32_t side) noexcept {
            return 32 - static_cast<std::uint32_t>(std::countl_zero(static_cast<std::uint32_t>(side)));
        };
        const std::uint32_t wide = bits(all.right - all.left), high = bits(all.top - all.bottom);
        const std::uint32_t up_x = wide < high ? high - wide : 0, up_y = high < wide ? wide - high : 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const auto x = static_cast<std::uint32_t>(points[i].x - all.left) << up_x,
                       y = static_cast<std::uint32_t>(points[i].y - all.bottom) << up_y;
            keys[i] = {spread(x) << 1 | spread(y), static_cast<std::uint32_t>(i)};
        }
        const wide_sweep_key* const sorted = sort_sweep_keys(keys, spare, count_, 0, 60);
        for (std::size_t i = 0; i < count_; ++i) {
            numbers_[i] = sorted[i].index;
            points_[i] = points[sorted[i].index];
        }
        for (std::size_t node = 2 * leaves_; --node != 0;) boxes_[node] = node >= leaves_ ? of(node) : both(node);
        return true;
    }

    /// Calls met(hit) for every point, except the segment's ends, whose pixel the segment passes through, in the order
    /// along the segment. If met() returns false, stops and returns false. `from` precedes `to` in sweep order.
    template <class Met>
    [[nodiscard]] bool along(grid_point from, grid_point to, Met&& met) noexcept
    {
        if (count_ == 0) return true;
        const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
        const box around{from.x, to.x, dy < 0 ? to.y : from.y, dy < 0 ? from.y : to.y};
        const std::int64_t reach = dx + (dy < 0 ? -dy : dy);
        std::size_t hit_count = 0;
        for (std::size_t node = 1;;) {
            const box& b = boxes_[node];
            const bool far_off = b.left > around.right || b.right < around.left || b.bottom > around.top ||
                                 b.top < around.bottom ||
                                 orientation(from, to, {dy < 0 ? b.right : b.left, b.top}) < -reach ||
                                 orientation(from, to, {dy < 0 ? b.left : b.right, b.bottom}) > reach;
            if (!far_off && node < leaves_) {
                node *= 2;
                continue;
            }
            if (!far_off) {
                const std::size_t begin = (node - leaves_) * leaf, end = begin + leaf < count_ ? begin + leaf : count_;
                for (std::size_t i = begin; i < end; ++i) {
                    const grid_point p = points_[i];
                    if (holds(around, p) && comes_through(from, to, p) && !(p == from) && !(p == to))
                        hits_[hit_count++] = {key(p, dy < 0), static_cast<std::uint32_t>(i)};
                }
            }
            while (node % 2 == 1) node /= 2;  // the last child: its whole parent is done
            if (node == 0) break;
            ++node;
        }
        if (hit_count > 1) {
            if (hit_count <= 16)
                insertion_sort(hits_, hit_count);
            else
                heap_sort(hits_, hit_count);
        }
        for (std::size_t i = 0; i < hit_count; ++i)
            if (!met(hit{numbers_[hits_[i].index], orientation(from, to, points_[hits_[i].index]) == 0})) return false;
        return true;
    }

    [[nodiscard]] static bool comes_through(grid_point from, grid_point to, grid_point p) noexcept
    {
        const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
        const std::int64_t side = 2 * orientation(from, to, p), reach = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
        if (side >= reach || side <= -reach) return side == dx - dy && (side == reach || side == -reach);
        return true;
    }

private:
    /// Spreads 30 bits to every other bit of 60.
    [[nodiscard]] static std::uint64_t spread(std::uint64_t v) noexcept
    {
        v = (v | v << 16) & 0x0000'FFFF'0000'FFFFu;
        v = (v | v << 8) & 0x00FF'00FF'00FF'00FFu;
        v = (v | v << 4) & 0x0F0F'0F0F'0F0F'0F0Fu;
        v = (v | v << 2) & 0x3333'3333'3333'3333u;
        return (v | v << 1) & 0x5555'5555'5555'5555u;
    }
    [[nodiscard]] static bool holds(const box& b, grid_point p) noexcept
    {
        return p.x >= b.left && p.x <= b.right && p.y >= b.bottom && p.y <= b.top;
    }
    /// Orders by x, then along the segment in y.
    [[nodiscard]] static std::uint64_t key(grid_point p, bool falling) noexcept
    {
        const auto y = static_cast<std::uint32_t>(p.y) ^ 0x8000'0000u;
        return std::uint64_t{static_cast<std::uint32_t>(p.x) ^ 0x8000'0000u} << 32 | (falling ? ~y : y);
    }
    [[nodiscard]] box of(std::size_t node) const noexcept
    {
        constexpr std::int32_t beyond = 1 << 29;
        box b{beyond, -beyond, beyond, -beyond};
        const std::size_t begin = (node - leaves_) * leaf;
        for (std::size_t i = begin; i < begin + leaf && i < count_; ++i) {
            const grid_point p = points_[i];
            grow(b, {p.x, p.x, p.y, p.y});
        }
        return b;
    }
    [[nodiscard]] box both(std::size_t node) const noexcept
    {
        box b = boxes_[2 * node];
        grow(b, boxes_[2 * node + 1]);
        return b;
    }
    static void grow(box& b, const box& more) noexcept
    {
        b = {more.left < b.left ? more.left : b.left, more.right > b.right ? more.right : b.right,
             more.bottom < b.bottom ? more.bottom : b.bottom, more.top > b.top ? more.top : b.top};
    }

    grid_point* points_ = nullptr;
    box* boxes_ = nullptr;              // 1: the root; the children of i are 2 i and 2 i + 1
    std::uint32_t* numbers_ = nullptr;  // the points' indices in the input
    wide_sweep_key* hits_ = nullptr;
    std::size_t count_ = 0;
    std::size_t leaves_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
