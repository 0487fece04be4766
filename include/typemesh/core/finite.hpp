// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// True for every number except NaN and the infinities. It reads the bits, so it also works under -ffast-math.
[[nodiscard]] inline bool is_finite(double value) noexcept
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return (bits & 0x7FF0'0000'0000'0000u) != 0x7FF0'0000'0000'0000u;
}

}  // namespace typemesh::inline TYPEMESH_ABI
