// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One glyph at its position: `origin` is where the glyph's own (0, 0) goes, in font units, y up.
struct placed_glyph {
    glyph_id id = 0;
    cluster_id cluster = 0;
    point origin = {};
    bool missing = false;  ///< the font has no glyph for this text: `id` is its .notdef, drawn only on request
};

/// One line (or column) of a run: which glyphs, where its baseline begins, how long it is.
struct text_line {
    std::uint32_t first_glyph = 0;
    std::uint32_t glyph_count = 0;
    point origin = {};     ///< the pen position at the line's start, alignment included
    double advance = 0.0;  ///< how far the pen moved, in font units, never negative
};

/// Shaped text: what every stage after shaping works from. Make one by hand and no shaper is needed.
///
/// Glyphs are in drawing order (left to right in a horizontal line, whatever the script's direction); a line's glyphs
/// are contiguous. A run made by hand may leave `lines` empty: it then counts as one line.
struct glyph_run {
    buffer<placed_glyph> glyphs;
    buffer<text_line> lines;
    double units_per_em = 1000.0;  ///< of the font that `id` and `origin` belong to

    std::uint32_t missing = 0;                 ///< glyphs that the font lacks (drawn as .notdef only on request)
    cluster_id first_missing = no_cluster;     ///< the position of the first of them in the text
    std::uint32_t invalid_units = 0;           ///< places where the text was not valid UTF and U+FFFD was read instead
    cluster_id first_invalid_unit = no_cluster;

    explicit glyph_run(memory source = heap()) noexcept : glyphs{source}, lines{source} {}

    void clear() noexcept
    {
        glyphs.clear();
        lines.clear();
        missing = invalid_units = 0;
        first_missing = first_invalid_unit = no_cluster;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
