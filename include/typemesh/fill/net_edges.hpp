// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/sweep_order.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The bits of a winding number that a rule looks at: what adds up to 0 in these has no effect.
[[nodiscard]] constexpr std::int32_t winding_mask(fill_rule rule) noexcept
{
    return rule == fill_rule::even_odd ? 1 : -1;
}

/// What the contours' edges between the same two points are together.
struct net_edge {
    grid_point from, to;           // from before to in the sweep order
    std::uint32_t origin, target;  // the contour points that the edge joins whose curve has the lowest number
    std::int32_t winding_delta;             // the winding number right above it less the one right below
};

/// Gives every point its number among the different ones, in the sweep order. How many there are; false when there is no
/// memory. `known` is the order of the points, as sweep_order() makes it; empty: not known.
[[nodiscard]] inline bool number_points(std::span<const grid_point> points, std::span<const std::uint32_t> known,
                                        workspace& space, std::uint32_t* number, std::uint32_t& different) noexcept
{
    workspace::scope scratch{space};
    const std::uint32_t* order = known.data();
    if (known.empty()) {
        auto* const sorted = scratch.take<std::uint32_t>(points.size());
        if (sorted == nullptr || !sweep_order(points, space, sorted)) return false;
        order = sorted;
    }
    different = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == 0 || !(points[order[i - 1]] == points[order[i]])) ++different;
        number[order[i]] = different - 1;
    }
    return true;
}

/// The edges of contours, each pair of ends once; those that cancel, or have no length, are left out. So the result is
/// the same wherever contours begin, in whatever order they come, and run all the other way (but for `winding_delta`); under
/// even_odd also for each contour that runs the other way.
///
/// `edges` has room for as many as there are points, and is ordered by where they start. How many there are; none and
/// false when there is no memory. `known` is the order of the points, as sweep_order() makes it; empty: not known. O(n log n)
[[nodiscard]] inline bool make_net_edges(const contours& given, std::span<const std::uint32_t> known, fill_rule rule,
                                         workspace& space, net_edge* edges, std::uint32_t& count) noexcept
{
    constexpr std::uint32_t none = 0xFFFF'FFFFu;
    const auto n = static_cast<std::uint32_t>(given.points.size());
    const std::int32_t mask = winding_mask(rule);
    const grid_point* const place = given.points.data();
    count = 0;
    workspace::scope scratch{space};
    auto* const number = scratch.take<std::uint32_t>(n);  // of every point, equal ones having one
    auto* const first = scratch.take<std::uint32_t>(n);   // of the edges that start in each: the first
    auto* const next = scratch.take<std::uint32_t>(n);
    auto* const to = scratch.take<std::uint32_t>(n);      // of every edge: the contour point behind it
    auto* const seen = scratch.take<std::uint32_t>(n);    // of every point: the last edge that ends there
    if (number == nullptr || first == nullptr || next == nullptr || to == nullptr || seen == nullptr) return false;
    std::uint32_t different = 0;
    if (!number_points(given.points.view(), known, space, number, different)) return false;
    for (std::uint32_t i = 0; i < different; ++i) first[i] = seen[i] = none;
    for (std::uint32_t c = 0; c < given.contour_count(); ++c) {
        const std::uint32_t begin = given.starts[c], end = given.starts[c + 1];
        for (std::uint32_t v = begin; v < end; ++v) {
            to[v] = v + 1 < end ? v + 1 : begin;
            const std::uint32_t i = number[v], k = number[to[v]];
            if (i == k) continue;
            std::uint32_t& list = first[i < k ? i : k];
            next[v] = list;
            list = v;
        }
    }
    for (std::uint32_t start = 0; start < different; ++start) {
        const std::uint32_t begin = count;
        for (std::uint32_t v = first[start]; v != none; v = next[v]) {
            const bool along = number[v] == start;
            const std::uint32_t end = along ? number[to[v]] : number[v];
            const std::int32_t winding_delta = along ? 1 : -1;
            const std::uint32_t known_one = seen[end];
            if (known_one != none && known_one >= begin) {
                net_edge& e = edges[known_one];
                e.winding_delta += winding_delta;
                if (given.edges[v].curve < given.edges[e.origin].curve) {
                    e.origin = v;
                    e.target = to[v];
                }
                continue;
            }
            seen[end] = count;
            edges[count++] = along ? net_edge{place[v], place[to[v]], v, to[v], winding_delta}
                                   : net_edge{place[to[v]], place[v], v, to[v], winding_delta};
        }
        std::uint32_t kept = begin;
        for (std::uint32_t i = begin; i < count; ++i)
            if ((edges[i].winding_delta & mask) != 0) edges[kept++] = edges[i];
        count = kept;
        for (std::uint32_t v = first[start]; v != none; v = next[v])
            seen[number[v] == start ? number[to[v]] : number[v]] = none;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
