// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// Writes a binary STL. Facet normals come from the positions (zero for a triangle without area), which are written
/// unchanged, so that equal corners weld. Normals and texture coordinates of the vertices have no place in this format.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_stl(const model& mesh, const std::string& path, file_set& files);

}  // namespace text_to_mesh
