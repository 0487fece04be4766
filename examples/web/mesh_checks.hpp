// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_arrays.hpp"

#include <cstdint>
#include <vector>

namespace typemesh_web {

/// Directed edges that do not occur as often as their reverse.
[[nodiscard]] std::uint32_t open_edges(const mesh_arrays& mesh);

/// The contours of what is seen from the front, front and its bevel, of each solid for itself: edges with a triangle on
/// one side only. Six numbers a segment: both its ends.
void contours_of(const mesh_arrays& mesh, std::vector<float>& segments);

/// FNV-1a, 64 bits, of the bytes of position, normal, uv and index, one behind the other.
[[nodiscard]] std::uint64_t hash_of(const mesh_arrays& mesh);

}  // namespace typemesh_web
