// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/discretise/impl/discretiser_ref.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/fill/impl/touching_cycles.hpp>
#include <typemesh/fill/nest.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/glyph/cap_policies.hpp>
#include <typemesh/glyph/impl/crossing_refinement.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The fill rule of a cap_builder, and its limits.
struct cap_settings {
    fill_rule rule = fill_rule::non_zero;
    std::uint32_t max_pieces = default_max_pieces;  ///< the greatest number of pieces into which crossings may divide
                                                    ///< the contours; see resolve()
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points for flattened curves
    touching corners = touching::keep;              ///< the treatment of touching corners in part()
};

/// Makes caps: the region that curves or contours fill, with its triangles. It owns the contours, the order of their
/// points, the triangles, and the scratch memory for making them, which is kept for the next cap.
///
///     curves -- flatten --> loops() -- prove --------------------------> region + triangles()
///                  ^                     + refuses -> resolve -> cap ------>
///                  +-- these curves finer --- refine ----+  chords cross where curves do not
///
///     cap_builder caps;
///     auto filled = caps.build(curves, tolerance, cells, {fill_rule::even_odd},
///                              {certified{}, monotone{}, nobody});     // all of it
///     caps.loops() = ...;                                                                          // or from here on
///     auto filled = caps.fill({fill_rule::even_odd}, monotone{});
///
/// Simple outlines take one sweep, and most outlines are simple. Outlines that only touch in points take at most two
/// sweeps. The points of an outline that crosses itself are sorted once for all sweeps (of a round, see refine()). A
/// region is valid until the next build(), fill(), flatten(), prove() or trim(), or until loops() change; cap() does
/// not change it. A builder serves one thread at a time.
class cap_builder {
public:
    explicit cap_builder(memory source = heap()) noexcept : space_{source}, loops_{source}, triangles_{source} {}

    /// The region that curves fill, with its triangles; a region without points if nothing is filled.
    ///
    ///     curves      the region refers to them
    ///     tolerance   in font units
    ///     cells       the grid, see grid::fitting
    ///
    /// Fails  as discretise(), resolve() and the triangulator do
    /// Cost   the sum of their costs; refine()'s cost where chords cross
    [[nodiscard]] result<region> build(const outline& curves, double tolerance, const grid& cells,
                                       const cap_settings& how, const cap_policies& with) noexcept
    {
        effort_ = {};
        triangles_.clear();
        loops_.max_points = how.max_points;
        loops_.corners = how.corners;
        with.observe(stage::discretise);
        if (const auto done = flatten(curves, with.flatten, tolerance, cells); !done) return done.error();
        if (loops_.points.empty()) return region{};
        if (!with.flatten.keeps_tolerance()) return fill(how, with.cut, with.observe);
        const auto proven = prove(how.rule, with.cut, with.observe);
        if (proven || proven.error().code != error::crossing_contours) return proven;
        return refine(curves, tolerance, cells, how, with);
    }

    /// The region that build() made, after its touching corners are separated or joined as loops() says: see
    /// corner_parting.
    ///
    ///     curves    the curves given to build(); more may be appended
    ///
    /// Fails  as corner_parting and the triangulator do
    [[nodiscard]] result<region> part(const region& built, buffer<curve>& curves, const cap_settings& how,
                                      const cap_policies& with, corner_parting& parting) noexcept
    {
        parting = {};
        if (!built.is_touching() || loops_.corners == touching::keep) return built;
        with.observe(stage::fill);
        const auto made = parting(loops_, curves, space_, how.max_pieces);
        triangles_.clear();
        if (!made || made->points().empty()) return made;
        with.observe(stage::triangulate);
        if (const auto done = cap(*made, with.cut); !done) return done.error();
        return made;
    }

    /// The region that loops() fill, with its triangles.
    ///
    /// Fails  as resolve() and the triangulator do
    [[nodiscard]] result<region> fill(const cap_settings& how, triangulator_ref cut, observer_ref observe) noexcept
    {
        triangles_.clear();
        const auto proven = prove(how.rule, cut, observe);
        if (proven || proven.error().code != error::crossing_contours) return proven;
        return resolve(how, cut, {}, observe);
    }
    [[nodiscard]] result<region> fill(const cap_settings& how, triangulator_ref cut) noexcept
    {
        no_observer nobody;
        return fill(how, cut, nobody);
    }

    /// Flattens the outline's curves into loops(), to at most loops().max_points points: see discretise().
    [[nodiscard]] result<void> flatten(const outline& curves, discretiser_ref how, double tolerance, const grid& cells,
                                       array_view<const std::uint8_t> halvings = {}) noexcept
    {
        return how.flatten(curves, tolerance, cells, loops_, halvings);
    }

    /// Proves that loops() bound a region: unchanged, or relinked at points in which they only touch.
    ///
    ///     loops -- orient --> prove --------------------------------------> region + triangles
    ///                          + refuses equal points -> link -> prove ------>
    ///
    /// Fails with error::crossing_contours (the rest is for resolve()) and error::out_of_memory. loops() are then at
    /// most reversed, and there are no triangles.
    template <proving_triangulator Triangulator>
    [[nodiscard]] result<region> prove(const Triangulator& cut) noexcept
    {
        return prove_by(cut);
    }

    /// Triangulates any region; the result is triangles().
    [[nodiscard]] result<void> cap(const region& r, triangulator_ref how) noexcept
    {
        triangles_.clear();
        return cap(r, how, triangles_);
    }
    /// Appends the triangles of any region to `out`; triangles() do not change. See cut_region().
    [[nodiscard]] result<void> cap(const region& r, triangulator_ref how, triangle_list& out) noexcept
    {
        return how.cut(r, space_, out);
    }

    /// The contours: your own, or the last outline's.
    [[nodiscard]] contours& loops() noexcept { return loops_; }
    [[nodiscard]] const contours& loops() const noexcept { return loops_; }

    /// The triangles of the last cap; none after an error.
    [[nodiscard]] const triangle_list& triangles() const noexcept { return triangles_; }

    /// The effort of refine() for the last outline.
    [[nodiscard]] const refinement_effort& effort() const noexcept { return effort_; }

    /// The scratch memory, for scopes of your own.
    [[nodiscard]] workspace& space() noexcept { return space_; }

    /// The source of its memory.
    [[nodiscard]] memory source() const noexcept { return space_.source(); }

    /// Returns all memory to its source, and the last results with it.
    void trim() noexcept
    {
        space_.trim();
        loops_ = contours{source()};
        triangles_ = triangle_list{source()};
    }

private:
    [[nodiscard]] result<region> prove_by(triangulator_ref cut) noexcept;

    /// prove(), or nest() and cap() for triangulators that do not prove.
    [[nodiscard]] result<region> prove(fill_rule rule, triangulator_ref cut, observer_ref observe) noexcept
    {
        if (cut.proves()) {
            observe(stage::triangulate);
            return prove_by(cut);
        }
        observe(stage::fill);
        loops_.forget_order();
        const auto nested = nest(loops_, rule, space_);
        if (!nested) return nested;
        observe(stage::triangulate);
        if (const auto done = cap(*nested, cut); !done) return done.error();
        return nested;
    }

    /// The region that loops() fill, however they cross, with its triangles; a region without points if the filter
    /// rejects one.
    [[nodiscard]] result<region> resolve(const cap_settings& how, triangulator_ref cut, intersection_filter_ref filter,
                                         observer_ref observe) noexcept
    {
        observe(stage::fill);
        resolved_ = {};
        const auto made = typemesh::resolve(loops_, how.rule, space_, filter, {how.max_pieces, &resolved_});
        if (!made || made->points().empty()) return made;
        observe(stage::triangulate);
        if (const auto done = cap(*made, cut); !done) return done.error();
        return made;
    }

    /// Curves are flattened more finely if their chords cross or touch, but the curves themselves do not, or do so only
    /// more than 4 tolerances away. Then everything is repeated; often the outline is now simple.
    ///
    /// Cost   each round costs as much as the first; there are hardly ever two rounds, and never more than 12. The last
    ///        round begins when crossings have divided the contours into more than `max_pieces` pieces, or into more
    ///        than 2,048 plus four times the first round's pieces. Doubtful intersections are then accepted.
    [[nodiscard]] result<region> refine(const outline& curves, double tolerance, const grid& cells,
                                        const cap_settings& how, const cap_policies& with) noexcept
    {
        constexpr std::uint32_t max_rounds = 12, few_pieces = 2048, times_as_many = 4;
        workspace::scope scratch{space_};
        crossing_refinement refinement;
        if (!refinement.open(scratch, curves, tolerance, cells)) return error::out_of_memory;
        std::uint64_t first = 0;  // pieces of the first round
        for (;;) {
            const std::uint64_t spent = effort_.pieces;
            const bool last =
                effort_.rounds == max_rounds || spent > times_as_many * first + few_pieces || spent > how.max_pieces;
            const auto filter = last ? intersection_filter_ref{} : intersection_filter_ref{refinement};
            const auto made = resolve(how, with.cut, filter, with.observe);
            if (spent == 0) first = resolved_.pieces;
            const bool content = refinement.is_content();
            effort_ = refinement.effort();
            effort_.pieces = spent + resolved_.pieces;
            if (!made || content) return made;
            with.observe(stage::discretise);
            if (const auto done = flatten(curves, with.flatten, tolerance, cells, refinement.halvings()); !done)
                return done.error();
            const auto proven = prove(how.rule, with.cut, with.observe);
            if (proven || proven.error().code != error::crossing_contours) return proven;
        }
    }

    workspace space_;
    contours loops_;
    triangle_list triangles_;
    resolve_effort resolved_;  // the effort of the last round
    refinement_effort effort_;
};

inline result<region> cap_builder::prove_by(triangulator_ref cut) noexcept
{
    triangles_.clear();
    loops_.forget_order();  // the order may be of points that the caller has moved
    orient(loops_);
    if (!sort_points(loops_, space_)) return error::out_of_memory;
    auto proven = cut.prove(loops_, space_, triangles_);
    if (!proven && cut.proves_touching() && proven.error().code == error::crossing_contours &&
        proven.error().count != 0) {
        workspace::scope linking{space_};
        touching_cycles cycles;
        if (error e = cycles.link(loops_, linking, space_)) return e;
        proven = cut.prove_touching(loops_, space_, triangles_);
        if (!proven) cycles.undo(loops_);
    }
    if (proven)
        if (error e = detail::settle_triangles(*proven, triangles_, 0, space_, cut.has_final_diagonals())) return e;
    return proven;
}

}  // namespace typemesh::inline TYPEMESH_ABI
