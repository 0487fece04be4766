// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/impl/mixed_key.hpp>

#include <concepts>
#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// A number for the state in which an outline source draws (the axes of a variable font, a transformation). The
/// source's member `std::uint64_t variation_key() const noexcept` returns it. States that draw differently have
/// different numbers. Without such a member it is 0. The number is a 64-bit hash: the odds that two of a million states
/// share one are about one in 37 million.
template <class Source>
[[nodiscard]] std::uint64_t variation_of(const Source& source) noexcept
{
    if constexpr (requires {
                      { source.variation_key() } noexcept -> std::convertible_to<std::uint64_t>;
                  })
        return source.variation_key();
    else
        return 0;
}

namespace detail {

/// The bits of a number, for keys.
[[nodiscard]] inline std::uint64_t bits_of(double number) noexcept
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

}  // namespace detail

/// Mixes a map into a key.
[[nodiscard]] inline std::uint64_t mixed_key(std::uint64_t key, const affine& map) noexcept
{
    for (const double number : {map.xx, map.xy, map.dx, map.yx, map.yy, map.dy})
        key = mixed_key(key, detail::bits_of(number));
    return key;
}

}  // namespace typemesh::inline TYPEMESH_ABI
