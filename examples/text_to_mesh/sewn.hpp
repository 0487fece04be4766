// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

namespace text_to_mesh {

/// The same mesh with one vertex instead of several at a place, where triangles of a solid meet along their edges. Solids that
/// only touch, in points or in edges met by more than two triangles, keep vertices of their own. Normals and texture
/// coordinates come from any of the vertices that became one.
[[nodiscard]] model sewn(const model& mesh);

}  // namespace text_to_mesh
