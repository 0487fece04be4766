// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/sweep_status.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/crossing.hpp>
#include <typemesh/fill/growing.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::detail {

/// Finds where stretches cross without cutting them: a sweep that swaps neighbours.
///
///     f ---.__            Two neighbours that will cross wait at the grid point nearest to their crossing. When the
///     e ____  '--.__ e    sweep comes there and they are neighbours still, they change places, and each is tested
///           '-----x--- f  against its new neighbour.
///
/// Crossings in one cell may come in the wrong order, and a point that is sought beside them may be put among the wrong
/// edges. So a crossing may be missed within a cell or so of other points; none is made up. Two edges change places
/// once at most, when the lower one rises through the upper one: O((n + k) log n) for n edges and k crossings, always.
///
/// Exact but for that order: orientation() and crossing_of(), in 64 bits.
/// From   Bentley & Ottmann, Algorithms for reporting and counting geometric intersections (1979)
class crossing_sweep {
    struct meeting {
        std::int64_t place;
        std::uint32_t low, high;  // stretches
        [[nodiscard]] bool before(const meeting& other) const noexcept { return place < other.place; }
    };

public:
    /// The crossings of an arrangement as take_apart() leaves it, each once, appended to `out`. False when there is no
    /// memory.
    [[nodiscard]] static bool run(const arrangement& a, workspace::scope& scratch, growing<grid_point>& out) noexcept
    {
        crossing_sweep sweep{a, scratch, out};
        return sweep.sweep(scratch);
    }

private:
    explicit crossing_sweep(const arrangement& a, workspace::scope& scratch, growing<grid_point>& out) noexcept
        : a_{a}, out_{out}, queue_{scratch}
    {
    }

    [[nodiscard]] bool sweep(workspace::scope& scratch) noexcept
    {
        stretch_in_ = scratch.take<std::uint32_t>(std::size_t{a_.count} + 1);
        slot_of_ = scratch.take<std::uint32_t>(a_.count);
        auto* const ending = scratch.take<std::uint32_t>(a_.point_count);     // the first stretch that ends in a point
        auto* const next_ending = scratch.take<std::uint32_t>(a_.count);
        if (stretch_in_ == nullptr || slot_of_ == nullptr || ending == nullptr || next_ending == nullptr ||
            !status_.open(scratch, a_.count))
            return false;
        stretch_in_[0] = no_number;
        for (std::uint32_t i = 0; i < a_.point_count; ++i) ending[i] = no_number;
        for (std::uint32_t i = 0; i < a_.count; ++i) {
            next_ending[i] = ending[a_.stretches[i].end];
            ending[a_.stretches[i].end] = i;
        }
        for (std::uint32_t v = 0; v < a_.point_count; ++v) {
            const std::int64_t place = sweep_place(a_.points[v]);
            while (queue_.count != 0 && queue_.values[0].place <= place)
                if (!swap(pop())) return false;
            for (std::uint32_t i = ending[v]; i != no_number; i = next_ending[i]) {
                const std::uint32_t slot = slot_of_[i], under = status_.below(slot), over = status_.above(slot);
                status_.erase(slot);
                stretch_in_[slot] = free_slot_;
                free_slot_ = slot;
                slot_of_[i] = 0;  // a meeting that still waits finds nothing in there
                if (!test(under, over)) return false;
            }
            for (std::uint32_t i = a_.first[v]; i != no_number; i = a_.stretches[i].next)
                if (!start(i, a_.points[v])) return false;
        }
        return true;
    }

    [[nodiscard]] bool start(std::uint32_t i, grid_point p) noexcept
    {
        const grid_point to = a_.stretches[i].to;
        const std::uint32_t under = status_.last_below([&](std::uint32_t slot) noexcept {
            if (slot == 0) return false;
            const stretch& s = a_.stretches[stretch_in_[slot]];
            const std::int64_t side = orientation(s.from, s.to, p);
            return side > 0 || (side == 0 && orientation(s.from, s.to, to) > 0);
        });
        std::uint32_t slot = free_slot_;
        if (slot == 0)
            slot = ++slot_count_;
        else
            free_slot_ = stretch_in_[slot];
        stretch_in_[slot] = i;
        slot_of_[i] = slot;
        status_.insert_above(under, slot);
        return test(under, slot) && test(slot, status_.above(slot));
    }

    [[nodiscard]] bool swap(const meeting& m) noexcept
    {
        const std::uint32_t low = slot_of_[m.low], high = slot_of_[m.high];
        if (stretch_in_[low] != m.low || stretch_in_[high] != m.high || status_.above(low) != high) return true;
        grid_point x;
        const stretch &l = a_.stretches[m.low], &h = a_.stretches[m.high];
        if (crossing_of(l.from, l.to, h.from, h.to, x) && !out_.add(x)) return false;
        stretch_in_[low] = m.high;
        stretch_in_[high] = m.low;
        slot_of_[m.high] = low;
        slot_of_[m.low] = high;
        return test(status_.below(low), low) && test(high, status_.above(high));
    }

    /// Neighbours wait for their crossing when the lower one rises through the upper one.
    [[nodiscard]] bool test(std::uint32_t low, std::uint32_t high) noexcept
    {
        if (low == 0 || high == 0) return true;
        const std::uint32_t i = stretch_in_[low], k = stretch_in_[high];
        const stretch &l = a_.stretches[i], &h = a_.stretches[k];
        grid_point x;
        if (!crossing_of(l.from, l.to, h.from, h.to, x) || orientation(h.from, h.to, l.to) < 0) return true;
        return push({sweep_place(x), i, k});
    }

    [[nodiscard]] bool push(const meeting& m) noexcept
    {
        if (!queue_.add(m)) return false;
        std::size_t i = queue_.count - 1;
        for (; i != 0 && m.before(queue_.values[(i - 1) / 2]); i = (i - 1) / 2)
            queue_.values[i] = queue_.values[(i - 1) / 2];
        queue_.values[i] = m;
        return true;
    }
    [[nodiscard]] meeting pop() noexcept
    {
        const meeting first = queue_.values[0], last = queue_.values[--queue_.count];
        std::size_t i = 0;
        for (std::size_t child = 1; child < queue_.count; child = 2 * i + 1) {
            if (child + 1 < queue_.count && queue_.values[child + 1].before(queue_.values[child])) ++child;
            if (!queue_.values[child].before(last)) break;
            queue_.values[i] = queue_.values[child];
            i = child;
        }
        if (queue_.count != 0) queue_.values[i] = last;
        return first;
    }

    const arrangement& a_;
    growing<grid_point>& out_;
    growing<meeting> queue_;
    sweep_status status_;
    std::uint32_t* stretch_in_ = nullptr;  // of every slot; the next free one of a free slot
    std::uint32_t* slot_of_ = nullptr;     // 0: ended
    std::uint32_t slot_count_ = 0;
    std::uint32_t free_slot_ = 0;
};

}  // namespace typemesh::detail
