// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/text/text_plan.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of triangles of caps and bevels, seen from the front, that are reversed or flattened when placed
/// positions are rounded to 32-bit floats. It is 0 if the height of every triangle is greater than two of the plan's
/// position_step(). Front and back have equal triangles, in caps and in bevels, and each of them is counted once. Walls
/// over the rim of an affected cap may be flattened too. If an extruder makes its own caps and has no seen_from_front()
/// (extruder.hpp), only the region's triangles are counted.
///
/// On the grid no triangle is reversed or flat. Floats are coarser than the grid wherever units per em are not a power
/// of two, and far from the origin everywhere. Within 4 em of the origin three kinds of triangles are still affected:
/// triangles that no other diagonals avoid, triangles that a triangulator keeps (has_final_diagonals), and slivers of
/// bevels where edges meet. Glyphs with an origin of their own (see text_plan::write_meshes) do not have this problem.
///
/// Cost   O(triangles), computed in double precision from the positions as they are written
template <extruder Extruder>
[[nodiscard]] std::uint64_t flipped_triangles(const text_plan<Extruder>& plan) noexcept
{
    struct vector {
        double x, y, z;
    };
    const auto cross = [](vector a, vector b) noexcept {
        return vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const auto delta = [](vector a, vector b) noexcept { return vector{b.x - a.x, b.y - a.y, b.z - a.z}; };
    const auto wide = [](vec3 v) noexcept { return vector{as_double(v.x), as_double(v.y), as_double(v.z)}; };
    std::uint64_t flipped = 0;
    for (std::size_t i = 0; i < plan.glyphs().size(); ++i) {
        const placement at = plan.place(i);
        const frame& f = at.frame;
        const vector facing = cross(wide(f.right), wide(f.up));
        const auto look_at = [&](grid_point p, grid_point q, grid_point r) noexcept {
            const vector a = wide(at.position(p, 0.0f)), b = wide(at.position(q, 0.0f)), c = wide(at.position(r, 0.0f));
            const vector normal = cross(delta(a, b), delta(a, c));
            const bool upright = normal.x * facing.x + normal.y * facing.y + normal.z * facing.z > 0.0;
            flipped += upright ? 0u : 1u;
        };
        plan.each_seen_from_front(i, look_at);
    }
    return flipped;
}
template <class Plan>
std::uint64_t flipped_triangles(const result<Plan>&) noexcept
{
    return refuse_result<Plan>() ? 0u : 1u;
}

}  // namespace typemesh::inline TYPEMESH_ABI
