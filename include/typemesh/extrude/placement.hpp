// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/vertex/frame.hpp>

namespace typemesh {

/// Where a shape stands and in which unit it is written: from grid cells to the caller's coordinates.
///
///     output = frame((cell + pen) * unit_per_cell)        z = em * unit_per_em
///
/// The sum is exact in double precision and rounded to 32 bits once, so equal places give equal floats.
struct placement {
    point pen;                   ///< the glyph's origin, in cells
    double unit_per_cell = 1.0;
    double unit_per_em = 1.0;
    double em_per_cell = 1.0;
    point em_pen;                ///< em mapping: the glyph's origin, in cells, seen from the text's own origin
    point texture_pen;           ///< box mapping: the glyph's origin, in cells, seen from the box's lower left corner
    point texture_per_cell;      ///< box mapping: how much u and v grow with a cell; 0 where the box has no extent
    typemesh::frame frame;

    /// A grid point at height z, given in output units.
    [[nodiscard]] vec3 position(grid_point p, float z) const noexcept
    {
        return frame(static_cast<float>((p.x + pen.x) * unit_per_cell), static_cast<float>((p.y + pen.y) * unit_per_cell), z);
    }

    /// A wall's normal, given in the plane.
    [[nodiscard]] vec3 normal(vec2 n) const noexcept { return frame(n.x, n.y, 0.0f); }

    /// The front cap's normal; the back's with sign = -1.
    [[nodiscard]] vec3 cap_normal(float sign) const noexcept { return frame(0.0f, 0.0f, sign); }
};

}  // namespace typemesh
