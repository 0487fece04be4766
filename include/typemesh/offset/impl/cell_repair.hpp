// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/offset/impl/int128.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Repairs slivers that rounding has turned over, so that the outlines of cells are simple on the grid:
///
///     detour    a side goes over the node that is too close to it, in both cells: a---b becomes a---via---b
///     nudge     a side at a level stays straight; the node moves off it, by a cell or two
///     union     two neighbours a few cells apart become one; a node at a level stays
///
/// All are proposals: the cells are cut again, and only the cut decides whether a repair has helped.
class cell_repair {
public:
    explicit cell_repair(memory source) noexcept : detours_{source}, united_{source} {}

    /// Begins the next band. Its own nodes begin with `first_node`; earlier nodes are not moved.
    void begin(std::size_t first_node) noexcept
    {
        detours_.clear();
        united_.clear();
        first_node_ = first_node;
    }

    /// The node that a node is now.
    [[nodiscard]] std::uint32_t node(std::uint32_t n) const noexcept
    {
        for (const unit& u : united_)
            if (u.from == n) n = u.to;
        return n;
    }

    /// Appends the path from the last node to the next one. False if out of memory.
    [[nodiscard]] bool follow(buffer<std::uint32_t>& path, std::uint32_t next) const noexcept
    {
        for (const detour& d : detours_) {
            const std::uint32_t last = path.back();
            const bool along = (d.a == last && d.b == next) || (d.a == next && d.b == last);
            if (!along) continue;
            return follow(path, d.via) && path.push_back(d.via) && follow(path, next);
        }
        return true;
    }

    /// Mends a ring that could not be cut. False if it finds no repair. `is_at_level(a, b)`: whether a side between a
    /// and b, in either direction, is at a level or, if a is b, whether some side at a level begins or ends there.
    template <class IsAtLevel>
    [[nodiscard]] bool mend(const buffer<std::uint32_t>& ring, buffer<swept_node>& nodes,
                            const IsAtLevel& is_at_level) noexcept
    {
        constexpr std::size_t max_detours = 1024;
        bool nudged = false;
        detour best;
        std::int64_t least = reach;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
            const bool at_level = is_at_level(a, b);
            for (const std::uint32_t via : ring) {
                if (via == a || via == b) continue;
                const grid_point p = nodes[a].at, q = nodes[b].at;
                const std::int64_t distance = distance_beside(p, q, nodes[via].at);
                if (at_level) {
                    const bool beyond = orientation(p, q, nodes[via].at) <= 0 && distance < reach;
                    nudged = (beyond && nudge(p, q, nodes[via].at, via)) || nudged;
                } else if (distance < least && !leads_over({a, via}, {a, b}) && !leads_over({via, b}, {a, b})) {
                    least = distance;
                    best = {a, b, via};
                }
            }
        }
        if (nudged) return true;
        if (best.a != best.b && detours_.size() < max_detours) return detours_.push_back(best);
        return unite(ring, nodes, is_at_level);
    }

private:
    static constexpr std::int64_t reach = 2 * 256;  // two cells, in 1/256 cells

    struct detour {
        std::uint32_t a = 0, b = 0;  // of the straight side
        std::uint32_t via = 0;
    };

    struct side {
        std::uint32_t a, b;
    };

    /// Whether the path along a side leads over another side: a detour there must not lead back to it.
    [[nodiscard]] bool leads_over(side from, side to) const noexcept
    {
        if ((from.a == to.a && from.b == to.b) || (from.a == to.b && from.b == to.a)) return true;
        for (const detour& d : detours_)
            if ((d.a == from.a && d.b == from.b) || (d.a == from.b && d.b == from.a))
                return leads_over({d.a, d.via}, to) || leads_over({d.via, d.b}, to);
        return false;
    }

    /// A node that has been united with another one.
    struct unit {
        std::uint32_t from, to;
    };

    /// Unites the two consecutive nodes of a ring that are closest to each other, at most 4 cells apart and swept at
    /// nearly the same distance.
    template <class IsAtLevel>
    [[nodiscard]] bool unite(const buffer<std::uint32_t>& ring, const buffer<swept_node>& nodes,
                             const IsAtLevel& is_at_level) noexcept
    {
        constexpr std::size_t max_united = 64;
        unit best{0, 0};
        std::int64_t least = 4 * 4 + 1;
        for (std::size_t i = 0; i < ring.size() && united_.size() < max_united; ++i) {
            const std::uint32_t a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
            const std::int64_t apart = squared_distance(nodes[a].at, nodes[b].at);
            const float later = nodes[a].distance - nodes[b].distance;
            if (apart >= least || later > 2.0f || later < -2.0f) continue;
            for (const unit u : {unit{a, b}, unit{b, a}}) {
                if (u.from < first_node_ || is_at_level(u.from, u.from)) continue;
                least = apart;
                best = u;
                break;
            }
        }
        if (best.from == best.to) return false;
        detours_.clear();  // they may lead over it; those that are still needed are found again
        return united_.push_back(best);
    }

    /// The distance of a point from a side, in 1/256 cells, if it lies beside the side; otherwise `reach`.
    [[nodiscard]] static std::int64_t distance_beside(grid_point p, grid_point q, grid_point m) noexcept
    {
        const std::int64_t x = std::int64_t{q.x} - p.x, y = std::int64_t{q.y} - p.y, square = x * x + y * y;
        const std::int64_t along = x * (std::int64_t{m.x} - p.x) + y * (std::int64_t{m.y} - p.y);
        if (along <= 0 || along >= square) return reach;
        const std::int64_t turn = orientation(p, q, m), area = turn < 0 ? -turn : turn;
        if (area >= std::int64_t{1} << 38) return reach;  // no side is longer than 2^30
        const std::int64_t size = square_root(static_cast<int128>(square) << 32);
        const std::int64_t distance = (area << 24) / size;
        return distance < reach ? distance : reach;
    }

    /// Moves a node to the nearest place on the left of a side.
    [[nodiscard]] bool nudge(grid_point p, grid_point q, grid_point& at, std::uint32_t node) const noexcept
    {
        constexpr std::int32_t most = 2;
        if (node < first_node_) return false;
        grid_point best = at;
        std::int64_t least = 2 * most * most + 1;
        for (std::int32_t y = -most; y <= most; ++y)
            for (std::int32_t x = -most; x <= most; ++x) {
                const grid_point moved{at.x + x, at.y + y};
                if (x * x + y * y >= least || orientation(p, q, moved) <= 0) continue;
                least = x * x + y * y;
                best = moved;
            }
        const bool found = !(best == at);
        at = best;
        return found;
    }

    buffer<detour> detours_;
    buffer<unit> united_;
    std::size_t first_node_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
