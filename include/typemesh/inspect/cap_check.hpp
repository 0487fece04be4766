// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// The differences between the triangles of a cap and a triangulation of its region. A triangulation has n + 2h - 2c
/// triangles, each strictly counter-clockwise, and exactly the region's area. Each edge of the region is an edge of one
/// triangle, in the same direction; each other edge belongs to two triangles, in opposite directions. Every point is a
/// corner.
struct cap_check {
    std::size_t wanted = 0;  ///< the number n + 2h - 2c, with holes and outer loops recounted from their areas
    std::size_t triangles = 0;
    bool miscounted_loops = false;    ///< whether the region states wrong numbers of holes, outer loops or triangles
    std::size_t bad_corners = 0;      ///< the number of triangles with a corner that is not a point; the counts below
                                      ///< ignore them
    std::size_t turned = 0;           ///< the number of triangles that are flat or clockwise
    std::int64_t doubled_excess = 0;  ///< twice the triangles' area minus the region's, in square cells
    std::size_t unused_points = 0;    ///< the number of points of the region that are no triangle's corner
    std::size_t repeated_edges = 0;   ///< the number of directed edges that occur in more than one triangle
    std::size_t uncovered_edges = 0;  ///< the number of the region's edges that are in no triangle
    std::size_t overrun_edges = 0;    ///< the number of the region's edges with a triangle on the outside
    std::size_t open_edges = 0;       ///< the number of other edges that occur in only one triangle

    /// A description of the first fault; "" if there is none.
    [[nodiscard]] constexpr const char* broken() const noexcept
    {
        if (miscounted_loops) return "holes and outer loops are miscounted";
        if (triangles != wanted) return "not n + 2h - 2c triangles";
        if (bad_corners != 0) return "a corner is not a point of the region";
        if (turned != 0) return "a triangle is not strictly counter-clockwise";
        if (doubled_excess != 0) return "the area is not the region's";
        if (unused_points != 0) return "a point is not used";
        if (repeated_edges != 0) return "a directed edge occurs twice";
        if (uncovered_edges != 0) return "an edge of the region is in no triangle";
        if (overrun_edges != 0) return "an edge of the region is in two triangles";
        if (open_edges != 0) return "an inner edge is in only one triangle";
        return "";
    }
};

/// Compares triangles with the region that they should cover, exactly. Cost: O(n log n) for n points and triangles
[[nodiscard]] inline cap_check check_cap(const region& r, std::span<const triangle> triangles)
{
    const auto points = r.points();
    const std::vector<loop> loops = loops_of(r);
    std::size_t holes = 0, outers = 0;
    for (const loop l : loops) ++(doubled_area(l) < 0 ? holes : outers);
    cap_check found;
    found.triangles = triangles.size();
    found.wanted = points.size() + 2 * holes - 2 * outers;
    found.miscounted_loops = r.holes() != holes || r.outers() != outers || r.triangle_count() != found.wanted;

    std::vector<std::uint64_t> edges;  // of the triangles
    std::vector<bool> used(points.size(), false);
    std::uint64_t area = 0;
    const auto directed = [](std::uint64_t from, std::uint64_t to) noexcept { return from << 32 | to; };
    for (const triangle t : triangles) {
        if (t.a >= points.size() || t.b >= points.size() || t.c >= points.size()) {
            ++found.bad_corners;
            continue;
        }
        if (side(points[t.a], points[t.b], points[t.c]) <= 0) ++found.turned;
        const grid_point corners[3] = {points[t.a], points[t.b], points[t.c]};
        area += static_cast<std::uint64_t>(doubled_area(corners));
        used[t.a] = used[t.b] = used[t.c] = true;
        for (const std::uint64_t e : {directed(t.a, t.b), directed(t.b, t.c), directed(t.c, t.a)}) edges.push_back(e);
    }
    found.doubled_excess = static_cast<std::int64_t>(area - static_cast<std::uint64_t>(doubled_area(loops)));
    found.unused_points = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));

    std::sort(edges.begin(), edges.end());
    const auto is_there = [&](std::uint64_t e) { return std::binary_search(edges.begin(), edges.end(), e); };
    std::vector<std::uint64_t> boundary;
    for (std::size_t l = 0; l + 1 < r.starts().size(); ++l) {
        const std::uint32_t begin = r.starts()[l], end = r.starts()[l + 1];
        for (std::uint32_t i = begin; i < end; ++i) boundary.push_back(directed(i, i + 1 < end ? i + 1 : begin));
    }
    std::sort(boundary.begin(), boundary.end());
    for (const std::uint64_t e : boundary) {
        found.uncovered_edges += is_there(e) ? 0u : 1u;
        found.overrun_edges += is_there(e << 32 | e >> 32) ? 1u : 0u;
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        found.repeated_edges += i > 0 && edges[i] == edges[i - 1] ? 1u : 0u;
        const bool inner = !std::binary_search(boundary.begin(), boundary.end(), edges[i]);
        found.open_edges += inner && !is_there(edges[i] << 32 | edges[i] >> 32) ? 1u : 0u;
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
