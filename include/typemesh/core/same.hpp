// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether two numbers are equal, as == says: never for NaN. Said by name where the same number is meant and not one
/// near by, so that compilers may warn of every other == between floating-point numbers (-Wfloat-equal).
template <std::floating_point T>
[[nodiscard]] constexpr bool same(T a, T b) noexcept
{
    return a <= b && a >= b;
}

/// Whether a number is 0, of either sign.
template <std::floating_point T>
[[nodiscard]] constexpr bool is_zero(T value) noexcept
{
    return same(value, T{0});
}

}  // namespace typemesh::inline TYPEMESH_ABI
