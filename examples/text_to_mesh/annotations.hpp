// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "policies.hpp"

#include <typemesh/adapt/harfbuzz.hpp>

namespace text_to_mesh {

/// The lines and dots that --show asks for, drawn on the front of the mesh: control polygons and contours from the
/// stages themselves, called one by one for each glyph of the run; normals from the finished mesh.
[[nodiscard]] overlay annotate(const options& o, typemesh::harfbuzz_font& font, const typemesh::glyph_run& run,
                               const chosen_discretiser& discretiser, const model& mesh);

}  // namespace text_to_mesh
