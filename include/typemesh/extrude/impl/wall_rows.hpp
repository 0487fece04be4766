// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The rows of vertices of upright walls that are divided into segments along the depth.
///
///     row 0           o----o  top      segments + 1 rows at equal distances. The first row lies exactly at the top,
///     row 1           o----o           and the last row exactly at the bottom
///     row 2           o----o
///     row segments    o----o  bottom
struct wall_rows {
    static constexpr std::uint32_t most = 1024;  ///< the largest number of segments

    double top = 0.0;  ///< heights, in the extruder's unit
    double bottom = 0.0;
    std::uint32_t segments = 1;  ///< 1 to `most`

    [[nodiscard]] static constexpr bool is_valid(std::uint32_t segments) noexcept
    {
        return segments != 0 && segments <= most;
    }

    /// The height of a row. It is computed from the middle, so that the rows of a centred solid are symmetric to the
    /// bit. The sum adds a quotient, so no compiler can fuse it with a product.
    [[nodiscard]] double height(std::uint32_t row) const noexcept
    {
        if (row == 0) return top;
        if (row == segments) return bottom;
        const double steps = static_cast<double>(segments), up = steps - 2.0 * static_cast<double>(row);
        return 0.5 * (top + bottom) + 0.5 * (top - bottom) * up / steps;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
