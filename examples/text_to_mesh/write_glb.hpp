// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// Writes a binary glTF 2.0: one mesh, one primitive and material per part, indices of 16 bits where they can number
/// the vertices. An instanced model becomes a mesh for each letter (and each colour of it, over the same vertices) and,
/// under one node, a node for each place, named after its letter and counted: "e_2". `extras` of the text's node and of
/// the letters' hold what they show, as "text". Places with numbers have them as "letter", "word" and "line".
///
/// model::vertex_letters become the attributes _LETTER, _WORD, _LINE (numbers, as 32-bit floats, which hold them exactly
/// up to 2^24) and _PIVOT (a place). The texts of the letters are "letters" in the extras of the text's node.
///
/// With model::as_manifold it has the extension EXT_mesh_manifold: a further primitive of the mesh, whose indices share the
/// bytes of all others, and a sparse accessor with the indices that become others (manifold_of()). Programs that
/// compute with solids then need no welding.
///
/// Texture coordinates are written unchanged: glTF puts v = 0 at the top. A model without triangles gives a valid file
/// whose scene is empty, since glTF knows no empty mesh.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_glb(const model& mesh, const std::string& path, file_set& files);

}  // namespace text_to_mesh
