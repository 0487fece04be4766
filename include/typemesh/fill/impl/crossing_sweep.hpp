// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/crossing.hpp>
#include <typemesh/fill/impl/net_edges.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/sweep/impl/sweep_status.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds every crossing of edges, exactly, without cutting them: a sweep that swaps neighbours.
///
///     f ---.__              |     Between two consecutive ends of edges (grid points), the sweep line crosses the same
///     e ____  '--.__ e      |     edges, which only change their order. Two of them swap where they cross, so the
///     |     '-----x--- f    |     crossings in between are the pairs in the wrong order there. Swapping neighbours in
///     p                     q     the wrong order until none are left swaps each such pair once, in any sequence.
///
/// So crossings are never compared with each other (this takes 160 bits), only with grid points: before p, in p or
/// after p. An integer suffices for that: the crossing's coordinates rounded down, doubled, plus one if they were
/// rounded.
///
/// Cost   O((n + k) log n) for n edges and k crossings, always; about 90 bytes per edge from `scratch`
/// Exact  crossing_place() and orientation(), in 64 bits
/// From   Bentley & Ottmann, Algorithms for reporting and counting geometric intersections (1979); Boissonnat &
///        Preparata, Robust plane sweep for intersecting segments (2000)
class crossing_sweep {
    struct intersection {
        std::int64_t place;
        grid_point nearest;
        std::uint32_t low;  // the slot of the lower edge; the upper edge is right above it
        bool is_exact;
    };

public:
    /// Calls met(x, is_exact) -> bool for every two edges that cross between their ends; x is the grid point nearest to
    /// the crossing. Stops when met() returns false. The result is then false, and also if out of memory. `edges` come
    /// from make_net_edges().
    template <class Met>
    [[nodiscard]] static bool run(array_view<const net_edge> edges, workspace::scope& scratch, workspace& space,
                                  Met&& met) noexcept
    {
        crossing_sweep sweep{edges};
        return sweep.open(scratch, space) && sweep.traverse(met);
    }

private:
    explicit crossing_sweep(array_view<const net_edge> edges) noexcept : edges_{edges} {}

    /// A grid point as a place that is comparable with the places of crossings.
    [[nodiscard]] static std::int64_t place_of(grid_point p) noexcept
    {
        return 2 * (std::int64_t{p.x} * (std::int64_t{1} << 32) + p.y);
    }

    [[nodiscard]] bool open(workspace::scope& scratch, workspace& space) noexcept
    {
        const std::size_t n = edges_.size();
        edge_in_ = scratch.take<std::uint32_t>(n + 1);
        slot_of_ = scratch.take<std::uint32_t>(n);
        heap_ = scratch.take<intersection>(n + 1);
        place_in_heap_ = scratch.take<std::uint32_t>(n + 1);
        by_end_ = scratch.take<std::uint32_t>(n);
        if (edge_in_ == nullptr || slot_of_ == nullptr || heap_ == nullptr || place_in_heap_ == nullptr ||
            by_end_ == nullptr || !status_.open(scratch, n))
            return false;
        workspace::scope sorting{space};
        auto* const ends = sorting.take<grid_point>(n);
        if (ends == nullptr) return false;
        for (std::size_t i = 0; i < n; ++i) ends[i] = edges_[i].to;
        return sweep_order({ends, n}, space, by_end_);
    }

    template <class Met>
    [[nodiscard]] bool traverse(Met&& met) noexcept
    {
        const std::size_t n = edges_.size();
        std::size_t starting = 0;
        for (std::size_t ending = 0; ending < n;) {
            grid_point p = edges_[by_end_[ending]].to;
            if (starting < n && lexicographic_less(edges_[starting].from, p)) p = edges_[starting].from;
            const std::int64_t here = place_of(p);
            while (heap_size_ != 0 && heap_[1].place < here)
                if (!swap(met)) return false;
            for (; ending < n && edges_[by_end_[ending]].to == p; ++ending) finish(slot_of_[by_end_[ending]]);
            while (heap_size_ != 0 && heap_[1].place == here)
                if (!swap(met)) return false;
            for (; starting < n && edges_[starting].from == p; ++starting) start(static_cast<std::uint32_t>(starting));
        }
        return true;
    }

    void start(std::uint32_t i) noexcept
    {
        const grid_point p = edges_[i].from, to = edges_[i].to;
        const std::uint32_t under = status_.last_below([&](std::uint32_t slot) noexcept {
            if (slot == 0) return false;
            const net_edge& e = edges_[edge_in_[slot]];
            const std::int64_t side = orientation(e.from, e.to, p);
            return side > 0 || (side == 0 && orientation(e.from, e.to, to) > 0);
        });
        std::uint32_t slot = free_slot_;
        if (slot == 0)
            slot = ++slot_count_;
        else
            free_slot_ = edge_in_[slot];
        edge_in_[slot] = i;
        slot_of_[i] = slot;
        place_in_heap_[slot] = 0;
        status_.insert_above(under, slot);
        look_up_from(under);
        look_up_from(slot);
    }

    void finish(std::uint32_t slot) noexcept
    {
        const std::uint32_t under = status_.below(slot);
        status_.erase(slot);
        forget(slot);
        edge_in_[slot] = free_slot_;
        free_slot_ = slot;
        look_up_from(under);
    }

    /// Takes the first intersection from the queue and swaps its edges.
    template <class Met>
    [[nodiscard]] bool swap(Met&& met) noexcept
    {
        const intersection first = heap_[1];
        const std::uint32_t low = first.low, high = status_.above(low), rising = edge_in_[low];
        edge_in_[low] = edge_in_[high];
        edge_in_[high] = rising;
        slot_of_[edge_in_[low]] = low;
        slot_of_[rising] = high;
        look_up_from(low);
        look_up_from(status_.below(low));
        look_up_from(high);
        return met(first.nearest, first.is_exact);
    }

    /// Queues the crossing of the edge in a slot with the edge right above it, if there is one.
    void look_up_from(std::uint32_t low) noexcept
    {
        const std::uint32_t high = status_.above(low);
        if (low == 0) return;
        forget(low);
        if (high == 0) return;
        const net_edge &l = edges_[edge_in_[low]], &h = edges_[edge_in_[high]];
        if (orientation(h.from, h.to, l.to) <= 0 && orientation(l.from, l.to, h.to) >= 0) return;
        const auto [share, whole] = share_of(l.from, l.to, h.from, h.to);
        if (whole == 0 || orientation(h.from, h.to, l.to) < 0) return;
        const quotient x = scaled(std::int64_t{l.to.x} - l.from.x, share, whole);
        const quotient y = scaled(std::int64_t{l.to.y} - l.from.y, share, whole);
        intersection m;
        m.nearest = {static_cast<std::int32_t>(l.from.x + x.nearest()),
                     static_cast<std::int32_t>(l.from.y + y.nearest())};
        m.place = (2 * (l.from.x + x.floor) + !x.is_exact()) * (std::int64_t{1} << 32) +
                  (x.is_exact() ? 2 * (l.from.y + y.floor) + !y.is_exact() : 0);
        m.low = low;
        m.is_exact = x.is_exact() && y.is_exact();
        rise(++heap_size_, m);
    }

    void forget(std::uint32_t low) noexcept
    {
        const std::uint32_t at = place_in_heap_[low];
        if (at == 0) return;
        place_in_heap_[low] = 0;
        const intersection last = heap_[heap_size_--];
        if (at > heap_size_) return;
        if (at > 1 && last.place < heap_[at / 2].place)
            rise(at, last);
        else
            sink(at, last);
    }

    void put(std::uint32_t at, const intersection& m) noexcept
    {
        heap_[at] = m;
        place_in_heap_[m.low] = at;
    }
    void rise(std::uint32_t at, const intersection& m) noexcept
    {
        for (; at > 1 && m.place < heap_[at / 2].place; at /= 2) put(at, heap_[at / 2]);
        put(at, m);
    }
    void sink(std::uint32_t at, const intersection& m) noexcept
    {
        for (std::uint32_t child = 2 * at; child <= heap_size_; child = 2 * at) {
            if (child < heap_size_ && heap_[child + 1].place < heap_[child].place) ++child;
            if (m.place <= heap_[child].place) break;
            put(at, heap_[child]);
            at = child;
        }
        put(at, m);
    }

    array_view<const net_edge> edges_;
    sweep_status status_;
    std::uint32_t* edge_in_ = nullptr;  // for every slot; for a free slot the next free one
    std::uint32_t* slot_of_ = nullptr;
    std::uint32_t* by_end_ = nullptr;         // the edges in the order of their ends
    intersection* heap_ = nullptr;            // from 1; the first one at the top
    std::uint32_t* place_in_heap_ = nullptr;  // for each slot, its intersection's position; 0: none
    std::uint32_t heap_size_ = 0;
    std::uint32_t slot_count_ = 0;
    std::uint32_t free_slot_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
