// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/simple_sweep.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The region that non-meeting contours fill under `rule`, for any directions and any nesting.
///
///     .-----------------.        .-----------------.      non_zero, all three counter-clockwise: the inner contours
///     |  .-----------.  |        |                 |      have filled area on both sides, so they are not boundary.
///     |  |  .-----.  |  |   ->   |                 |      even_odd would keep them all and reverse the middle one.
///     |  |  '-----'  |  |        |                 |
///     |  '-----------'  |        |                 |
///     '-----------------'        '-----------------'
///
/// Works in place: contours that are not part of the boundary are removed from `loops`. Contours with the interior on
/// their right are reversed (points and edges). The remaining contours keep their order. The result may be an empty
/// region.
///
/// Fails  error::crossing_contours: two edges cross, touch or overlap (neighbours in a contour may share only their
///        common point), or a contour has one or two points
///        error::out_of_memory
/// In both cases `loops` is unchanged.
/// Cost   O(n log n), exact in 64-bit integers; about 100 bytes per point from `space`
[[nodiscard]] inline result<region> nest(contours& loops, fill_rule rule, workspace& space) noexcept
{
    workspace::scope scratch{space};
    const std::uint32_t count = loops.contour_count();
    auto* const sides = scratch.take<detail::contour_sides>(count);
    if (sides == nullptr || !sort_points(loops, space)) return error::out_of_memory;
    detail::simple_sweep sweep;
    if (const error e = sweep.run(loops, space, sides)) return e;

    std::uint32_t kept = 0, holes = 0;
    std::size_t end = 0;
    bool moved = false;
    for (std::uint32_t c = 0; c < count; ++c) {
        const std::size_t begin = loops.starts[c], size = loops.starts[c + 1] - begin;
        if (size == 0) continue;
        const bool inside = is_filled(rule, sides[c].inside);
        if (inside == is_filled(rule, sides[c].outside)) continue;
        if (inside != sides[c].counter_clockwise) {
            reverse_contour(loops.points.view().subspan(begin, size), loops.edges.view().subspan(begin, size));
            moved = true;
        }
        if (end != begin) {
            for (std::size_t i = 0; i < size; ++i) {
                loops.points[end + i] = loops.points[begin + i];
                loops.edges[end + i] = loops.edges[begin + i];
            }
        }
        loops.starts[kept++] = static_cast<std::uint32_t>(end);
        end += size;
        if (!inside) ++holes;
    }
    if (!loops.starts.empty()) {
        loops.starts[kept] = static_cast<std::uint32_t>(end);
        loops.starts.truncate(kept + 1);
    }
    moved = moved || end != loops.points.size();
    if (moved) loops.forget_order();
    loops.points.truncate(end);
    loops.edges.truncate(end);
    return region::proven(loops, holes, kept - holes);
}

}  // namespace typemesh::inline TYPEMESH_ABI
