// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "options.hpp"
#include "policies.hpp"
#include "text_fonts.hpp"

#include <span>

namespace text_to_mesh {

/// The lines and dots that --show names, drawn on the front of the mesh: control polygons and contours from the
/// stages themselves, called one by one for each glyph of the run; normals from the finished mesh. With --merge
/// contours and points come from the merged glyphs; where edges have moved (--embolden, --outline), from the mesh.
[[nodiscard]] overlay annotate(const options& o, font_set& font, const typemesh::glyph_run& run,
                               std::span<const typemesh::drawn_glyph> shapes, const model& mesh);

}  // namespace text_to_mesh
