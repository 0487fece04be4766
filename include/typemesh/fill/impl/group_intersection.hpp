// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/fill/impl/intersect.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Disjoint sets of the numbers below n, by union-find; the lowest number of a set names it.
struct number_sets {
    std::uint32_t* parent;

    [[nodiscard]] std::uint32_t root(std::uint32_t i) noexcept
    {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) noexcept
    {
        a = root(a);
        b = root(b);
        parent[a < b ? b : a] = a < b ? a : b;
    }
};

/// The bounding boxes of some regions, in the order in which a line that sweeps along one axis reaches them.
struct box_sweep {
    struct entry {
        placed_box around;
        std::uint32_t number;
        std::int64_t first = 0, last = 0;  // along the axis

        [[nodiscard]] bool before(const entry& other) const noexcept
        {
            return first != other.first ? first < other.first : number < other.number;
        }
    };
    array_view<entry> entries;

    /// Picks the axis along which fewer boxes overlap: along a line of text, but across the lines of a page.
    void put_in_order() noexcept
    {
        double left = 0x1p62, right = -left, low = left, high = right, width = 0.0, height = 0.0;
        for (const entry& e : entries) {
            const double x0 = static_cast<double>(e.around.low.x), x1 = static_cast<double>(e.around.high.x);
            const double y0 = static_cast<double>(e.around.low.y), y1 = static_cast<double>(e.around.high.y);
            left = x0 < left ? x0 : left;
            right = x1 > right ? x1 : right;
            width += x1 - x0;
            low = y0 < low ? y0 : low;
            high = y1 > high ? y1 : high;
            height += y1 - y0;
        }
        const bool upward = (high - low) * width > (right - left) * height;
        for (entry& e : entries) {
            e.first = upward ? e.around.low.y : e.around.low.x;
            e.last = upward ? e.around.high.y : e.around.high.x;
        }
        heap_sort(entries.data(), entries.size());
    }
};

}  // namespace detail

/// Groups regions that meet, directly or through others: group[i] becomes the lowest number in i's group.
///
///     0 +--+1  +--+2   +--+3        group  [ 0, 0, 2, 2 ]
///       | +++  | ++----++ |
///       +-++|  +-++    ++-+
///         +-+    +------+
///
///     all      the regions; empty regions are groups of one, and no group has two kinds
///     group    as many numbers; meaningless after an error
///
/// Fails  error::too_large: 2^32 - 1 regions or more; error::out_of_memory
/// Cost   O(n log n), a test of every two regions that overlap along one axis, and meet() if their boxes overlap
[[nodiscard]] inline error group_intersection(array_view<const placed_loops> all, array_view<std::uint32_t> group,
                                              workspace& space) noexcept
{
    const std::size_t n = all.size();
    TYPEMESH_ASSERT(group.size() == n, "group_intersection() needs room for one number for each region");
    if (n >= 0xFFFF'FFFFu) return error::too_large;
    workspace::scope scratch{space};
    auto* entries = scratch.take<detail::box_sweep::entry>(n);
    auto* open = scratch.take<std::uint32_t>(n);  // the boxes that the sweep line crosses, as indices into `entries`
    if (n != 0 && (entries == nullptr || open == nullptr)) return error::out_of_memory;

    std::size_t count = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        group[i] = i;
        if (!all[i].points.empty()) entries[count++] = {detail::box_around(all[i]), i, 0, 0};
    }
    detail::box_sweep sweep{{entries, count}};
    sweep.put_in_order();
    detail::number_sets sets{group.data()};
    std::size_t opened = 0;
    for (std::uint32_t e = 0; e < count; ++e) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < opened; ++k) {
            const detail::box_sweep::entry &here = entries[e], &other = entries[open[k]];
            if (other.last < here.first) continue;
            open[kept++] = open[k];
            if (all[here.number].kind != all[other.number].kind || !here.around.meets(other.around)) continue;
            if (sets.root(here.number) == sets.root(other.number)) continue;
            const auto met = meet(all[here.number], all[other.number], space);
            if (!met) return met.error();
            if (*met) sets.join(here.number, other.number);
        }
        open[kept++] = e;
        opened = kept;
    }
    for (std::uint32_t i = 0; i < n; ++i) group[i] = sets.root(i);
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
