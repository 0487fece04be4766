// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// A direction rotated to the right: out of the interior, which is on the left of every edge. Not of unit length.
[[nodiscard]] constexpr point outward(point direction) noexcept { return {direction.y, -direction.x}; }

/// The vector from one grid point to another, in cells; exact.
[[nodiscard]] constexpr point delta(grid_point from, grid_point to) noexcept
{
    return {static_cast<double>(to.x) - from.x, static_cast<double>(to.y) - from.y};
}

/// A vector scaled to unit length; it must not be zero.
[[nodiscard]] inline point unit(point v) noexcept { return (1.0 / length(v)) * v; }

/// The unit normal of the wall over the edge from a to b, which differ.
[[nodiscard]] inline point wall_normal(grid_point a, grid_point b) noexcept { return unit(outward(delta(a, b))); }

[[nodiscard]] constexpr vec2 rounded(point v) noexcept { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

/// The normalised sum of the unit normals of two walls that meet in b, over a-b and b-c. It points out of both walls.
///
///      ^ normal       At the tip of a needle, the two normals nearly cancel. The difference of the edges' directions
///      b              is then on the same line and is long. The orientation shows exactly which direction along the
///     / \             line is outward.
///    c   a
[[nodiscard]] inline point joint_normal(grid_point a, grid_point b, grid_point c, point before, point after) noexcept
{
    if (dot(before, after) > -0.5) return unit(before + after);
    const point along = {after.y - before.y, before.x - after.x};
    return orientation(a, b, c) >= 0 ? unit(along) : unit(-1.0 * along);
}

/// An angle, as the dot product of two unit normals with this angle.
///
/// It is smaller than the cosine by 2^-30, so that an equal angle is soft, whatever the compiler's rounding (0 means
/// above 0.0025 degrees). Normals that cancel (within 0.08 degrees of opposite) exceed every angle, because they have
/// no sum.
[[nodiscard]] inline double crease_cosine(float degrees) noexcept
{
    const double cosine = std::cos(as_double(degrees) * (3.14159265358979323846 / 180.0)) - 0x1p-30;
    constexpr double opposite = -1.0 + 0x1p-20;
    return cosine > opposite ? cosine : opposite;
}

/// Whether a crease angle is in 0 to 180 degrees; NaN is not.
[[nodiscard]] inline bool is_crease_angle(float degrees) noexcept
{
    return is_finite(as_double(degrees)) && degrees >= 0.0f && degrees <= 180.0f;
}

}  // namespace typemesh::inline TYPEMESH_ABI
