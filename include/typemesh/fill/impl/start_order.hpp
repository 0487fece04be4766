// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/event_queue.hpp>
#include <typemesh/fill/impl/ray.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The segments that start in one point of a sweep, from bottom to top. Segments that lie upon each other are joined.
class start_order {
public:
    bool full = false;     ///< there was no capacity left
    bool rough = false;    ///< bent segments lie upon each other
    bool partial = false;  ///< edges cancel in part

    start_order(arrangement& a, event_queue& queue, std::int32_t mask) noexcept : a_{a}, queue_{queue}, mask_{mask} {}

    /// Takes memory for `most` segments in one point. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::uint32_t most) noexcept
    {
        max_starts_ = most;
        rays_ = scratch.take<ray>(most);
        starts_ = scratch.take<std::uint32_t>(std::size_t{most} + 2);
        return rays_ != nullptr && starts_ != nullptr;
    }

    [[nodiscard]] const std::uint32_t* all() const noexcept { return starts_; }

    /// Lists the segments that start in p in all(), from bottom to top, each direction once. Returns their number.
    [[nodiscard]] std::uint32_t put_in_order(std::uint32_t starting, grid_point p) noexcept
    {
        if (starting == no_number) return 0;
        const segment* const all = a_.segments;
        const auto ray_to = [&](std::uint32_t i) noexcept -> ray { return {all[i].to.x - p.x, all[i].to.y - p.y, i}; };
        starts_[0] = starting;
        const std::uint32_t second = all[starting].next;
        if (second == no_number) return 1;
        if (all[second].next == no_number) {
            const std::int64_t turn = ray_to(starting).cross(ray_to(second));
            if (turn != 0) {
                starts_[turn < 0] = starting;
                starts_[turn > 0] = second;
                return 2;
            }
        }
        std::uint32_t count = 0;
        for (std::uint32_t i = starting; i != no_number; i = all[i].next) {
            if (count == max_starts_) {
                full = true;
                return 0;
            }
            rays_[count++] = ray_to(i);
        }
        sort_rays(rays_, count);
        std::uint32_t kept = 0;
        cancelled_ = uneven_ = false;
        whole_ = true;
        for (std::uint32_t i = 1; i < count && !full; ++i) {
            if (rays_[kept].cross(rays_[i]) != 0) {
                rays_[++kept] = rays_[i];
                whole_ = true;
            } else {
                rays_[kept].segment = joined(rays_[kept].segment, rays_[i].segment);
            }
        }
        partial |= cancelled_ && uneven_;
        count = 0;
        for (std::uint32_t i = 0; i <= kept; ++i)
            if (all[rays_[i].segment].winding_delta != 0) starts_[count++] = rays_[i].segment;
        return count;
    }

private:
    [[nodiscard]] bool is_whole(const segment& s) const noexcept
    {
        const auto [a, b] = a_.home(s);
        return (s.from == a && s.to == b) || (s.from == b && s.to == a);
    }

    /// Joins two segments that start in one point in one direction. Their common part becomes one of them, which is
    /// returned; the rest of the longer segment becomes the other.
    [[nodiscard]] std::uint32_t joined(std::uint32_t i, std::uint32_t k) noexcept
    {
        if (sweep_place(a_.segments[k].to) < sweep_place(a_.segments[i].to)) {
            const std::uint32_t swapped = i;
            i = k;
            k = swapped;
        }
        segment& shorter = a_.segments[i];
        segment& longer = a_.segments[k];
        const bool equal = shorter.to == longer.to;
        rough |= (shorter.bent | longer.bent) != 0;
        uneven_ |= !equal;
        whole_ = whole_ && is_whole(shorter) && is_whole(longer);  // before one takes the other's origin
        const std::int32_t winding_delta = shorter.winding_delta;
        const float t = equal ? longer.source.t1 : longer.t_at(shorter.to);
        if (longer.source.curve < shorter.source.curve) {
            shorter.source = {longer.source.curve, longer.source.t0, t};
            shorter.origin = longer.origin;
            shorter.target = longer.target;
            shorter.bent |= longer.bent;
        }
        shorter.winding_delta += longer.winding_delta;
        if ((shorter.winding_delta & mask_) == 0) {
            partial |= shorter.winding_delta != 0 || !whole_;
            cancelled_ = true;
        }
        shorter.interior = longer.interior = 0;  // from an earlier sweep: one of them may not count any more
        if (equal) {
            longer.winding_delta = 0;
        } else if (queue_.room() == 0) {
            shorter.winding_delta = winding_delta;
            full = true;
        } else {
            longer.from = shorter.to;
            longer.source.t0 = t;
            queue_.push({sweep_place(longer.from), k, 0});
        }
        return i;
    }

    arrangement& a_;
    event_queue& queue_;
    std::int32_t mask_;  // of winding numbers
    ray* rays_ = nullptr;
    std::uint32_t* starts_ = nullptr;
    std::uint32_t max_starts_ = 0;
    bool cancelled_ = false, uneven_ = false;  // in this point
    bool whole_ = true;                        // all segments joined so far in this direction are edges of the contours
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
