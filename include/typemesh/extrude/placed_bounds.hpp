// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/vertex/bounds3.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// Enlarges `all` by a placed box. `around` is its area in the plane, in cells, and not empty; its two heights are in
/// output units; along_axes is frame::is_along_axes().
inline void add_placed(bounds3& all, const box& around, float bottom, float top, const placement& at,
                       bool along_axes) noexcept
{
    all.add(at.position(at.foot(around.low), bottom));
    all.add(at.position(at.foot(around.high), top));
    if (along_axes) return;  // two opposite corners are enough
    for (const float z : {bottom, top})
        for (const point p :
             {around.low, around.high, point{around.low.x, around.high.y}, point{around.high.x, around.low.y}})
            all.add(at.position(at.foot(p), z));
}

/// The bounding box of everything placed over a box of the plane, in cells, between two heights. It is exact for frames
/// whose axes are parallel to the coordinate axes; otherwise it may be larger. `around` is not empty.
[[nodiscard]] inline bounds3 placed_bounds(const box& around, height_range heights, const placement& at) noexcept
{
    const float bottom = at.height(heights.low), top = at.height(heights.high);
    const vec3 corner = at.position(at.foot(around.low), bottom);
    bounds3 all{corner, corner};
    add_placed(all, around, bottom, top, at, at.frame.is_along_axes());
    return all;
}

namespace detail {

/// The box in which an extruder's vertices must lie, in builds with asserts, whether or not its plan() supplied one.
/// The box is enlarged by the rounding error of positions that are computed in another way.
[[nodiscard]] inline bounds3 promised_bounds(box around, array_view<const grid_point> points, height_range heights,
                                             const placement& at) noexcept
{
    if (around.empty())
        for (const grid_point p : points) around.add(placement::exact(p));
    if (around.empty()) return {};
    bounds3 all = placed_bounds(around, heights, at);
    float farthest = 0.0f;
    for (const vec3 corner : {all.low, all.high})
        for (const float v : {corner.x, corner.y, corner.z})
            farthest = std::fabs(v) > farthest ? std::fabs(v) : farthest;
    const float more = farthest * 0x1p-20f;
    all.low = {all.low.x - more, all.low.y - more, all.low.z - more};
    all.high = {all.high.x + more, all.high.y + more, all.high.z + more};
    return all;
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
