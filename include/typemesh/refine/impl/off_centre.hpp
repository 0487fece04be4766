// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/grid.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A distance for off_centre() that no triangle reaches: the point is then the centre of the circle.
inline constexpr double up_to_centre = 0x1p100;

/// The point to add for a bad triangle a, b, c (counter-clockwise) whose shortest edge is a b, rounded to the grid: on
/// the perpendicular through the middle of a b, at most `farthest` lengths of a b away from it, and at most as far as
/// the centre of the circle around the triangle.
///
///          c
///         /  \            o  the centre of the circle
///        / o   \          x  the off-centre: a, b, x has the least angle that is wanted
///       /  x     \        |
///      a---+------b
///
/// From  A. Ungor, Off-centers: a new type of Steiner points for computing size-optimal quality-guaranteed Delaunay
///       triangulations (2004)
[[nodiscard]] inline grid_point off_centre(grid_point a, grid_point b, grid_point c, double farthest) noexcept
{
    const double bx = static_cast<double>(b.x) - a.x, by = static_cast<double>(b.y) - a.y;
    const double cx = static_cast<double>(c.x) - a.x, cy = static_cast<double>(c.y) - a.y;
    const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double scale = 0.5 / static_cast<double>(orientation(a, b, c));
    double x = (cy * bb - by * cc) * scale, y = (bx * cc - cx * bb) * scale;
    const double along_x = x - 0.5 * bx, along_y = y - 0.5 * by;
    if (farthest * farthest * bb < along_x * along_x + along_y * along_y) {
        x = 0.5 * bx - farthest * by;
        y = 0.5 * by + farthest * bx;
    }
    const auto rounded = [](double v) noexcept {
        constexpr double limit = grid::reach - 1.0;
        return static_cast<std::int32_t>(std::floor((v < -limit ? -limit : v > limit ? limit : v) + 0.5));
    };
    return {rounded(a.x + x), rounded(a.y + y)};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
