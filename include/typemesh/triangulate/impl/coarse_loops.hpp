// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Loops without the points that only smooth them, and the order in which those points return: coarse to fine, each
/// point halving a subrange.
///
///        4          A subrange runs from one kept point to the next. It ends before an edge turns away from its first
///     2     6       edge by a set angle. Of its points 1, 2, 3, ... those divisible by the highest power of two return
///    1 3   5 7      first. Point i is then inserted between i - (its lowest bit) and the point that comes next there.
///   0         8
///
/// If fewer than three points of a loop would be kept, all are kept. 20 bytes per point.
class coarse_loops {
public:
    static constexpr std::int64_t keep_all = -1;

    /// No edge turns away from the first edge of its subrange by 1 / `straightness` or more (as a tangent); with
    /// keep_all no point is left out. `sheared` moves points by x -> 5x + 2y. For a sweep the loops stay the same, but
    /// few points lie on one vertical line. False if out of memory.
    [[nodiscard]] bool take(workspace::scope& scratch, array_view<const grid_point> points,
                            array_view<const std::uint32_t> starts, std::int64_t straightness, bool sheared) noexcept
    {
        const std::size_t n = points.size();
        places_ = scratch.take<grid_point>(n);
        names_ = scratch.take<std::uint32_t>(n);
        starts_ = scratch.take<std::uint32_t>(starts.size());
        left_out_ = scratch.take<left_out>(n);
        if (places_ == nullptr || names_ == nullptr || starts_ == nullptr || left_out_ == nullptr) return false;
        for (std::uint32_t& head : first_of_level_) head = none;
        loops_ = starts.size() - 1;
        size_ = 0;
        for (std::size_t l = 0; l < loops_; ++l) {
            starts_[l] = size_;
            thin_out(points.data(), starts[l], starts[l + 1], straightness);
        }
        starts_[loops_] = size_;
        if (sheared)
            for (std::uint32_t i = 0; i < size_; ++i) places_[i].x = 5 * places_[i].x + 2 * places_[i].y;
        return true;
    }

    [[nodiscard]] array_view<const grid_point> points() const noexcept { return {places_, size_}; }
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return {starts_, loops_ + 1}; }
    /// The original indices of these points.
    [[nodiscard]] const std::uint32_t* names() const noexcept { return names_; }

    /// Calls f(point before it on the boundary, point) for each point left out, coarse to fine. If f returns false,
    /// stops and returns false.
    template <class F>
    [[nodiscard]] bool bring_back(F&& f) const noexcept
    {
        for (std::uint32_t level = levels; level-- != 0;)
            for (std::uint32_t v = first_of_level_[level]; v != none; v = left_out_[v].next)
                if (!f(left_out_[v].before, v)) return false;
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0}, levels = 32;
    struct left_out {
        std::uint32_t before;
        std::uint32_t next;
    };

    void thin_out(const grid_point* points, std::uint32_t begin, std::uint32_t end, std::int64_t straightness) noexcept
    {
        if (straightness == keep_all) return keep(points, begin, end);
        const std::uint32_t kept_before = size_;
        std::uint32_t step = 0;
        std::int64_t dx = 0, dy = 0, x = points[begin].x, y = points[begin].y;
        for (std::uint32_t v = begin; v < end; ++v) {  // it is unpredictable which points are kept: no branches
            const grid_point q = points[v + 1 == end ? begin : v + 1];
            const std::int64_t ex = q.x - x, ey = q.y - y;
            const std::int64_t cross = dx * ey - dy * ex, dot = dx * ex + dy * ey;
            const bool keep = straightness * (cross < 0 ? -cross : cross) >= dot;  // <= 2^62: straightness is at most 8
            names_[size_] = v;
            places_[size_] = points[v];
            size_ += keep;
            dx = keep ? ex : dx;
            dy = keep ? ey : dy;
            step = keep ? 0 : step + 1;
            // 32 for kept points: that list is never read.
            const auto level = static_cast<std::uint32_t>(std::countr_zero(step));
            left_out_[v] = {v - (step & (0 - step)), first_of_level_[level]};
            first_of_level_[level] = v;
            x = q.x;
            y = q.y;
        }
        if (size_ - kept_before >= 3) return;
        size_ = kept_before;
        for (std::uint32_t& head : first_of_level_)
            while (head != none && head >= begin) head = left_out_[head].next;
        keep(points, begin, end);
    }

    void keep(const grid_point* points, std::uint32_t begin, std::uint32_t end) noexcept
    {
        for (std::uint32_t v = begin; v < end; ++v) {
            names_[size_] = v;
            places_[size_++] = points[v];
        }
    }

    grid_point* places_ = nullptr;
    std::uint32_t* names_ = nullptr;
    std::uint32_t* starts_ = nullptr;
    left_out* left_out_ = nullptr;
    std::size_t loops_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t first_of_level_[levels + 1];
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
