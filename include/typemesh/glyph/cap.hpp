// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/fill/touching_cycles.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/sweep/sweep_order.hpp>
#include <typemesh/triangulate/appended_triangles.hpp>
#include <typemesh/triangulate/low_triangles.hpp>
#include <typemesh/triangulate/triangulator.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The triangles that a triangulator has appended for a region behind the first `before`: held to its promise, and
/// those too low for 32-bit floats exchanged, unless its diagonals are final. The rule looks at the shape alone,
/// wherever it will stand. `out` is as it was after an error.
template <triangulator Triangulator>
[[nodiscard]] error settle_triangles(const region& shape, triangle_list& out, std::size_t before,
                                     workspace& space) noexcept
{
    const bool is_kept = assert_triangles(shape, out, before);
    if constexpr (!has_final_diagonals<Triangulator>) {
        if (is_kept) {
            if (error e = raise_low_triangles(shape, out.view().subspan(before), space)) {
                out.truncate(before);
                return e;
            }
        }
    }
    return {};
}

/// how(shape, space, out), settled.
template <triangulator Triangulator>
[[nodiscard]] error cut_region(const region& shape, const Triangulator& how, workspace& space,
                               triangle_list& out) noexcept
{
    const std::size_t before = out.size();
    if (error e = how(shape, space, out)) return e;
    return settle_triangles<Triangulator>(shape, out, before, space);
}

/// Resolves loops and cuts what they fill into triangles, if the filter lets all intersections stand.
template <triangulator Triangulator, intersection_filter Filter, stage_observer Observer>
[[nodiscard]] result<region> resolve_and_cut(contours& loops, const resolve_options& limits, fill_rule rule,
                                             const Triangulator& how, workspace& space, triangle_list& out,
                                             Filter& filter, Observer& observe) noexcept
{
    observe(stage::fill);
    const auto made = resolve(loops, rule, space, filter, limits);
    if (!made || made->points().empty()) return made;
    observe(stage::triangulate);
    if (error e = cut_region(*made, how, space, out)) return e;
    return made;
}

}  // namespace detail

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
    const std::size_t before = out.size();
    orient(loops);
    if (!sort_points(loops, space)) return error::out_of_memory;
    auto proven = how.prove(loops, space, out);
    if constexpr (touching_triangulator<Triangulator>) {
        if (!proven && proven.error().code == error::crossing_contours && proven.error().count != 0) {
            workspace::scope linking{space};
            touching_cycles cycles;
            if (error e = cycles.link(loops, linking, space)) return e;
            proven = how.prove_touching(loops, space, out);
            if (!proven) cycles.undo(loops);
        }
    }
    if (proven)
        if (error e = detail::settle_triangles<Triangulator>(*proven, out, before, space)) return e;
    return proven;
}

/// What cap() fills, and how far it may go for it. A fill_rule alone will do:
///
///     cap(loops, fill_rule::non_zero, how, space, out)
///     cap(loops, {fill_rule::non_zero, {.most_pieces = 5000}}, how, space, out)
struct cap_filling {
    fill_rule rule;
    resolve_options resolving;

    constexpr cap_filling(fill_rule by, const resolve_options& how = {}) noexcept : rule{by}, resolving{how} {}
};

/// Contours to a proven region and its triangles: fill and triangulate joined.
///
///     proving triangulator    loops ── prove_loops ───────────────────────────▶ region + triangles
///                                                  └ refuses ─▶ resolve ─▶ triangulate ──▶
///     any other               loops ─────────────────────────▶ fill ─▶ triangulate ──▶
///
/// So outlines that are already simple, which is nearly all, pay for one sweep only, and those that only touch in
/// points for two at most and a sort. The points of an outline that crosses are sorted once for all three sweeps when
/// the triangulator can be told of their order. `loops` is turned and compacted in place; the region refers to it.
/// Triangles are appended to `out`, which is as it was after an error.
///
/// Fails  with what fill() and the triangulator fail with, error::too_many_pieces among them
template <triangulator Triangulator, stage_observer Observer>
[[nodiscard]] result<region> cap(contours& loops, const cap_filling& filling, const Triangulator& how,
                                 workspace& space, triangle_list& out, Observer& observe) noexcept
{
    if constexpr (proving_triangulator<Triangulator>) {
        observe(stage::triangulate);
        auto proven = prove_loops(loops, how, space, out);
        if (proven || proven.error().code != error::crossing_contours) return proven;
        every_intersection_stands nobody;
        return detail::resolve_and_cut(loops, filling.resolving, filling.rule, how, space, out, nobody, observe);
    } else {
        observe(stage::fill);
        auto filled = fill(loops, filling.rule, space, filling.resolving);
        if (!filled) return filled;
        observe(stage::triangulate);
        if (error e = detail::cut_region(*filled, how, space, out)) return e;
        return filled;
    }
}

template <triangulator Triangulator>
[[nodiscard]] result<region> cap(contours& loops, const cap_filling& filling, const Triangulator& how,
                                 workspace& space, triangle_list& out) noexcept
{
    no_observer nobody;
    return cap(loops, filling, how, space, out, nobody);
}

}  // namespace typemesh::inline TYPEMESH_ABI
