// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "text_fonts.hpp"

#include <typemesh/layout/glyph_run.hpp>

#include <string>

namespace text_to_mesh {

/// Lays the text out as a paragraph, if the options ask for one: `page` gets its lines, `size`, if a box is to be filled,
/// that of an em. Gives an empty string, or one sentence of what is wrong.
[[nodiscard]] std::string lay_out_page(const options& o, font_set& font, typemesh::glyph_run& page, double& size);

/// What a mesher plans: that page, or the plain text.
template <class Mesher>
[[nodiscard]] auto plan_of(Mesher& mesher, const options& o, const typemesh::glyph_run& page,
                           const typemesh::text_options& how)
{
    return o.page ? mesher.plan(page, how) : mesher.plan(o.text, how);
}

}  // namespace text_to_mesh
