// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/finite.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A lower bound of a deformation's Jacobian determinant over a box, from its value in the middle.
struct determinant_bound {
    double middle = 0.0;  ///< the determinant there
    double lowest = 0.0;  ///< no determinant in the box is lower
    int cut_axis = 0;     ///< the axis along which the box must be cut to raise that bound most: 0, 1 or 2
};

template <deformation D>
[[nodiscard]] determinant_bound bound_determinant(const D& d, const box3& b) noexcept
{
    const double3 half = 0.5 * (b.high - b.low);
    const deformed_point j = d(b.low + half);
    const bend_bounds by = d.bend(b);
    // No column differs by more than this from the column in the middle.
    const double3 by_x{by.xx * half.x + by.x_jump, by.xy * half.y, by.xz * half.z},
        by_y{by.xy * half.x, by.yy * half.y, by.yz * half.z}, by_z{by.xz * half.x, by.yz * half.y, by.zz * half.z};
    const auto sum = [](double3 a) noexcept { return a.x + a.y + a.z; };
    const double x = length(j.x), y = length(j.y), z = length(j.z);
    determinant_bound out;
    out.middle = dot(j.x, cross(j.y, j.z));
    // The determinant is linear in each column, so it changes by no more than the products that contain a difference.
    const double change = (x + sum(by_x)) * (y + sum(by_y)) * (z + sum(by_z)) - x * y * z;
    out.lowest = out.middle - (1.0 + 0x1p-40) * change;
    const double from_x = by_x.x * y * z + by_y.x * z * x + by_z.x * x * y,
                 from_y = by_x.y * y * z + by_y.y * z * x + by_z.y * x * y,
                 from_z = by_x.z * y * z + by_y.z * z * x + by_z.z * x * y;
    out.cut_axis = from_x >= from_y && from_x >= from_z ? 0 : from_y >= from_z ? 1 : 2;
    return out;
}

}  // namespace detail

/// Whether a deformation is proven to turn nothing inside out in a box: its Jacobian determinant is positive at all
/// points. The box is halved until the bounds of the second derivatives prove it.
///
/// False if the determinant is somewhere not more than 2^-40 of its value in the middle of the box, so that roundings
/// cannot matter, or so small that 4096 pieces prove nothing. A deformation that keeps all volumes (D::keeps_volume)
/// needs no proof.
template <deformation D>
[[nodiscard]] bool is_unfolded(const D& d, const box3& whole) noexcept
{
    constexpr std::size_t depth = 48;
    box3 waiting[depth + 1] = {whole};
    std::size_t count = 1;
    double least = 0.0;
    for (int pieces = 0; count != 0; ++pieces) {
        const box3 b = waiting[--count];
        const detail::determinant_bound bound = detail::bound_determinant(d, b);
        if constexpr (requires { requires D::keeps_volume; }) return bound.middle > 0.0 && is_finite(bound.lowest);
        if (pieces == 0) least = 0x1p-40 * bound.middle;
        if (bound.lowest > least) continue;
        if (!(bound.middle > least) || pieces >= 4096 || count + 2 > depth) return false;
        box3 first = b, second = b;
        const double3 middle = 0.5 * (b.low + b.high);
        switch (bound.cut_axis) {
        case 0: first.high.x = second.low.x = middle.x; break;
        case 1: first.high.y = second.low.y = middle.y; break;
        default: first.high.z = second.low.z = middle.z; break;
        }
        waiting[count++] = first;
        waiting[count++] = second;
    }
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
