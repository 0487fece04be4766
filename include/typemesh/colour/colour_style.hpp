// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The paint of a style that colour_outlines::split() has given to layers.
///
/// A solid paint has one style for each palette entry, colour and level; a gradient has one for each layer of a glyph.
struct colour_style {
    glyph_paint paint;       ///< its stops are colour_outlines::stops_of()
    std::uint32_t face = 0;  ///< the face of its palette
    style_id own = {};       ///< of a paint in the text's colour: the style of the glyph; otherwise 0

    /// With layer_cut::stacked, the place of the layer in its glyph: 0 for the lowest. Make level 0, with all other
    /// glyphs, as deep as the text, and each further level thin, with its back in the plane of the front below it; then
    /// no two faces lie in one plane. select_glyphs() takes a level out of a run. 0 with layer_cut::visible.
    std::uint32_t level = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
