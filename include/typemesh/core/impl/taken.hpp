// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The value of a variable, which has the default of its type (null, zero, false) from then on: for moves. As
/// std::exchange(from, {}), and swap_values() as std::swap, which compilers take far longer for.
template <class T>
[[nodiscard]] constexpr T taken(T& from) noexcept
{
    T value = static_cast<T&&>(from);
    from = T{};
    return value;
}

/// Exchanges two values.
template <class T>
constexpr void swap_values(T& a, T& b) noexcept
{
    T value = static_cast<T&&>(a);
    a = static_cast<T&&>(b);
    b = static_cast<T&&>(value);
}

}  // namespace typemesh::inline TYPEMESH_ABI
