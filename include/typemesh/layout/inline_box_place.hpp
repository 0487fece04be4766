// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/outline/bar_face.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Where a box stands in a laid text.
struct inline_box_place {
    std::uint32_t index = 0;  ///< the index of the box in shape_options::boxes
    std::uint32_t unit = 0;   ///< its place in the text
    std::uint32_t glyph = 0;  ///< the index of its glyph, which has no outline, in the run
    std::uint32_t line = 0;   ///< the index of its line in the run
    affine map = {};          ///< maps the square from (0, 0) to (1, 1) to the box, in em
};

/// Calls put(const inline_box_place&) for each box of a run, line by line, from left to right. Boxes whose text is
/// dropped have no place.
///
/// Cost   O(glyphs)
template <class Put>
void each_inline_box(const glyph_run& run, const Put& put) noexcept
{
    if (run.glyph_styles.empty()) return;
    const double em = run.units_per_em > 0.0 ? run.units_per_em : 1.0;
    std::uint32_t line = 0;
    for (std::uint32_t i = 0; i < run.glyphs.size(); ++i) {
        while (line + 1 < run.lines.size() && i >= run.lines[line].first_glyph + run.lines[line].glyph_count) ++line;
        const placed_glyph& g = run.glyphs[i];
        const glyph_style& drawn = run.glyph_styles[g.glyph_style];
        if (drawn.face != bar_face || !is_blank_bar(g.id)) continue;
        affine map = drawn.map;
        map.dx += g.origin.x;
        map.dy += g.origin.y;
        for (double* part : {&map.xx, &map.xy, &map.dx, &map.yx, &map.yy, &map.dy}) *part /= em;
        put(inline_box_place{g.id - blank_bar, g.cluster, i, line, map});
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
