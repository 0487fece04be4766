// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A range of a text's units, [first, last).
struct text_range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    /// Whether the unit lies in the range.
    [[nodiscard]] constexpr bool holds(std::uint32_t unit) const noexcept { return unit >= first && unit < last; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
