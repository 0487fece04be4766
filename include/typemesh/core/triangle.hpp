// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Three indices into a region's points, counter-clockwise.
struct triangle {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t c = 0;

    friend constexpr bool operator==(const triangle&, const triangle&) noexcept = default;
};

using triangle_list = buffer<triangle>;  ///< triangles in an array, in any order

}  // namespace typemesh::inline TYPEMESH_ABI
