// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Returns the value of a variable and resets the variable to the default of its type (null, zero, false): for moves.
/// It does the same as std::exchange(from, {}), and swap_values() the same as std::swap, but they compile much faster.
template <class T>
[[nodiscard]] constexpr T taken(T& from) noexcept
{
    T value = static_cast<T&&>(from);
    from = T{};
    return value;
}

template <class T>
constexpr void swap_values(T& a, T& b) noexcept
{
    T value = static_cast<T&&>(a);
    a = static_cast<T&&>(b);
    b = static_cast<T&&>(value);
}

}  // namespace typemesh::inline TYPEMESH_ABI
