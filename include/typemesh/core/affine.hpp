// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// An affine map of the plane: x' = xx x + xy y + dx, y' = yx x + yy y + dy.
struct affine {
    double xx = 1.0, xy = 0.0, dx = 0.0;
    double yx = 0.0, yy = 1.0, dy = 0.0;

    [[nodiscard]] constexpr point operator()(point p) const noexcept
    {
        return {xx * p.x + xy * p.y + dx, yx * p.x + yy * p.y + dy};
    }

    /// Compares the numbers one by one. A map with a NaN equals no map.
    friend constexpr bool operator==(const affine& a, const affine& b) noexcept
    {
        return same(a.xx, b.xx) && same(a.xy, b.xy) && same(a.dx, b.dx) && same(a.yx, b.yx) && same(a.yy, b.yy) &&
               same(a.dy, b.dy);
    }
};

/// The map that first scales by `factor` and then applies `map`: result(p) = map(factor * p) for every p.
[[nodiscard]] constexpr affine scaled_before(const affine& map, double factor) noexcept
{
    return {map.xx * factor, map.xy * factor, map.dx, map.yx * factor, map.yy * factor, map.dy};
}

}  // namespace typemesh::inline TYPEMESH_ABI
