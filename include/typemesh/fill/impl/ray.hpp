// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A segment that leaves a point to the right; rays are sorted from bottom to top.
struct ray {
    std::int32_t x, y;  // to the other end: x > 0, or x = 0 and y > 0; both at most 2^29 in size
    std::uint32_t segment;

    /// Positive if `other` lies above, zero if both have one direction. Exact: products below 2^59, their difference
    /// below 2^60.
    [[nodiscard]] std::int64_t cross(ray other) const noexcept
    {
        return std::int64_t{x} * other.y - std::int64_t{y} * other.x;
    }
    [[nodiscard]] bool before(ray other) const noexcept
    {
        const std::int64_t turn = cross(other);
        return turn > 0 || (turn == 0 && segment < other.segment);
    }
};

/// O(count log count); there are usually few.
inline void sort_rays(ray* rays, std::uint32_t count) noexcept
{
    if (count <= 16)
        insertion_sort(rays, count);
    else
        heap_sort(rays, count);
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
