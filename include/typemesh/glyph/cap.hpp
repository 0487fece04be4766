// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/triangulate/triangulator.hpp>

namespace typemesh {

/// Contours to a proven region and its triangles: fill and triangulate joined.
///
///     proving triangulator    loops ── orient ──▶ prove ──────────────────────▶ region + triangles
///                                                  └ refuses ─▶ resolve ─▶ triangulate ──▶
///     any other               loops ─────────────────────────▶ fill ─▶ triangulate ──▶
///
/// So outlines that are already simple, which is nearly all, pay for one sweep only. `loops` is turned and compacted in
/// place; the region refers to it. Triangles are appended to `out`, which is as it was after an error.
template <triangulator Triangulator, stage_observer Observer>
[[nodiscard]] result<region> cap(contours& loops, fill_rule rule, const Triangulator& how, workspace& space,
                                 triangle_list& out, Observer& observe) noexcept
{
    if constexpr (proving_triangulator<Triangulator>) {
        observe(stage::triangulate);
        orient(loops);
        auto proven = how.prove(loops, space, out);
        if (proven || proven.error().code != error::crossing_contours) return proven;
    }
    observe(stage::fill);
    auto filled = proving_triangulator<Triangulator> ? resolve(loops, rule, space) : fill(loops, rule, space);
    if (!filled) return filled;
    observe(stage::triangulate);
    if (error e = how(*filled, space, out)) return e;
    return filled;
}

template <triangulator Triangulator>
[[nodiscard]] result<region> cap(contours& loops, fill_rule rule, const Triangulator& how, workspace& space,
                                 triangle_list& out) noexcept
{
    no_observer nobody;
    return cap(loops, rule, how, space, out, nobody);
}

}  // namespace typemesh
