// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Twice the signed area of the triangle a, b, c. It is positive if counter-clockwise, and zero exactly if collinear.
///
/// Exact. Budget: |coordinate| <= 2^28, differences < 2^30, products < 2^60, their difference < 2^61.
[[nodiscard]] constexpr std::int64_t orientation(grid_point a, grid_point b, grid_point c) noexcept
{
    const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
    const std::int64_t acx = std::int64_t{c.x} - a.x, acy = std::int64_t{c.y} - a.y;
    return abx * acy - aby * acx;
}

/// The squared distance between two grid points, exact. Budget: differences <= 2^29, their squares <= 2^58, the
/// sum <= 2^59.
[[nodiscard]] constexpr std::int64_t squared_distance(grid_point a, grid_point b) noexcept
{
    const std::int64_t x = std::int64_t{b.x} - a.x, y = std::int64_t{b.y} - a.y;
    return x * x + y * y;
}

/// The order of a left-to-right sweep: by x, then by y.
[[nodiscard]] constexpr bool lexicographic_less(grid_point a, grid_point b) noexcept
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

}  // namespace typemesh::inline TYPEMESH_ABI
