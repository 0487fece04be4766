// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The rule that decides which points are inside closed contours. It uses the winding number w: how often the contours
/// wind around the point, counter-clockwise positive.
enum class fill_rule : std::uint8_t {
    non_zero,  ///< inside where w != 0: the rule of TrueType, CFF and PostScript
    even_odd,  ///< inside where w is odd
};

/// Whether points with this winding number are inside.
[[nodiscard]] constexpr bool is_filled(fill_rule rule, std::int32_t winding) noexcept
{
    return (winding & (rule == fill_rule::non_zero ? -1 : 1)) != 0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
