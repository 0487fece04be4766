// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/most_pieces.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/fill/nest.hpp>
#include <typemesh/glyph/cap.hpp>
#include <typemesh/glyph/crossing_refinement.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// How far cap_outline() may go, and where to tell what its guard did.
struct cap_limits {
    std::uint32_t most_pieces = default_most_pieces;  ///< see resolve()
    refinement_effort* effort = nullptr;                   ///< null: nobody wants to know
};

/// A glyph's curves to the region that they fill, and its triangles: discretise and cap joined, under guard.
///
///     shape ─ discretise ─▶ loops ─ prove ─────────────────────────────────▶ region + triangles
///                  ▲                  └ refuses ─▶ resolve ─▶ triangulate ──▶
///                  │                                 │
///                  └── these curves finer ─── guard ─┘  chords meet where curves do not
///
/// Where the chords of two curves cross or touch and the curves do not, or do so more than 4 tolerances away, these
/// curves are discretised finer (see crossing_refinement.hpp), and all is done again: often the outline is simple then.
/// A discretiser that keeps no tolerance is not asked again.
///
///     tolerance   in font units
///     cells       the grid, see grid::fitting
///     loops       the result refers to it, and it to `shape`
///     out         triangles are appended; as it was after an error
///
/// A region without points where nothing is filled. Fails with what discretise() and cap() fail with.
/// Cost   outlines that do not meet: that of discretise() and cap(). Each round of the guard costs as much again; there
///        are hardly ever two, and never more than 12; the last one begins when the contours have fallen into more
///        pieces than `most_pieces`, or than four times those of the first round and 2,048. What is doubtful then stands.
template <discretiser Discretiser, triangulator Triangulator, stage_observer Observer>
[[nodiscard]] result<region> cap_outline(const outline& shape, fill_rule rule, const Discretiser& how, double tolerance,
                                         const grid& cells, const Triangulator& cut, workspace& space, contours& loops,
                                         triangle_list& out, Observer& observe,
                                         const cap_limits& limits = {}) noexcept
{
    constexpr std::uint32_t most_rounds = 12, few_pieces = 2048, times_as_many = 4;
    if (limits.effort != nullptr) *limits.effort = {};
    observe(stage::discretise);
    if (error e = discretise(shape, how, tolerance, cells, loops)) return e;
    if (loops.points.empty()) return region{};
    if constexpr (!keeps_tolerance<Discretiser>) {
        return cap(loops, {rule, {.most_pieces = limits.most_pieces}}, cut, space, out, observe);
    } else {
        workspace::scope scratch{space};
        const auto prove = [&]() noexcept -> result<region> {
            if constexpr (proving_triangulator<Triangulator>) {
                observe(stage::triangulate);
                return prove_loops(loops, cut, space, out);
            } else {
                observe(stage::fill);
                auto nested = nest(loops, rule, space);
                if (!nested) return nested;
                observe(stage::triangulate);
                if (error e = detail::cut_region(*nested, cut, space, out)) return e;
                return nested;
            }
        };
        auto made = prove();
        if (made || made.error().code != error::crossing_contours) return made;

        std::uint64_t first = 0, spent = 0;  // pieces: of the first round, of all
        crossing_refinement guard;
        if (!guard.open(scratch, shape, tolerance, cells)) return error::out_of_memory;
        for (;;) {
            every_intersection_stands nobody;
            const bool last = guard.effort().rounds == most_rounds || spent > times_as_many * first + few_pieces ||
                              spent > limits.most_pieces;
            resolve_effort work;
            const resolve_options resolving{limits.most_pieces, &work};
            made = last ? detail::resolve_and_cut(loops, resolving, rule, cut, space, out, nobody, observe)
                        : detail::resolve_and_cut(loops, resolving, rule, cut, space, out, guard, observe);
            if (spent == 0) first = work.pieces;
            spent += work.pieces;
            const bool content = guard.is_content();
            if (limits.effort != nullptr) {
                *limits.effort = guard.effort();
                limits.effort->pieces = spent;
            }
            if (!made || content) return made;
            observe(stage::discretise);
            if (error e = discretise(shape, how, tolerance, cells, loops, guard.halvings())) return e;
            made = prove();
            if (made || made.error().code != error::crossing_contours) return made;
        }
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
