// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/swept_edge.hpp>
#include <typemesh/sweep/impl/sweep_status.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The edges that the sweep line crosses, from bottom to top, each in its own slot. Slot 0 marks both ends of the list;
/// its edge ends beyond all points.
class sweep_line {
public:
    static constexpr grid_point beyond{1 << 29, 1 << 29};  ///< after all points of the grid

    /// Takes memory for `most` edges. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::uint32_t most) noexcept
    {
        most_ = most;
        edges_ = scratch.take<swept_edge>(std::size_t{most} + 1);
        if (edges_ == nullptr || !order_.open(scratch, most)) return false;
        edges_[0] = {};
        edges_[0].from = edges_[0].to = beyond;
        return true;
    }

    [[nodiscard]] swept_edge& operator[](std::uint32_t slot) noexcept { return edges_[slot]; }
    [[nodiscard]] const swept_edge& operator[](std::uint32_t slot) const noexcept { return edges_[slot]; }
    [[nodiscard]] std::uint32_t below(std::uint32_t slot) const noexcept { return order_.below(slot); }
    [[nodiscard]] std::uint32_t above(std::uint32_t slot) const noexcept { return order_.above(slot); }
    [[nodiscard]] bool empty() const noexcept { return order_.above(0) == 0; }
    /// The number of edges that may still be inserted.
    [[nodiscard]] std::uint32_t room() const noexcept { return most_ - order_.size(); }

    /// The last edge below p.
    [[nodiscard]] std::uint32_t find(grid_point p) noexcept
    {
        return order_.last_below(
            [&](std::uint32_t s) noexcept { return s != 0 && orientation(edges_[s].from, edges_[s].to, p) > 0; });
    }

    /// Inserts a slot right above `under`, for an edge that begins later: see sweep_status. Precondition: room() > 0.
    [[nodiscard]] std::uint32_t insert_above(std::uint32_t under) noexcept
    {
        std::uint32_t slot = free_slot_;
        if (slot == 0)
            slot = ++slot_count_;
        else
            free_slot_ = static_cast<std::uint32_t>(edges_[slot].from.y);
        order_.insert_above(under, slot);
        return slot;
    }

    /// Anything that still refers to the slot finds an edge that ends beyond all points.
    void erase(std::uint32_t slot) noexcept
    {
        edges_[slot].to = beyond;
        edges_[slot].from = {0, static_cast<std::int32_t>(free_slot_)};
        free_slot_ = slot;
        order_.erase(slot);
    }

private:
    swept_edge* edges_ = nullptr;
    sweep_status order_;
    std::uint32_t most_ = 0;
    std::uint32_t slot_count_ = 0;
    std::uint32_t free_slot_ = 0;
};

/// The edges that end and start in one point of a sweep.
struct point_event {
    grid_point at;
    std::uint32_t starting;             // the first segment that starts; the others follow by `next`
    std::uint32_t under = 0, over = 0;  // the edges right below and right above all that end
    std::uint32_t ending_count = 0;     // the number of edges that end
    std::uint32_t place_count = 0;      // in the status between `under` and `over`
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
