// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "options.hpp"
#include "text_fonts.hpp"

#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/text_options.hpp>

#include <string>

namespace text_to_mesh {

/// Writes the outlines of a text, or of the drawing of --svg, as a drawing of curves: .svg or .dxf. `said` tells how
/// much of it there is. Gives an empty string, or one sentence.
[[nodiscard]] std::string write_curves(const options& o, font_set& font, const typemesh::glyph_run& page,
                                       const typemesh::text_options& how, file_set& files, std::string& said);

}  // namespace text_to_mesh
