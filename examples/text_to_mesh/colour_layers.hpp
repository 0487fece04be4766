// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "text_fonts.hpp"

#include <typemesh/adapt/harfbuzz_colours.hpp>
#include <typemesh/colour/colour_outlines.hpp>
#include <typemesh/typemesh.hpp>

#include <list>
#include <optional>
#include <string>

namespace text_to_mesh {

struct options;

/// The colour glyphs of a text's fonts, by --colour-layers.
class colour_layers {
public:
    static constexpr float step = 1.0f / 100;  ///< em; how thick the upper layers of a stack are

    colour_layers(font_set& fonts, const options& o);

    /// Replaces the colour glyphs of a run by their layers. Gives an empty string, or one sentence.
    [[nodiscard]] std::string split(typemesh::glyph_run& run);

    [[nodiscard]] typemesh::colour_outlines<font_set>& source() { return source_; }
    [[nodiscard]] const typemesh::colour_report& report() const { return report_; }

    /// The colour of one of its styles, or nothing. Layers of the text's own colour have the colour of the text's style.
    [[nodiscard]] std::optional<rgb_colour> colour_of(typemesh::style_id style, const options& o) const;
    [[nodiscard]] bool owns(typemesh::style_id style) const { return source_.style_of(style) != nullptr; }

private:
    font_set& fonts_;
    typemesh::colour_outlines<font_set> source_;
    std::list<typemesh::harfbuzz_colours> tables_;
    typemesh::colour_report report_;
};

/// Warns of glyphs whose colours are not drawn as the font wants. True if there are any.
bool name_colour_losses(const typemesh::colour_report& report, const std::string& who);

}  // namespace text_to_mesh
