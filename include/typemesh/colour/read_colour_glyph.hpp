// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/colour_tables.hpp>
#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/colour/impl/paint_reader.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/result.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The choices in reading colour glyphs, and the limits against hostile tables.
struct colour_choice {
    std::uint32_t palette = 0;        ///< the number of the palette; numbers that the font does not have mean palette 0
    palette_colour foreground = {};   ///< the colour of the text, for stops of gradients and means
    std::uint32_t max_layers = 4096;  ///< the greatest number of layers of a glyph; at most 32,767 count
    std::uint32_t max_paints = 65536;  ///< the greatest number of paints read for a glyph, each repetition counted
};

/// Reads the layers of a colour glyph from the tables of its font, without drawing anything.
///
///     COLR version 0   layers of solid paint
///     COLR version 1   all 32 paints: solid and gradient paints; glyphs, layers and glyphs within glyphs; every
///                      transform; variations at colour_tables::axes; clip boxes. A glyph's paint of version 1 precedes
///                      its layers of version 0
///
/// Composites become shapes as far as they cut: clear, source, destination, and the modes over, in, out and atop in
/// both directions, and xor are exact for opaque paints (see colour_glyph::translucent). The other modes mix colours;
/// their source is drawn above the backdrop, and colour_glyph::blended counts them.
///
///     out    the layers; without any if the result is false
///
/// Gives  whether the font has colours for the glyph
/// Fails  error::bad_colours: the table is damaged, paints contain each other in a cycle or more than 64 deep, or a
///        limit is exceeded
///        error::out_of_memory; `out` then has no layers
/// Cost   O(paints)
/// From   OpenType specification 1.9.1, "COLR" and "CPAL"
[[nodiscard]] inline result<bool> read_colour_glyph(const colour_tables& font, glyph_id id, const colour_choice& how,
                                                    colour_glyph& out) noexcept
{
    out.clear();
    if (!font.has_layers() || id > 0xFFFF) return false;
    detail::paint_reader reader{font, how.palette, how.foreground, how.max_layers, how.max_paints, out};
    const result<bool> found = reader.read(id);
    if (!found || !*found) out.clear();
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI
