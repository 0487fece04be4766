// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "policies.hpp"

#include <functional>
#include <string_view>

namespace text_to_mesh {

/// Adds a part to a model: the triangles of a range, in one style.
using add_part_function = std::function<void(model&, typemesh::part, const typemesh::mesh_range&, typemesh::style_id)>;

/// Gives each vertex of a written mesh the numbers of its letter, word and line, and the mesh the texts of its letters.
/// Needs the plan's letters.
void name_vertices(const chosen_plan& plan, std::string_view text, model& mesh);

/// Makes a mesh of each letter of a written mesh, with its pivot as its origin, and a place for it. Underlines and other
/// bars are meshes, too. Needs the plan's letters.
void part_letters(const chosen_plan& plan, std::string_view text, model& mesh, const add_part_function& add_part);

}  // namespace text_to_mesh
