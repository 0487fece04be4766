// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/impl/mixed_key.hpp>

#include <concepts>
#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// The state in which an outline source draws (the axes of a variable font, a transformation), as the number that its
/// member `std::uint64_t variation_key() const noexcept` returns: different for states that draw differently. 0 if it
/// has no such member. The number is a 64-bit hash: that two of a million states share one has odds of about
/// one in 37 million.
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

/// Mixes a map into a key.
[[nodiscard]] inline std::uint64_t mixed_key(std::uint64_t key, const affine& map) noexcept
{
    for (const double number : {map.xx, map.xy, map.dx, map.yx, map.yy, map.dy}) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        key = mixed_key(key, bits);
    }
    return key;
}

}  // namespace typemesh::inline TYPEMESH_ABI
