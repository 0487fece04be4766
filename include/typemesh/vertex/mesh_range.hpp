// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A subrange of the output: vertices [first_vertex, first_vertex + vertex_count), indices likewise.
struct mesh_range {
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;

    friend constexpr bool operator==(const mesh_range&, const mesh_range&) noexcept = default;
};

}  // namespace typemesh::inline TYPEMESH_ABI
