// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A bound of the distance between a bent triangle and the flat triangle over the images of its corners: no point of
/// the flat triangle is farther than this from the image of its own place.
///
///     bounds     of the second derivatives, at all points of the triangle
///     extent     the size of the box around the triangle, before it is bent
///
/// Let v be the corners and l the barycentric coordinates of a point p, and expand the deformation at p towards each
/// corner. The constant and linear terms cancel out. What remains is at most 1/2 sum l |D2[v - p, v - p]|, which is at
/// most 1/2 sum of B_ij l |v_i - p_i| |v_j - p_j| over the axes i and j. By the Cauchy-Schwarz inequality that is at
/// most 1/2 sum B_ij s_i s_j, where s_i is the standard deviation of the corners' i-th coordinates with the weights l.
/// A standard deviation is at most half of the extent (T. Popoviciu 1935), so the bound is 1/8 sum B_ij w_i w_j. It is
/// sharp for an edge. In contrast to a bound by the smallest enclosing circle (S. Waldron, The error in linear
/// interpolation at the vertices of a simplex, 1998), it sees in which directions the deformation bends.
[[nodiscard]] constexpr double bend_error(const bend_bounds& bounds, double3 extent) noexcept
{
    const double alone = bounds.xx * extent.x * extent.x + bounds.yy * extent.y * extent.y +
                         bounds.zz * extent.z * extent.z,
                 mixed = bounds.xy * extent.x * extent.y + bounds.xz * extent.x * extent.z +
                         bounds.yz * extent.y * extent.z;
    return (0.125 + 0x1p-40) * (alone + 2.0 * mixed);  // more than all roundings together
}

}  // namespace typemesh::inline TYPEMESH_ABI
