// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Which points closed contours fill, decided by the winding number w: how often the contours wind around the point,
/// counter-clockwise positive.
enum class fill_rule : std::uint8_t {
    non_zero,  ///< filled where w != 0: what TrueType, CFF and PostScript mean
    even_odd,  ///< filled where w is odd
};

/// Whether a place with this winding number is filled.
[[nodiscard]] constexpr bool is_filled(fill_rule rule, std::int32_t winding) noexcept
{
    return (winding & (rule == fill_rule::non_zero ? -1 : 1)) != 0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
