// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The bits of a winding number that matter to a rule: changes that are 0 in these bits have no effect.
[[nodiscard]] constexpr std::int32_t winding_mask(fill_rule rule) noexcept
{
    return rule == fill_rule::even_odd ? 1 : -1;
}

/// The sum of all contour edges between the same two points.
struct net_edge {
    grid_point from, to;           // from before to in the sweep order
    std::uint32_t origin, target;  // the contour points joined by the edge whose curve has the lowest number
    std::int32_t winding_delta;    // the winding number right above it minus the one right below
};

/// Numbers the distinct points of sorted contours in sweep order, and returns their count.
[[nodiscard]] inline std::uint32_t number_points(const contours& given, std::uint32_t* number) noexcept
{
    const grid_point* const place = given.points.data();
    const array_view<const std::uint32_t> order = given.order();
    TYPEMESH_ASSERT(order.size() == given.points.size(),
                    "the points of contours are not sorted: call sort_points() first");
    std::uint32_t different = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || !(place[order[i - 1]] == place[order[i]])) ++different;
        number[order[i]] = different - 1;
    }
    return different;
}

/// The edges of contours, each pair of ends once, without edges that cancel or have no length. So the result does not
/// depend on the starts or the order of contours, nor (except `winding_delta`) on their direction if all are reversed.
/// Under even_odd it does not depend on the direction of any contour.
///
/// `edges` has room for one edge per point. They are sorted by their start points. `count` is their number. If out of
/// memory, the result is false and `count` 0. Precondition: the points are sorted. O(n)
[[nodiscard]] inline bool make_net_edges(const contours& given, fill_rule rule, workspace& space, net_edge* edges,
                                         std::uint32_t& count) noexcept
{
    constexpr std::uint32_t none = 0xFFFF'FFFFu;
    const auto n = static_cast<std::uint32_t>(given.points.size());
    const std::int32_t mask = winding_mask(rule);
    const grid_point* const place = given.points.data();
    count = 0;
    workspace::scope scratch{space};
    auto* const number = scratch.take<std::uint32_t>(n);  // for every point; equal points share a number
    auto* const first = scratch.take<std::uint32_t>(n);   // for each number: the first edge that starts there
    auto* const next = scratch.take<std::uint32_t>(n);
    auto* const to = scratch.take<std::uint32_t>(n);    // for every edge: the contour point after it
    auto* const seen = scratch.take<std::uint32_t>(n);  // for every point: the last edge that ends there
    if (number == nullptr || first == nullptr || next == nullptr || to == nullptr || seen == nullptr) return false;
    const std::uint32_t different = number_points(given, number);
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
