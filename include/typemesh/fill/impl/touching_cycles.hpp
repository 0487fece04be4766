// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sectors.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Relinks contours that share points, so that in each of these points a cycle stays in its own sector of interior.
/// This is the work of boundary_cycles for contours that only touch in points and have the interior on their left.
///
///     .---------<--------.         .---------<--------.         The hole touches the outer loop: one cycle for both.
///     |    .---->---.    |         |    .---->---.    |         Points and edges are only put in another order; none
///     |    |        |    |   ->    |    |        |    |         is changed, added or lost.
///     |     '.    .'     |         |     '.    .'     |
///     '->-----'--'----->-'         '->---'  '------->-'
///
/// Whatever the contours do elsewhere, the same edges run in the same directions, so all winding numbers stay the same.
/// Nothing is proven here; a triangulator that takes such points does this (see triangulator.hpp).
class touching_cycles {
public:
    /// Changes `loops` in place. `scratch` keeps the data that undo() needs.
    ///
    /// Fails  error::crossing_contours: no two points are equal, or around some point the edges do not bound sectors:
    ///        two have one direction, or the interior is not on the left of each
    ///        error::out_of_memory
    /// In both cases `loops` is unchanged.
    /// Cost   a sort of the points; about 50 bytes per point from `scratch`
    [[nodiscard]] error link(contours& loops, workspace::scope& scratch, workspace& space) noexcept
    {
        const std::size_t n = loops.points.size();
        auto* const order = scratch.take<std::uint32_t>(n);
        if (order == nullptr || !sort_points(loops, space)) return error::out_of_memory;
        const array_view<const std::uint32_t> sorted = loops.order();
        for (std::size_t i = 0; i < n; ++i) order[i] = sorted[i];
        const grid_point* const place = loops.points.data();
        std::size_t most = 1, visits = 0;
        for (std::size_t begin = 0, end = 1; begin < n; begin = end++) {
            while (end < n && place[order[end]] == place[order[begin]]) ++end;
            if (end - begin == 1) continue;
            if (end - begin > most) most = end - begin;
            for (std::size_t i = begin; i < end; ++i) order[visits++] = order[i];
        }
        if (visits == 0) return error::crossing_contours;
        auto* const outgoing_edges = scratch.take<outgoing_edge>(2 * most);
        auto* const behind = scratch.take<std::uint32_t>(n);  // the next point on the cycle
        if (outgoing_edges == nullptr || behind == nullptr) return error::out_of_memory;
        for (std::uint32_t c = 0; c < loops.contour_count(); ++c) {
            const std::uint32_t begin = loops.starts[c], end = loops.starts[c + 1];
            for (std::uint32_t v = begin; v < end; ++v) behind[v] = v + 1;
            if (begin != end) behind[end - 1] = begin;
        }
        bool changed = false;
        for (std::size_t begin = 0, end = 1; begin < visits; begin = end++) {
            const grid_point p = place[order[begin]];
            while (end < visits && place[order[end]] == p) ++end;
            const std::size_t count = 2 * (end - begin);
            for (std::size_t i = begin; i < end; ++i) {
                const auto [previous, next] = neighbours(loops, order[i]);
                outgoing_edges[2 * (i - begin)] = outgoing_edge::to(place[next], p, order[i], true);
                outgoing_edges[2 * (i - begin) + 1] = outgoing_edge::to(place[previous], p, previous, false);
            }
            if (!sort_into_sectors(outgoing_edges, count)) return error::crossing_contours;
            for (std::size_t i = 0; i < count; i += 2) {
                std::uint32_t& next = behind[outgoing_edges[i + 1].visit];
                changed |= next != outgoing_edges[i].visit;
                next = outgoing_edges[i].visit;
            }
        }
        return changed ? relink(loops, behind, scratch) : error{};
    }

    /// Undoes link(), as long as its scratch memory exists.
    void undo(contours& loops) noexcept
    {
        if (points_ == nullptr) return;
        exchange(loops);
        loops.starts.truncate(0);
        for (std::size_t i = 0; i < start_count_; ++i) loops.starts.push_back_unchecked(starts_[i]);
        points_ = nullptr;
    }

private:
    /// The points before and after a point on its contour. O(log contours)
    [[nodiscard]] static std::pair<std::uint32_t, std::uint32_t> neighbours(const contours& loops,
                                                                            std::uint32_t v) noexcept
    {
        std::uint32_t contour = 0;
        for (std::uint32_t size = loops.contour_count(); size > 1;) {
            const std::uint32_t half = size / 2;
            if (loops.starts[contour + half] <= v) contour += half;
            size -= half;
        }
        const std::uint32_t first = loops.starts[contour], last = loops.starts[contour + 1] - 1;
        return {v == first ? last : v - 1, v == last ? first : v + 1};
    }

    [[nodiscard]] error relink(contours& loops, std::uint32_t* behind, workspace::scope& scratch) noexcept
    {
        constexpr std::uint32_t done = 0xFFFF'FFFFu;
        const auto n = static_cast<std::uint32_t>(loops.points.size());
        start_count_ = loops.starts.size();
        auto* const points = scratch.take<grid_point>(n);
        edges_ = scratch.take<contour_edge>(n);
        starts_ = scratch.take<std::uint32_t>(start_count_);
        if (points == nullptr || edges_ == nullptr || starts_ == nullptr || !loops.starts.reserve(n / 2 + 2))
            return error::out_of_memory;
        for (std::size_t i = 0; i < start_count_; ++i) starts_[i] = loops.starts[i];
        loops.starts.truncate(1);
        points_ = points;
        std::uint32_t size = 0;
        for (std::uint32_t first = 0; first < n; ++first) {
            if (behind[first] == done) continue;
            for (std::uint32_t v = first; behind[v] != done;) {
                points_[size] = loops.points[v];
                edges_[size++] = loops.edges[v];
                v = std::exchange(behind[v], done);
            }
            loops.starts.push_back_unchecked(size);
        }
        exchange(loops);
        return {};
    }

    void exchange(contours& loops) noexcept
    {
        loops.forget_order();
        for (std::size_t i = 0; i < loops.points.size(); ++i) {
            swap_values(loops.points[i], points_[i]);
            swap_values(loops.edges[i], edges_[i]);
        }
    }

    grid_point* points_ = nullptr;  // the original points; null: nothing to undo
    contour_edge* edges_ = nullptr;
    std::uint32_t* starts_ = nullptr;
    std::size_t start_count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
