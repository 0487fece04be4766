// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Mixes one more number into a key, with an odd multiplier and a shift. Both order and position matter.
[[nodiscard]] constexpr std::uint64_t mixed_key(std::uint64_t key, std::uint64_t number) noexcept
{
    key = (key ^ number) * 0x9E37'79B9'7F4A'7C15u;
    return key ^ key >> 32;
}

}  // namespace typemesh::inline TYPEMESH_ABI
