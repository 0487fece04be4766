// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/impl/outline_step_ref.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/glyph/solid_planner.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The settings for building a glyph, besides the policies.
struct glyph_settings {
    double tolerance = 0.0;                         ///< the largest distance between curve and mesh, in em
    std::optional<fill_rule> fill = {};             ///< replaces the outline source's own rule
    std::uint32_t max_pieces = default_max_pieces;  ///< the greatest number of pieces into which crossings may divide
                                                    ///< the contours; see resolve()
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points for flattened curves, and of
                                                    ///< curves
    touching corners = touching::keep;              ///< how touching corners are treated

    /// The largest number of cells per em in the grid, a power of two, ignored with touching::keep. It depends on the
    /// distance from the origin at which glyphs are written, so that floats distinguish neighbouring cells.
    double max_cells = 0x1p40;

    box text = {};                       ///< drawn_place::text; matters only for outline steps
    const glyph_stand* stand = nullptr;  ///< drawn_place::stand, likewise
};

/// A source to record a glyph from: an outline_source, or any other type with a record().
template <class F>
concept recordable = requires(F& font, glyph_id id, outline& out) {
    { font.units_per_em() } noexcept -> std::convertible_to<double>;
    { record(font, id, out, default_max_points) } noexcept -> std::same_as<result<void>>;
};

/// Builds one glyph from its outline: record, discretise, fill, triangulate, and the extruder's plan. It owns the
/// scratch memory, which is kept for the next glyph. A builder serves one thread at a time.
///
///     glyph_builder builder;
///     auto draft = builder.build(font, id, {.tolerance = quality::high},
///                                policies{certified{}, monotone{}, flat{}, nobody});
class glyph_builder {
public:
    explicit glyph_builder(memory source = heap()) noexcept
        : outline_{source}, warped_{source}, caps_{source}, planner_{source}
    {
    }

    /// The glyph's draft, which is stored in this builder until its next call. A glyph that cannot be built is no
    /// failure here: its draft is empty and carries the reason. `place` matters for extruders that plan in place
    /// (extruder.hpp), for outline steps (outline_step.hpp), and its em_per_depth also where corners are treated: then
    /// the heights of low walls depend on it.
    ///
    /// Fails  with errors that do not concern the glyph alone: error::out_of_memory, bad_option, bad_tolerance,
    ///        too_large
    template <recordable Font>
    [[nodiscard]] result<glyph_draft> build(Font& font, glyph_id id, const glyph_settings& how, const policies& with,
                                            const solid_place& place = {}) noexcept
    {
        glyph_draft made;
        with.observe(stage::outline);
        error e = record(font, id, outline_, how.max_points).error();
        if (!e) e = try_to_build(font.units_per_em(), how, with, place, made);
        if (e && !concerns_the_glyph_alone(e)) return e;
        if (e) made = {};
        made.refusal = e;
        return made;
    }

    /// The region that the glyph fills, in this builder until its next call; empty for a blank glyph. An outline step
    /// warps it at its origin.
    ///
    /// Fails  with any error of the glyph
    template <recordable Font>
    [[nodiscard]] result<region> build_region(Font& font, glyph_id id, const glyph_settings& how,
                                              const cap_policies& with, outline_step_ref warp = {},
                                              point origin = {}) noexcept
    {
        parting_ = {};
        with.observe(stage::outline);
        if (const auto done = record(font, id, outline_, how.max_points); !done) return done.error();
        return fill_outline(font.units_per_em(), how, with, warp, origin);
    }

    /// The triangles of the region that build_region() has made.
    [[nodiscard]] array_view<const triangle> triangles() const noexcept { return caps_.triangles().view(); }

    /// The draft of a region, which may be a level of detail (glyph_levels.hpp): see build(). A region without points
    /// gives a blank glyph.
    ///
    /// Fails  with errors that do not concern the glyph alone
    [[nodiscard]] result<glyph_draft> raise(const capped_region& from, const policies& with,
                                            const solid_place& place = {}) noexcept
    {
        glyph_draft made;
        if (from.filled.points().empty()) return made;
        with.observe(stage::extrude);
        const auto planned = planner_.plan(from, caps_, with, place);
        if (planned) return planned->draft;
        if (!concerns_the_glyph_alone(planned.error())) return planned.error();
        made.refusal = planned.error();
        return made;
    }

    /// The changes of the last build_region() to touching corners.
    [[nodiscard]] const corner_parting& parting() const noexcept { return parting_; }

    /// Returns all memory to its source, and the last results with it. The next glyph allocates again.
    void trim() noexcept
    {
        caps_.trim();
        planner_.trim();
        outline_ = outline{caps_.source()};
        warped_ = outline{caps_.source()};
    }

    /// Whether a text may continue without the glyph that has this error.
    [[nodiscard]] static constexpr bool concerns_the_glyph_alone(const error& e) noexcept
    {
        for (const error::kind k :
             {error::unknown_glyph, error::bad_outline, error::outline_not_finite, error::outline_beyond_grid,
              error::too_many_pieces, error::too_many_points, error::crossing_contours, error::nothing_left,
              error::edges_not_moved, error::font_library_failed, error::refused_by_user})
            if (e == k) return true;
        return false;
    }

private:
    /// The region of the outline that was recorded.
    result<region> fill_outline(double units_per_em, const glyph_settings& how, const cap_policies& with,
                                outline_step_ref warp, point origin) noexcept
    {
        parting_ = {};
        if (outline_.curves.empty()) return region{};
        if (warp.is_none()) return fill_curves(outline_, how.tolerance, units_per_em, how, with);
        if (!is_finite(units_per_em) || !(units_per_em > 0.0)) return error::bad("units_per_em");
        const auto rest =
            warp(outline_, {origin, 1.0 / units_per_em, how.text, how.stand}, how.tolerance, how.max_points, warped_);
        if (!rest) return rest.error();
        return fill_curves(warped_, *rest, units_per_em, how, with);
    }

    result<region> fill_curves(outline& drawn, double tolerance, double units_per_em, const glyph_settings& how,
                               const cap_policies& with) noexcept
    {
        const auto fitting = grid::fitting(units_per_em, drawn.bounds);
        if (!fitting) return fitting.error();
        grid cells = *fitting;
        if (how.corners != touching::keep) cells.coarsen(how.max_cells);
        const cap_settings filled{how.fill.value_or(drawn.rule), how.max_pieces, how.max_points, how.corners};
        const auto made = caps_.build(drawn, tolerance * units_per_em, cells, filled, with);
        return made ? caps_.part(*made, drawn.curves, filled, with, parting_) : made;
    }

    error try_to_build(double units_per_em, const glyph_settings& how, const policies& with, const solid_place& place,
                       glyph_draft& made) noexcept
    {
        const auto filled = fill_outline(units_per_em, how, with, with.warp, place.origin);
        if (!filled) return filled.error();
        if (filled->points().empty()) return {};

        with.observe(stage::extrude);
        const auto planned = planner_.plan({*filled, caps_.triangles().view(), parting_}, caps_, with, place);
        if (!planned) return planned.error();
        made = planned->draft;
        return {};
    }

    outline outline_;
    outline warped_;
    cap_builder caps_;
    solid_planner planner_;
    corner_parting parting_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
