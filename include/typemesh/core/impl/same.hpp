// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether two numbers are equal, by ==: never for NaN. Use it where exact equality is meant, so that compilers may
/// warn about every other == between floating-point numbers (-Wfloat-equal).
template <std::floating_point T>
[[nodiscard]] constexpr bool same(T a, T b) noexcept
{
    return a <= b && a >= b;
}

/// Whether a number is +0 or -0.
template <std::floating_point T>
[[nodiscard]] constexpr bool is_zero(T value) noexcept
{
    return same(value, T{0});
}

}  // namespace typemesh::inline TYPEMESH_ABI
