// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The bridges that an island gets.
struct stencil_wishes {
    static constexpr std::uint32_t max_per_island = 8;  ///< the greatest number of bridges per island

    std::int32_t width = 1;        ///< the width of a bridge, in cells: at least 1
    std::uint32_t per_island = 1;  ///< the number of bridges per island, 1 to max_per_island

    /// The refusal of a wish outside its range, or none.
    [[nodiscard]] error refused() const noexcept
    {
        if (width < 1) return error::bad("width");
        if (per_island < 1 || per_island > max_per_island) return error::bad("per_island");
        return {};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
