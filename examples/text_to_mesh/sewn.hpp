// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace text_to_mesh {

/// For each vertex of a mesh, the vertex that sewn() puts in its place; of itself, if it stays. Both are at one place.
[[nodiscard]] std::vector<std::uint32_t> sewn_vertices(const model& mesh);

/// The indices that change if the vertices of a mesh are sewn: their places among the indices, ascending, and the vertices
/// that stand there then.
struct merged_indices {
    std::vector<std::uint32_t> places;
    std::vector<std::uint32_t> vertices;
};

/// What makes a mesh a 2-manifold by its indices: then each directed edge has exactly one reverse. Nothing if sewing does
/// not make it one, because it is open or solids touch.
[[nodiscard]] std::optional<merged_indices> manifold_of(const model& mesh);

/// The same mesh with one vertex instead of several at a place, where triangles of a solid meet along their edges. Solids that
/// only touch, in points or in edges met by more than two triangles, keep vertices of their own. Normals and texture
/// coordinates come from any of the vertices that became one.
[[nodiscard]] model sewn(const model& mesh);

}  // namespace text_to_mesh
