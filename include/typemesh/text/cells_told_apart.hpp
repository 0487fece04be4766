// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// How many cells an em may have so that 32-bit positions tell neighbouring ones apart wherever a glyph of the run
/// stands: a power of two, from 2^9 to 2^21.
///
/// At a distance of r em from the origin floats are at most r * 2^-23 em apart, in every unit. So places a cell apart
/// are written apart if an em has no more than 2^23 / r cells; in a frame whose axes are slanted, which turns rounded
/// places and rounds again, an eighth of that. Glyphs are taken to reach 2 em beyond their pens. Beyond 2^14 em (2^11
/// in slanted frames) less is promised.
///
///     along_axes    whether the frame's axes are those of the output
///
/// Cost   O(glyphs)
[[nodiscard]] inline double cells_told_apart(const glyph_run& run, double units_per_em, bool along_axes) noexcept
{
    double farthest = 0.0;
    for (const placed_glyph& g : run.glyphs)
        for (const double v : {std::fabs(g.origin.x), std::fabs(g.origin.y)})
            if (is_finite(v) && v > farthest) farthest = v;
    constexpr double slack = 1.0 + 0x1p-20;  // of computing places in double
    const double reach = slack * (farthest / units_per_em + 2.0) * (along_axes ? 1.0 : 8.0);
    double cells = 0x1p23;
    while (cells * reach > 0x1p23 && cells > 0x1p9) cells *= 0.5;
    return cells;
}

}  // namespace typemesh::inline TYPEMESH_ABI
