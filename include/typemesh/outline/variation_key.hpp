// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// What an outline source tells of the state in which it draws (the axes of a variable font, a transformation), by its
/// member `std::uint64_t variation_key() const noexcept`: where two states draw differently the numbers differ. 0 where
/// it has no such member. The state is mixed into 64 bits; two of them in a million million share a number.
template <class Source>
[[nodiscard]] std::uint64_t variation_of(const Source& source) noexcept
{
    if constexpr (requires { { source.variation_key() } noexcept -> std::convertible_to<std::uint64_t>; })
        return source.variation_key();
    else
        return 0;
}

/// One number more in a key: an odd multiple and a shift, so that order and place count.
[[nodiscard]] constexpr std::uint64_t mixed_key(std::uint64_t key, std::uint64_t number) noexcept
{
    key = (key ^ number) * 0x9E37'79B9'7F4A'7C15u;
    return key ^ key >> 32;
}

}  // namespace typemesh::inline TYPEMESH_ABI
