// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/fill/touching_walks.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/triangulate/triangulator.hpp>

namespace typemesh {

/// Proves that loops bound a region as they are, or where they only touch in points and are walked anew there.
///
///     loops ── orient ──▶ prove ──────────────────────────────────────────▶ region + triangles
///                          └ refuses equal points ─▶ walk anew ─▶ prove ──▶
///
/// Fails with error::crossing_contours (all else is for resolve()) and error::out_of_memory; then `out` is as it was,
/// and `loops` turned at most.
template <proving_triangulator Triangulator>
[[nodiscard]] result<region> prove_loops(contours& loops, const Triangulator& how, workspace& space,
                                         triangle_list& out) noexcept
{
    orient(loops);
    auto proven = how.prove(loops, space, out);
    if constexpr (touching_triangulator<Triangulator>) {
        if (!proven && proven.error().code == error::crossing_contours && proven.error().count != 0) {
            workspace::scope scratch{space};
            touching_walks walks;
            if (error e = walks.link(loops, scratch, space)) return e;
            proven = how.prove_touching(loops, space, out);
            if (!proven) walks.undo(loops);
        }
    }
    return proven;
}

/// Contours to a proven region and its triangles: fill and triangulate joined.
///
///     proving triangulator    loops ── prove_loops ───────────────────────────▶ region + triangles
///                                                  └ refuses ─▶ resolve ─▶ triangulate ──▶
///     any other               loops ─────────────────────────▶ fill ─▶ triangulate ──▶
///
/// So outlines that are already simple, which is nearly all, pay for one sweep only, and those that only touch in points
/// for two at most and a sort. `loops` is turned and compacted in place; the region refers to it. Triangles are appended
/// to `out`, which is as it was after an error.
template <triangulator Triangulator, stage_observer Observer>
[[nodiscard]] result<region> cap(contours& loops, fill_rule rule, const Triangulator& how, workspace& space,
                                 triangle_list& out, Observer& observe) noexcept
{
    if constexpr (proving_triangulator<Triangulator>) {
        observe(stage::triangulate);
        auto proven = prove_loops(loops, how, space, out);
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
