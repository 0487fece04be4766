// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/sweep/impl/sweep_status.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The winding numbers on both sides of a contour that meets no other.
struct contour_sides {
    std::int32_t outside = 0;  ///< just outside it
    std::int32_t inside = 0;   ///< just inside it
    bool counter_clockwise = false;
};

/// Sweeps from left to right over unproven contours: finds whether any two edges meet and, if none do, the winding
/// numbers on both sides of every contour.
///
/// The sweep line crosses edges, ordered from bottom to top. Every point is tested strictly against the edge below and
/// the edge above it. This finds every intersection (triangulate/impl/monotone_sweep.hpp gives the reason). The winding
/// numbers on both sides of a contour are known where the sweep first meets it: from the edge right below.
///
///        k ---------------     outside of l = above that edge of k = inside or outside of k, by that edge's direction
///               l  .---
///                 p            inside of l = outside of l + 1 if l turns left in p, otherwise - 1
///                  '---
///        k --------------- e   the edge right below
class simple_sweep {
    struct vertex {
        std::uint32_t slot[2];   // of the edge from the left: 0 from the previous point, 1 from the next
        std::uint32_t other[2];  // the next point, the previous point
    };
    struct crossed_edge {
        grid_point from, to;  // from left to right
        std::uint32_t contour;
        bool backwards;  // the contour traverses it from right to left
    };

public:
    /// `sides` has loops.contour_count() elements; the points are sorted. Fails with crossing_contours, out_of_memory.
    [[nodiscard]] error run(const contours& loops, workspace& space, contour_sides* sides) noexcept
    {
        const std::size_t n = loops.points.size();
        if (n == 0) return error::none;
        points_ = loops.points.data();
        workspace::scope scratch{space};
        const array_view<const std::uint32_t> order = loops.order();
        TYPEMESH_ASSERT(order.size() == n, "the points of contours are not sorted: call sort_points() first");
        vertices_ = scratch.take<vertex>(n);
        contour_of_ = scratch.take<std::uint32_t>(n);
        edges_ = scratch.take<crossed_edge>(n + 1);
        met_ = scratch.take<bool>(loops.contour_count());
        if (vertices_ == nullptr || contour_of_ == nullptr || edges_ == nullptr || met_ == nullptr ||
            !status_.open(scratch, n))
            return error::out_of_memory;
        sides_ = sides;
        for (std::uint32_t c = 0; c < loops.contour_count(); ++c) {
            met_[c] = false;
            const std::uint32_t begin = loops.starts[c], end = loops.starts[c + 1];
            for (std::uint32_t v = begin; v < end; ++v) {
                vertices_[v] = {{0, 0}, {v + 1 < end ? v + 1 : begin, v > begin ? v - 1 : end - 1}};
                contour_of_[v] = c;
            }
        }

        grid_point last{-(1 << 28) - 1, 0};  // not on the grid
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t v = order[i];
            const grid_point p = points_[v];
            if (p == last) return error::crossing_contours;
            last = p;
            const std::uint32_t a = vertices_[v].slot[0], b = vertices_[v].slot[1];
            const bool clear = a == 0 && b == 0   ? open(v, p)
                               : a != 0 && b != 0 ? close(a, b, p)
                                                  : pass(a | b, a == 0, v, p);
            if (!clear) return error::crossing_contours;
        }
        return error::none;
    }

private:
    [[nodiscard]] bool above(std::uint32_t slot, grid_point p) const noexcept
    {
        return slot == 0 || orientation(edges_[slot].from, edges_[slot].to, p) > 0;
    }
    [[nodiscard]] bool below(std::uint32_t slot, grid_point p) const noexcept
    {
        return slot == 0 || orientation(edges_[slot].from, edges_[slot].to, p) < 0;
    }

    void set_edge(std::uint32_t slot, std::uint32_t back, std::uint32_t v, grid_point p) noexcept
    {
        const std::uint32_t end = vertices_[v].other[back];
        edges_[slot] = {p, points_[end], contour_of_[v], back != 0};
        vertices_[end].slot[back] = slot;
    }

    [[nodiscard]] bool pass(std::uint32_t slot, std::uint32_t back, std::uint32_t v, grid_point p) noexcept
    {
        if (!above(status_.below(slot), p) || !below(status_.above(slot), p)) return false;
        set_edge(slot, back, v, p);
        return true;
    }

    [[nodiscard]] bool open(std::uint32_t v, grid_point p) noexcept
    {
        const std::int64_t turn = orientation(points_[vertices_[v].other[1]], p, points_[vertices_[v].other[0]]);
        if (turn == 0) return false;  // doubles back
        const std::uint32_t under =
            status_.last_below([&](std::uint32_t slot) noexcept { return slot != 0 && above(slot, p); });
        if (!below(status_.above(under), p)) return false;
        if (const std::uint32_t c = contour_of_[v]; !met_[c]) {
            met_[c] = true;
            std::int32_t outside = 0;
            if (under != 0) {
                const crossed_edge& e = edges_[under];
                const contour_sides& k = sides_[e.contour];
                outside = e.backwards == k.counter_clockwise ? k.outside : k.inside;
            }
            sides_[c] = {outside, outside + (turn > 0 ? 1 : -1), turn > 0};
        }
        const std::uint32_t low = take_slot(), high = take_slot(), low_runs_back = turn > 0 ? 0 : 1;
        set_edge(low, low_runs_back, v, p);
        set_edge(high, 1 - low_runs_back, v, p);
        status_.insert_above(under, low);
        status_.insert_above(low, high);
        return true;
    }

    [[nodiscard]] bool close(std::uint32_t a, std::uint32_t b, grid_point p) noexcept
    {
        const std::uint32_t low = status_.above(a) == b ? a : b, high = low == a ? b : a;
        if (status_.above(low) != high || !above(status_.below(low), p) || !below(status_.above(high), p)) return false;
        status_.erase(low);
        status_.erase(high);
        give_slot(low);
        give_slot(high);
        return true;
    }

    [[nodiscard]] std::uint32_t take_slot() noexcept
    {
        if (free_slot_ == 0) return ++slot_count_;
        const std::uint32_t slot = free_slot_;
        free_slot_ = edges_[slot].contour;
        return slot;
    }
    void give_slot(std::uint32_t slot) noexcept
    {
        edges_[slot].contour = free_slot_;
        free_slot_ = slot;
    }

    const grid_point* points_ = nullptr;
    vertex* vertices_ = nullptr;
    std::uint32_t* contour_of_ = nullptr;
    crossed_edge* edges_ = nullptr;
    bool* met_ = nullptr;
    contour_sides* sides_ = nullptr;
    sweep_status status_;
    std::uint32_t slot_count_ = 0;
    std::uint32_t free_slot_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
