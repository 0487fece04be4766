// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// How many cells an em may have so that 32-bit positions tell neighbouring ones apart, up to `reach` em from the
/// origin: a power of two, from 2^9 to 2^23.
///
/// At a distance of r em floats are at most r * 2^-23 em apart, in every unit. So places a cell apart are written apart
/// if an em has no more than 2^23 / r cells; in a frame whose axes are slanted, which turns rounded places and rounds
/// again, an eighth of that. Beyond 2^14 em (2^11 in slanted frames) less is promised.
///
///     along_axes    whether the frame's axes are those of the output
[[nodiscard]] inline double cells_told_apart(double reach, bool along_axes) noexcept
{
    constexpr double slack = 1.0 + 0x1p-20;  // of computing places in double
    double cells = 0x1p23;
    while (cells * slack * reach * (along_axes ? 1.0 : 8.0) > 0x1p23 && cells > 0x1p9) cells *= 0.5;
    return cells;
}

/// How far from the origin the glyphs of a run reach, in em, if none reaches farther than 2 em beyond its pen. Pens
/// that are not finite do not count. O(glyphs)
[[nodiscard]] inline double reach_of(const glyph_run& run, double units_per_em) noexcept
{
    double farthest = 0.0;
    for (const placed_glyph& g : run.glyphs)
        for (const double v : {std::fabs(g.origin.x), std::fabs(g.origin.y)})
            if (is_finite(v) && v > farthest) farthest = v;
    return farthest / units_per_em + 2.0;
}

/// The same of a text whose ink has this box, in font units.
[[nodiscard]] inline double reach_of(const box& ink, double units_per_em) noexcept
{
    double farthest = 0.0;
    if (ink.empty()) return farthest;
    for (const double v : {ink.low.x, ink.low.y, ink.high.x, ink.high.y})
        if (std::fabs(v) > farthest) farthest = std::fabs(v);
    return farthest / units_per_em;
}

}  // namespace typemesh::inline TYPEMESH_ABI
