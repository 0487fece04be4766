// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// Writes a 3MF through lib3mf: one object, a material for each part, one unit per millimetre. Normals and texture
/// coordinates have no place in it.
///
/// The vertices are taken as they are, so a solid must share them between its parts, as typemesh::shared_normals does
/// and sewn(): 3MF wants every edge met by two triangles.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically. Without lib3mf that is what it says.
[[nodiscard]] std::string write_3mf(const model& mesh, const std::string& path, file_set& files);

}  // namespace text_to_mesh
