// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A number without its last 12 bits, in which the standard libraries' functions differ. Below 2^-991 it keeps them:
/// they may be all that it has, and such a sine is the angle itself.
[[nodiscard]] inline double steady(double v) noexcept
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    if ((bits >> 52 & 0x7FFu) < 32) return v;
    bits = (bits + 0x800u) & ~std::uint64_t{0xFFF};
    std::memcpy(&v, &bits, sizeof v);
    return v;
}

[[nodiscard]] inline double steady_sine(double angle) noexcept { return steady(std::sin(angle)); }
[[nodiscard]] inline double steady_cosine(double angle) noexcept { return steady(std::cos(angle)); }

/// The greater distance of the ends of an interval from a place.
[[nodiscard]] constexpr double farthest(double low, double high, double from) noexcept
{
    const double below = low > from ? low - from : from - low, above = high > from ? high - from : from - high;
    return below > above ? below : above;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
