// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The extents that matter when two triangulations of the same points are compared.
enum class extents : std::uint8_t { both, widths, heights };

/// prefers_other_diagonal() for ellipses that are stretched without limit in the direction that does not matter. For
/// `widths` the triangles become narrow, however tall they are, and so need no points inside:
///
///       d-------------------c              d-------------------c
///       |             .    /|              |\          .      /|      the ellipse through the corners of a triangle
///       |        .       /  |              | \        .     /  |      holds no other point
///       |   .           /   |    -->       |  \      .    /    |
///       a--------------b----e              a----------b---------e
///
/// The test of circles with x * x for x * x + y * y is the limit of the test of ellipses. It is exact, in the budget of
/// in_circle(). Where the limit does not decide, the test of circles does, so a flip always leads to a triangulation
/// that is better in both tests, taken in this order, and flipping ends.
[[nodiscard]] constexpr bool prefers_other_diagonal(extents compared, grid_point a, grid_point b, grid_point c,
                                                    grid_point d) noexcept
{
    if (compared == extents::both) return prefers_other_diagonal(a, b, c, d);
    const std::int64_t acx = std::int64_t{a.x} - c.x, acy = std::int64_t{a.y} - c.y, bcx = std::int64_t{b.x} - c.x,
                       bcy = std::int64_t{b.y} - c.y;
    const std::int64_t adx = std::int64_t{a.x} - d.x, ady = std::int64_t{a.y} - d.y, bdx = std::int64_t{b.x} - d.x,
                       bdy = std::int64_t{b.y} - d.y;
    const bool by_x = compared == extents::widths;
    const two_words sum = sum_of_products(acx * bcy - acy * bcx, by_x ? adx * bdx : ady * bdy,
                                          by_x ? acx * bcx : acy * bcy, bdx * ady - bdy * adx);
    if ((sum.high | sum.low) != 0) return static_cast<std::int64_t>(sum.high) < 0;
    return prefers_other_diagonal(a, b, c, d);
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
