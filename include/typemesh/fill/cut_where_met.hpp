// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/shared_cuts.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Cuts closed polylines in every point in which they meet others or themselves. Afterwards two edges have at most an
/// end in common, unless they are equal.
///
///      +-------+              +---x---+         Every contour stays, in its place, with its direction. Nothing is
///      |   +---|---+    ->    |   +---x---+     joined, and nothing is left out. So the regions of single contours can
///      +---|---+   |          +---x---+   |     be joined and cut by resolve() in any sequence afterwards, and no
///          +-------+              +-------+     point is moved again.
///
/// Replaces `loops`. Where edges cross off the grid, all edges are rounded by Hobby's snap rounding: each is routed
/// through the centre of every pixel that it passes through and that contains a point or a crossing. No edge moves by
/// more than half a cell in x and y. Edges keep their curve and t. A contour may pass through a point several times or
/// double back afterwards, if two of its edges were closer than a cell.
///
///     max_pieces    the greatest number of crossings, and of edges afterwards
///
/// Fails  error::too_many_pieces, error::too_large, error::out_of_memory; `loops` may then have some of the cuts
/// Cost   O((n + k) log n) for n points and k crossings; two rounds if anything is cut, hardly ever more
/// Exact  in 64 bits
/// From   Hobby, Practical segment intersection with finite precision output (1999)
[[nodiscard]] inline result<void> cut_where_met(contours& loops, workspace& space,
                                                std::uint32_t max_pieces = default_max_pieces) noexcept
{
    constexpr int max_rounds = 8;
    if (loops.points.size() > std::size_t{1} << 29) return error::too_large;
    for (int round = 0; round < max_rounds; ++round) {
        if (!sort_points(loops, space)) return error::out_of_memory;
        detail::shared_cuts cuts{loops, max_pieces};
        bool is_cut = false;
        if (error e = cuts.run(space, round == 0, is_cut)) return e;
        if (!is_cut) return {};
    }
    return error::crossing_contours;
}

}  // namespace typemesh::inline TYPEMESH_ABI
