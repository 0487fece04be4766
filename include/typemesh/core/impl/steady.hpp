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
[[nodiscard]] inline double steady_tangent(double angle) noexcept { return steady(std::tan(angle)); }
/// The angle of the vector (x, y).
[[nodiscard]] inline double steady_angle(double y, double x) noexcept { return steady(std::atan2(y, x)); }

}  // namespace typemesh::inline TYPEMESH_ABI::detail
