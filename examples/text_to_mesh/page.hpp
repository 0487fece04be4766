// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "text_fonts.hpp"

#include <typemesh/layout/glyph_run.hpp>

#include <string>

namespace text_to_mesh {

/// Lays the text out: `page` gets its lines. If a box is to be filled, `size` gets the size of an em, nearly. Returns an
/// empty string, or one sentence of what is wrong.
[[nodiscard]] std::string lay_out(const options& o, font_set& font, typemesh::glyph_run& page, double& size);

}  // namespace text_to_mesh
