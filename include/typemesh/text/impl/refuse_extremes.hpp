// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>

#include <cmath>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a text with this placement can be written in 32-bit floats: every position is finite, and both the cells of
/// the grid (at most 2^25 per em) and the distance between the two heights are larger than the smallest normal float.
///
/// Fails  error::bad_option: "size", or the given name of the heights
inline error refuse_extremes(const text_placement& placed, const bounds3& bounds, height_range heights,
                             const char* heights_name) noexcept
{
    if (!is_finite(placed.unit_per_em) || !(placed.unit_per_em >= 0x1p-100)) return error::bad("size");
    const auto is_float = [](double v) noexcept {
        return is_finite(v) && std::fabs(v) <= as_double((std::numeric_limits<float>::max)());
    };
    for (const double h : {heights.low, heights.high})
        if (!is_float(h * placed.unit_per_depth) || !is_float(h * placed.em_per_depth)) return error::bad(heights_name);
    const double depth = std::fabs(heights.high - heights.low), between = depth * placed.unit_per_depth;
    const bool apart = between >= as_double((std::numeric_limits<float>::min)());
    if (!same(heights.low, heights.high) && !apart) return error::bad(heights_name);
    if (!is_float(depth * placed.em_per_depth)) return error::bad(heights_name);  // texture coordinates grow by it
    for (const vec3 corner : {bounds.low, bounds.high})
        for (const float v : {corner.x, corner.y, corner.z})
            if (!is_finite(as_double(v))) return error::bad("size");
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
