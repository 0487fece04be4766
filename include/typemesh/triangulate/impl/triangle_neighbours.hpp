// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds the triangle across an edge, for triangles that store no neighbours. Half-edge 3t + k runs from corner k of
/// triangle t to the next corner.
///
/// The first queries search the triangles outwards from the given one: neighbours are seldom far apart in the list.
/// Once the searches have cost as much as a table of all answers, prepare() makes the table.
///
/// Cost   O(n) per query for n triangles without the table, O(1) with it. prepare() makes the table once, in O(n),
///        after queries have examined 8n triangles: O(n) for all of them if it is called after every few
/// Space  32 bytes per triangle, once there is a table
class triangle_neighbours {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    triangle_neighbours(std::size_t points, array_view<const std::uint32_t> starts,
                        array_view<const triangle> triangles) noexcept
        : points_{points}, starts_{starts}, triangles_{triangles}
    {
    }

    /// Call this now and then. False if out of memory.
    [[nodiscard]] bool prepare(workspace::scope& scratch, workspace& space) noexcept
    {
        return twins_ != nullptr || looked_at_ < 8 * triangles_.size() || make_table(scratch, space);
    }

    /// Whether there is a table.
    [[nodiscard]] bool knows_all() const noexcept { return twins_ != nullptr; }

    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept { return corner(triangles_[h / 3], h % 3); }

    /// The twin of h, the same edge in the neighbour; `none` if it is the region's own edge.
    [[nodiscard]] std::uint32_t across(std::uint32_t h) noexcept
    {
        if (twins_ != nullptr) return twins_[h];
        const std::uint32_t from = origin(h), to = origin(next(h));
        if (to <= from + 1 && to == next_point(from)) return none;
        const std::size_t t = h / 3, count = triangles_.size();
        for (std::size_t away = 1; away <= t || t + away < count; ++away) {
            looked_at_ += 2;
            if (away <= t)
                if (const std::uint32_t found = half_edge(t - away, to, from); found != none) return found;
            if (t + away < count)
                if (const std::uint32_t found = half_edge(t + away, to, from); found != none) return found;
        }
        return none;
    }

    /// Updates the table; call it when triangles are exchanged. h and g are twins; g may be `none`.
    void join(std::uint32_t h, std::uint32_t g) noexcept
    {
        if (twins_ == nullptr) return;
        twins_[h] = g;
        if (g != none) twins_[g] = h;
    }

private:
    [[nodiscard]] static std::uint32_t corner(const triangle& t, std::uint32_t k) noexcept
    {
        return k == 0 ? t.a : k == 1 ? t.b : t.c;
    }

    /// The half-edge of triangle t from one point to another; `none` if there is none.
    [[nodiscard]] std::uint32_t half_edge(std::size_t t, std::uint32_t from, std::uint32_t to) const noexcept
    {
        const triangle& at = triangles_[t];
        const auto first = static_cast<std::uint32_t>(3 * t);
        if (at.a == from && at.b == to) return first;
        if (at.b == from && at.c == to) return first + 1;
        return at.c == from && at.a == to ? first + 2 : none;
    }

    /// The point after v on its loop.
    [[nodiscard]] std::uint32_t next_point(std::uint32_t v) const noexcept
    {
        std::size_t low = 0, high = starts_.size() - 1;  // starts_[low] <= v < starts_[high]
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (starts_[middle] <= v ? low : high) = middle;
        }
        return v + 1 < starts_[high] ? v + 1 : starts_[low];
    }

    /// Finds twins point by point. First each half-edge that leaves the point is noted at its other end. Then each
    /// half-edge that arrives looks up the note at its own origin.
    [[nodiscard]] bool make_table(workspace::scope& scratch, workspace& space) noexcept
    {
        const auto halves = static_cast<std::uint32_t>(3 * triangles_.size());
        auto* const twins = scratch.take<std::uint32_t>(halves);
        workspace::scope building{space};
        auto* const leaving = building.take<std::uint32_t>(points_);  // the head of a list for each point
        auto* const after = building.take<std::uint32_t>(halves);
        auto* const noted = building.take<std::uint32_t>(points_);
        if (twins == nullptr || leaving == nullptr || after == nullptr || noted == nullptr) return false;
        for (std::size_t v = 0; v < points_; ++v) leaving[v] = noted[v] = none;
        for (std::uint32_t h = halves; h-- != 0;) {
            const std::uint32_t v = origin(h);
            after[h] = leaving[v];
            leaving[v] = h;
        }
        for (std::uint32_t v = 0; v < points_; ++v) {
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) noted[origin(next(h))] = h;
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) {
                const std::uint32_t coming = previous(h), back = noted[origin(coming)];
                twins[coming] = back != none && origin(back) == v ? back : none;
            }
        }
        twins_ = twins;
        return true;
    }

    std::size_t points_;
    array_view<const std::uint32_t> starts_;
    array_view<const triangle> triangles_;
    std::uint32_t* twins_ = nullptr;
    std::size_t looked_at_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
