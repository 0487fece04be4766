// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/inline_box_place.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// The map of an inline box where a path, or another step that places letters, puts it: the box turns with its text.
///
///     std::vector<glyph_stand> stands(page.glyphs.size());
///     if (error e = on_ring.place(page, page.units_per_em, stands.data())) ...      // on_path on_ring{&ring}
///     each_inline_box(page, [&](const inline_box_place& b) noexcept {
///         if (!stands[b.glyph].left_out) draw_icon(b.index, box_on_stand(b, page, stands[b.glyph]));
///     });
[[nodiscard]] inline affine box_on_stand(const inline_box_place& box, const glyph_run& run,
                                         const glyph_stand& stand) noexcept
{
    const double em = run.units_per_em > 0.0 ? run.units_per_em : 1.0;
    const point flat = (1.0 / em) * run.glyphs[box.glyph].origin, origin = (1.0 / em) * stand.origin;
    const point right = stand.right, up{0.0 - right.y, right.x};
    const affine& m = box.map;
    const point from = origin + (m.dx - flat.x) * right + (m.dy - flat.y) * up;
    return {.xx = m.xx * right.x + m.yx * up.x,
            .xy = m.xy * right.x + m.yy * up.x,
            .dx = from.x,
            .yx = m.xx * right.y + m.yx * up.y,
            .yy = m.xy * right.y + m.yy * up.y,
            .dy = from.y};
}

/// Calls put(const inline_box_place&) for each box of a run, like each_inline_box(), with the map of box_on_stand().
/// Boxes that are left out have no place.
///
///     stands    of the run's glyphs; empty: the text stands as it was laid out
template <class Put>
void each_box_on_stand(const glyph_run& run, array_view<const glyph_stand> stands, const Put& put) noexcept
{
    each_inline_box(run, [&](inline_box_place box) noexcept {
        if (!stands.empty()) {
            if (stands[box.glyph].left_out) return;
            box.map = box_on_stand(box, run, stands[box.glyph]);
        }
        put(box);
    });
}

}  // namespace typemesh::inline TYPEMESH_ABI
