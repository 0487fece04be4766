// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/bend_error.hpp>
#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/unfolded.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/extrude/bendable.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bent_caps.hpp>
#include <typemesh/extrude/impl/bent_data.hpp>
#include <typemesh/extrude/impl/bent_measure.hpp>
#include <typemesh/extrude/impl/bent_surface.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/impl/wall_segments.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that bends the solid of another extruder: around a cup, along a wave, twisted, or by a deformation of
/// your own (bend/deformation.hpp). Letters are bent where they stand in the text.
///
///     bent<on_cylinder>{.how = {.radius = 1.5}}
///     bent<displaced<wave>, extruded<>>{.solid = {.depth = 0.1f}, .how = {{.height = 0.2}}}
///     bent<twist, bevelled>{.solid = {.width = 0.02f}}      slopes are divided as well, along and across
///
/// Caps, walls and bevels get as many points as they need, so that no point of the mesh is farther than `tolerance`
/// from its place on the bent solid. The promise rests on bounds of the deformation's second derivatives
/// (bend_error.hpp), not on samples. Three further differences from the ideal shape come in addition: the text's own
/// tolerance for curves, times the greatest stretch; the rounding of points to the grid, likewise; and the rounding of
/// positions to floats.
/// Normals and tangents are exact: they are the flat solid's, mapped by the deformation's derivatives. Texture
/// coordinates are the flat text's.
///
/// The deformation works in em, relative to the text's own origin: x along the text, y up, z towards the reader. The
/// bent text is then scaled and placed like any other (text_options).
///
/// No triangle turns: its image does not face away from the bent surface at any of its corners. Triangles that would
/// are divided, too. Triangles lower than four cells, or than 2^-20 of the text's farthest coordinate, do not count:
/// their side is a rounding, on the grid or to floats.
///
/// Every occurrence of a glyph is planned at its own place, without a cache. write_meshes() writes each letter where it
/// stands, and write_instances() then moves nothing.
///
/// Fails  error::bad_option: tolerance is not positive and finite, or so small that points would come within a few
///        cells of each other ("tolerance"); or as the deformation and the other extruder do
///        error::folds_over: the deformation turns letters inside out, or the image of a triangle turns at every
///        division; the text is refused; error::goes_around: see the deformation
///        error::too_many_points: a glyph needs more than max_points; error::out_of_memory
/// Cost   O(1) for each point
template <deformation Deformation, bendable Solid = extruded<>>
struct bent {
    Solid solid = {};
    Deformation how = {};
    double tolerance = 1.0 / 800;                   ///< the largest distance from the bent solid, in em
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one glyph's cap

    static constexpr std::size_t part_count = part_count_of<Solid>;
    using plan_data = bent_data<Solid>;
    using planned = solid_with<plan_data>;

    /// See option_bits. Solids that are planned in place are not cached; this key names the policy.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    /// See extruder.hpp.
    [[nodiscard]] bool plans_in_place() const noexcept { return true; }
    /// See extruder.hpp.
    [[nodiscard]] error refused_text(const box& text) const noexcept
    {
        return typemesh::refused_text(how, {{text.low.x, text.low.y, 0.0}, {text.high.x, text.high.y, 0.0}});
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = how.refused_options()) return e;
        if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad("tolerance");
        if (filled.points().empty()) return data.flat.plan(solid, filled, caps);
        const solid_place place = solid_place_of(caps);
        if (!is_finite(place.origin.x) || !is_finite(place.origin.y)) return error::outline_not_finite;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        detail::bent_measure<Deformation> measure = measure_of(filled, place);
        box of_region;
        for (const grid_point p : filled.points()) of_region.add(placement::exact(p));
        const box3 around = box_of(of_region, measure);
        if (error e = typemesh::refused_text(how, around)) return e;
        if (!is_unfolded(how, around)) return error::folds_over;
        measure.compared = measure.extents_in(around);
        detail::bent_surface<Deformation> surface{how, data.places};
        bent_form form;
        form.segments = segments_for(filled, measure, around);
        measure.step /= form.segments;
        const Solid own = in_segments(form.segments);
        for (;; measure.margin *= 4.0) {
            data.flat.clear();
            auto made = plan_flat(own, filled, measure, data, caps);
            if (!made) return made;
            const box3 whole = box_of(made->around, measure);
            if (error e = typemesh::refused_text(how, whole)) return e;
            if (!is_unfolded(how, whole)) return error::folds_over;
            if (error e = surface.read(own, data.flat.read(), *made, flat_placement(measure, place))) return e;
            const bool is_near = surface.greatest_error() <= tolerance;
            if (is_near && !surface.turns()) {
                take_bounds(surface.bounds(), measure, *made, form);
                return data.form.template of<bent_form>().push_back(form) ? made : error{error::out_of_memory};
            }
            // Thin triangles on edges that stay get better with shorter edges.
            if (!(measure.margin > 1.0) || measure.margin > 16.0)
                return is_near ? error{error::folds_over} : error::bad("tolerance");
        }
    }

    /// The heights before the solid is bent.
    [[nodiscard]] height_range heights() const noexcept { return solid.heights(); }
    /// The heights of a bent solid.
    [[nodiscard]] height_range heights(const planned& s) const noexcept
    {
        const auto form = s.data.form.template of<bent_form>();
        return form.empty() ? solid.heights() : height_range{form[0].low, form[0].high};
    }
    /// The name of the other extruder's option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return heights_name_of(solid); }

    /// The triangles before the solid is bent.
    template <class Put>
    void seen_from_front(const planned& s, Put&& put) const noexcept
    {
        each_seen_from_front(solid, s.data.flat, put);
    }

    /// The number of hard edges that the other extruder counts.
    [[nodiscard]] std::uint64_t hard_edges(const planned& s) const noexcept
        requires has_hard_edges<Solid>
    {
        return solid.hard_edges(s.data.flat);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const planned& s, const placement& at, Put&& put) const noexcept
    {
        const auto form = s.data.form.template of<bent_form>();
        if (form.empty()) return;
        const detail::bent_axes<Deformation> axes{how, at};
        constexpr attribute needs = Wants | attribute::position;
        const auto bend = [&](const surface_point<needs>& v) noexcept { put(axes.template bend<Wants>(v)); };
        in_segments(form[0].segments).template vertices<needs>(p, s.data.flat, axes.flat(), bend);
    }

    template <class Put>
    void triangles(part p, const planned& s, const first_vertices& first, Put&& put) const noexcept
    {
        const auto form = s.data.form.template of<bent_form>();
        if (!form.empty()) in_segments(form[0].segments).triangles(p, s.data.flat, first, put);
    }

private:
    [[nodiscard]] Solid in_segments(std::uint32_t segments) const noexcept
    {
        Solid own = solid;
        set_segments(own, segments);
        return own;
    }

    /// Keeps the bounds of a bent solid.
    static void take_bounds(const box3& bounds, const detail::bent_measure<Deformation>& measure, solid_plan& made,
                            bent_form& form) noexcept
    {
        constexpr double margin = 0x1p-10;  // cells; more than the rounding of the sums below
        const double em = 1.0 / measure.em_per_cell, off = margin * measure.em_per_cell;
        const point low = em * (point{bounds.low.x, bounds.low.y} - measure.origin),
                    high = em * (point{bounds.high.x, bounds.high.y} - measure.origin);
        made.textured = made.around;
        made.around = {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
        form.low = (bounds.low.z - off) / measure.em_per_depth;
        form.high = (bounds.high.z + off) / measure.em_per_depth;
    }

    /// The measure for walls that are not divided yet.
    [[nodiscard]] detail::bent_measure<Deformation> measure_of(const region& filled,
                                                               const solid_place& place) const noexcept
    {
        const double em = filled.grid().cells * filled.grid().units_per_em, per_depth = place.em_per_depth;
        const height_range heights = solid.heights();
        detail::bent_measure<Deformation> measure{.bends = how,
                                                  .origin = place.origin,
                                                  .em_per_cell = 1.0 / em,
                                                  .low = heights.low * per_depth,
                                                  .high = heights.high * per_depth,
                                                  .tolerance = (1.0 - 0x1p-10) * tolerance,
                                                  .em_per_depth = per_depth};
        measure.step = measure.high - measure.low;
        if constexpr (bendable_caps<Solid>) {
            const upright_faces upright = solid.uprights(filled);
            measure.step = upright.walls * per_depth;
            measure.riser = upright.risers * per_depth;
            measure.apart = upright.apart;
            measure.margin = 2.0;
        }
        return measure;
    }

    [[nodiscard]] static box3 box_of(const box& around, const detail::bent_measure<Deformation>& measure) noexcept
    {
        const point low = measure.em_per_cell * around.low + measure.origin,
                    high = measure.em_per_cell * around.high + measure.origin;
        return {{low.x, low.y, measure.low}, {high.x, high.y, measure.high}};
    }

    /// The plan of the flat solid, with the points that it needs to be bent.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_flat(const Solid& own, const region& filled,
                                               const detail::bent_measure<Deformation>& measure, plan_data& data,
                                               Caps& caps) const noexcept
    {
        std::uint32_t kept = 0;
        if constexpr (bendable_caps<Solid>) {
            // Only the boundary is divided now. Slopes and caps inherit its points, and get points of their own later.
            const detail::boundary_measure boundary{measure};
            if (error e = data.working.run(filled, caps.triangles(), boundary, max_points)) return e;
            if (error e = data.working.write(data.flat.out(kept))) return e;
            data.flat.inner.clear();
            data.flat.triangles.clear();
            if (error e = caps(data.flat.boundary_of(filled), data.flat.triangles)) return e;
            detail::bending_caps<Caps, Solid, Deformation> dividing{caps, data, measure, max_points};
            auto made = data.flat.plan_by(own, data.flat.boundary_of(filled), dividing);
            if (!made) return made;
            detail::bent_caps<Solid, Deformation> refine{data, measure, max_points};
            if (error e = own.refine_caps(refine, data.flat.data, *made)) return e;
            return made;
        } else {
            if (error e = data.working.run(filled, caps.triangles(), measure, max_points)) return e;
            if (error e = data.working.write(data.flat.out(kept))) return e;
            return data.flat.plan_refined(own, filled, caps);
        }
    }

    /// The number of segments that needs the fewest vertices, if the deformation bends as strongly everywhere as it
    /// does somewhere in the letter. More segments make longer edges possible, because the error of a wall grows with
    /// the product of both.
    [[nodiscard]] std::uint32_t segments_for([[maybe_unused]] const region& filled,
                                             [[maybe_unused]] const detail::bent_measure<Deformation>& measure,
                                             [[maybe_unused]] const box3& around) const noexcept
    {
        const std::uint32_t fewest = segments_of(solid);
        if constexpr (has_segments<Solid>) {
            const double height = measure.step;
            if (!(height > 0.0)) return fewest;
            const bend_bounds by = how.bend(around);
            std::uint32_t best = fewest;
            double least = -1.0;
            for (std::uint32_t n = fewest; n <= wall_rows::most; n += 1 + n / 8) {
                const double points = points_for(filled, measure, by, height / n);
                const double cost = points * (n + 3.0);  // the rows of the walls, and two caps
                if (least >= 0.0 && points > 0.0 && cost >= least) break;
                if (!(points > 0.0)) continue;
                best = n;
                least = cost;
            }
            return best;
        } else {
            return fewest;
        }
    }

    /// About how many points the boundary needs if its walls have segments of this height; 0 if no number suffices.
    [[nodiscard]] static double points_for(const region& filled, const detail::bent_measure<Deformation>& measure,
                                           const bend_bounds& by, double step) noexcept
    {
        // A piece of 1/k of an edge bends by 1/8 (alone / k^2 + 2 mixed / k + upright).
        const double rest = 8.0 * measure.tolerance - by.zz * step * step, scale = measure.em_per_cell;
        if (!(rest > 0.0)) return 0.0;
        double points = 0.0;
        const auto starts = filled.starts();
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            grid_point from = filled.points()[starts[loop + 1] - 1];
            for (std::uint32_t i = starts[loop]; i < starts[loop + 1]; ++i) {
                const grid_point to = filled.points()[i];
                const double x = scale * std::fabs(static_cast<double>(to.x) - static_cast<double>(from.x)),
                             y = scale * std::fabs(static_cast<double>(to.y) - static_cast<double>(from.y));
                const double alone = by.xx * x * x + 2.0 * by.xy * x * y + by.yy * y * y,
                             mixed = (by.xz * x + by.yz * y) * step;
                const double pieces = (mixed + std::sqrt(mixed * mixed + alone * rest)) / rest;
                points += pieces > 1.0 ? std::ceil(pieces) : 1.0;
                from = to;
            }
        }
        return points;
    }

    /// The placement of the flat solid in the deformation's space.
    [[nodiscard]] static placement flat_placement(const detail::bent_measure<Deformation>& measure,
                                                  const solid_place& place) noexcept
    {
        placement at;
        at.unit_per_cell = at.em_per_cell = measure.em_per_cell;
        at.unit_per_depth = at.em_per_depth = place.em_per_depth;
        at.pen = at.em_pen = (1.0 / measure.em_per_cell) * place.origin;
        return at;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
