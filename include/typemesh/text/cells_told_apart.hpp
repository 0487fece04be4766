// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The largest number of cells that an em may have so that 32-bit positions distinguish neighbouring cells, up to
/// `reach` em from the origin. It is a power of two from 2^9 to 2^23.
///
/// At a distance of r em, adjacent floats are at most r * 2^-23 em apart, in every unit. Places one cell apart are
/// therefore written as distinct positions if an em has at most 2^23 / r cells. A frame whose axes are not parallel to
/// the output's axes rotates rounded places and rounds again, so its limit is an eighth of this. Beyond 2^14 em (2^11
/// in these frames) distinct positions are not guaranteed.
///
///     along_axes    whether the frame's axes are parallel to the output's axes
[[nodiscard]] inline double cells_told_apart(double reach, bool along_axes) noexcept
{
    constexpr double slack = 1.0 + 0x1p-20;  // a margin for rounding of places computed in double precision
    double cells = 0x1p23;
    while (cells * slack * reach * (along_axes ? 1.0 : 8.0) > 0x1p23 && cells > 0x1p9) cells *= 0.5;
    return cells;
}

/// The distance from the origin that the glyphs of a run reach, in em, if no glyph extends more than 2 em beyond its
/// pen. Pens that are not finite are ignored. O(glyphs)
[[nodiscard]] inline double reach_of(const glyph_run& run, double units_per_em) noexcept
{
    double farthest = 0.0;
    for (const placed_glyph& g : run.glyphs)
        for (const double v : {std::fabs(g.origin.x), std::fabs(g.origin.y)})
            if (is_finite(v) && v > farthest) farthest = v;
    return farthest / units_per_em + 2.0;
}

/// The distance for a text whose ink has this box, in font units.
[[nodiscard]] inline double reach_of(const box& ink, double units_per_em) noexcept
{
    double farthest = 0.0;
    if (ink.empty()) return farthest;
    for (const double v : {ink.low.x, ink.low.y, ink.high.x, ink.high.y})
        if (std::fabs(v) > farthest) farthest = std::fabs(v);
    return farthest / units_per_em;
}

}  // namespace typemesh::inline TYPEMESH_ABI
