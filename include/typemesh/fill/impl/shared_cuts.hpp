// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/crossing_sweep.hpp>
#include <typemesh/fill/impl/growing.hpp>
#include <typemesh/fill/impl/hot_pixels.hpp>
#include <typemesh/fill/impl/net_edges.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// One round of cut_where_met(): finds the points in which edges must be cut, and rewrites the contours.
///
///     edges   the different edges of all contours, each once, in the order of the sweep
///     cuts    [ the hot points on the first edge, from left to right | on the second | ... ]
class shared_cuts {
public:
    shared_cuts(contours& loops, std::uint32_t max_pieces) noexcept : loops_{loops}, most_{max_pieces} {}

    /// `rounds`: every edge is led through all hot pixels on its way; otherwise only if any two edges cross.
    [[nodiscard]] error run(workspace& space, bool rounds, bool& is_cut) noexcept
    {
        workspace::scope scratch{space};
        if (!find_edges(scratch, space)) return error::out_of_memory;
        if (error e = find_points(scratch, space, rounds)) return e;
        if (error e = find_cuts(scratch, space, rounds)) return e;
        is_cut = cut_count_ != 0;
        return is_cut ? rewrite(scratch) : error{};
    }

private:
    [[nodiscard]] bool find_edges(workspace::scope& scratch, workspace& space) noexcept
    {
        const auto n = static_cast<std::uint32_t>(loops_.points.size());
        edges_ = scratch.take<net_edge>(n);
        edge_of_ = scratch.take<std::uint32_t>(n);
        if (edges_ == nullptr || edge_of_ == nullptr) return false;
        workspace::scope listing{space};
        auto* const number = listing.take<std::uint32_t>(n);
        auto* const first = listing.take<std::uint32_t>(n);
        auto* const next = listing.take<std::uint32_t>(n);
        auto* const to = listing.take<std::uint32_t>(n);
        auto* const seen = listing.take<std::uint32_t>(n);
        if (number == nullptr || first == nullptr || next == nullptr || to == nullptr || seen == nullptr) return false;
        const std::uint32_t different = number_points(loops_, number);
        for (std::uint32_t i = 0; i < different; ++i) first[i] = seen[i] = no_number;
        for (std::uint32_t c = 0; c < loops_.contour_count(); ++c) {
            const std::uint32_t begin = loops_.starts[c], end = loops_.starts[c + 1];
            for (std::uint32_t v = begin; v < end; ++v) {
                to[v] = v + 1 < end ? v + 1 : begin;
                edge_of_[v] = no_number;
                const std::uint32_t i = number[v], k = number[to[v]];
                if (i == k) continue;
                std::uint32_t& list = first[i < k ? i : k];
                next[v] = list;
                list = v;
            }
        }
        for (std::uint32_t start = 0; start < different; ++start) {
            for (std::uint32_t v = first[start]; v != no_number; v = next[v]) {
                const bool along = number[v] == start;
                const std::uint32_t end = along ? number[to[v]] : number[v];
                if (seen[end] == no_number) {
                    seen[end] = count_;
                    const grid_point p = loops_.points[v], q = loops_.points[to[v]];
                    edges_[count_++] = along ? net_edge{p, q, v, to[v], 1} : net_edge{q, p, v, to[v], 1};
                }
                edge_of_[v] = seen[end];
            }
            for (std::uint32_t v = first[start]; v != no_number; v = next[v])
                seen[number[v] == start ? number[to[v]] : number[v]] = no_number;
        }
        return true;
    }

    /// Finds the hot points: all points of the contours, and the crossings of edges.
    [[nodiscard]] error find_points(workspace::scope& scratch, workspace& space, bool& rounds) noexcept
    {
        growing<grid_point> all{scratch};
        if (!all.reserve(loops_.points.size() + count_ / 4 + 64)) return error::out_of_memory;
        for (const grid_point p : loops_.points) all.values[all.count++] = p;
        std::uint32_t crossings = 0;
        const auto met = [&](grid_point x, bool) noexcept { return ++crossings <= most_ && all.add(x); };
        if (!crossing_sweep::run({edges_, count_}, scratch, space, met))
            return crossings > most_ ? error{error::too_many_pieces, most_} : error{error::out_of_memory};
        rounds = rounds || crossings != 0;
        auto* const order = scratch.take<std::uint32_t>(all.count);
        points_ = scratch.take<grid_point>(all.count);
        if (order == nullptr || points_ == nullptr || !sweep_order({all.values, all.count}, space, order))
            return error::out_of_memory;
        for (std::size_t i = 0; i < all.count; ++i) {
            const grid_point p = all.values[order[i]];
            if (point_count_ == 0 || !(points_[point_count_ - 1] == p)) points_[point_count_++] = p;
        }
        return {};
    }

    [[nodiscard]] error find_cuts(workspace::scope& scratch, workspace& space, bool rounds) noexcept
    {
        cut_ends_ = scratch.take<std::size_t>(count_);
        hot_pixels cells;
        if (cut_ends_ == nullptr || !cells.open({points_, point_count_}, scratch, space)) return error::out_of_memory;
        growing<std::uint32_t> cuts{scratch};
        for (std::uint32_t i = 0; i < count_; ++i) {
            const auto step = [&](hot_pixels::hit h) noexcept {
                if (!rounds && !h.is_exact) return true;
                return cuts.count < most_ && cuts.add(h.number);
            };
            if (!cells.along(edges_[i].from, edges_[i].to, step))
                return cuts.count >= most_ ? error{error::too_many_pieces, most_} : error{error::out_of_memory};
            cut_ends_[i] = cuts.count;
        }
        cuts_ = cuts.values;
        cut_count_ = cuts.count;
        return {};
    }

    [[nodiscard]] error rewrite(workspace::scope& scratch) noexcept
    {
        const std::size_t n = loops_.points.size(), starts = loops_.starts.size();
        std::size_t total = n;
        for (std::size_t v = 0; v < n; ++v)
            if (edge_of_[v] != no_number) total += cut_ends_[edge_of_[v]] - first_cut(edge_of_[v]);
        if (total > most_) return {error::too_many_pieces, most_};
        auto* const points = scratch.take<grid_point>(n);
        auto* const edges = scratch.take<contour_edge>(n);
        if (points == nullptr || edges == nullptr || !loops_.points.reserve(total) || !loops_.edges.reserve(total))
            return error::out_of_memory;
        std::memcpy(static_cast<void*>(points), loops_.points.data(), n * sizeof *points);
        std::memcpy(static_cast<void*>(edges), loops_.edges.data(), n * sizeof *edges);
        loops_.forget_order();
        loops_.points.clear();
        loops_.edges.clear();
        std::uint32_t begin = 0;
        for (std::size_t c = 1; c < starts; ++c) {
            const std::uint32_t end = loops_.starts[c];
            for (std::uint32_t v = begin; v < end; ++v)
                write_edge(points[v], points[v + 1 < end ? v + 1 : begin], edges[v], edge_of_[v]);
            begin = end;
            loops_.starts[c] = static_cast<std::uint32_t>(loops_.points.size());
        }
        return {};
    }

    [[nodiscard]] std::size_t first_cut(std::uint32_t edge) const noexcept
    {
        return edge == 0 ? 0 : cut_ends_[edge - 1];
    }

    void write_edge(grid_point from, grid_point to, contour_edge source, std::uint32_t edge) noexcept
    {
        loops_.points.push_back_unchecked(from);
        if (edge != no_number) {
            const std::size_t begin = first_cut(edge), end = cut_ends_[edge];
            const bool along = edges_[edge].from == from;
            segment rest{from, to, 0, 0, 1, 0, source, 0, 0, no_number, 0, 0};
            for (std::size_t i = 0; i < end - begin; ++i) {
                const grid_point p = points_[cuts_[along ? begin + i : end - 1 - i]];
                const float t = rest.t_at(p);
                loops_.edges.push_back_unchecked({source.curve, rest.source.t0, t});
                loops_.points.push_back_unchecked(p);
                rest.from = p;
                rest.source.t0 = t;
            }
            source = rest.source;
        }
        loops_.edges.push_back_unchecked(source);
    }

    contours& loops_;
    std::uint32_t most_;
    net_edge* edges_ = nullptr;
    std::uint32_t* edge_of_ = nullptr;  // for each point of the contours, the edge that starts there
    std::uint32_t count_ = 0;           // of edges
    grid_point* points_ = nullptr;      // the hot points, in sweep order
    std::size_t point_count_ = 0;
    std::uint32_t* cuts_ = nullptr;    // the numbers of hot points
    std::size_t* cut_ends_ = nullptr;  // for each edge, the end of its cuts
    std::size_t cut_count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
