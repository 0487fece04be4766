// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The greater distance of the ends of an interval from a place.
[[nodiscard]] constexpr double farthest(double low, double high, double from) noexcept
{
    const double below = low > from ? low - from : from - low, above = high > from ? high - from : from - high;
    return below > above ? below : above;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
