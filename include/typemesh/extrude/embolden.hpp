// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/extrude/impl/boundary_mover.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/inner_region.hpp>
#include <typemesh/extrude/region_step.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// A step before any solid that makes letters bolder or thinner.
///
///       .-->--.       All edges move outwards by the same distance. Strokes become wider by twice this distance,
///      | ,-->-. |     and narrower counters close. With a negative distance, edges move inwards.
///      ||     | |
///
///     text_mesher mesher{font, embolden{.by = 0.02f}, bevelled{.width = 0.01f}};
///
/// Corners stay sharp up to the mitre limit. A limit of 4, the default for strokes in SVG, keeps corners of 29 degrees
/// and more; sharper corners would grow spikes, so they become round.
///
/// The layout's advances do not change: a shape_options::letter_spacing of twice the distance keeps the gaps between
/// letters. Bolder letters are merged (text_options::merge) where they meet after they have grown. Thinner letters are
/// merged where they meet as drawn, or where their solid makes them meet again, for example with outward bevels.
///
/// If a glyph's new edges are not proven simple, the distance is halved for this glyph (solid_plan::narrowed). If
/// corners meet and grow a spike beyond the limit, the glyph's edges are first moved again with a limit of 1.5.
///
/// Fails  error::bad_option: `by` is not finite, or is 2^28 cells or more; or the mitre limit is below 1 and not 0
///        ("embolden::mitre_limit")
///        error::nothing_left: the glyph is nowhere thicker than the thickness that is removed
///        error::edges_not_moved: the new edges are not proven simple at any of these distances
///        error::outline_beyond_grid, error::out_of_memory
struct embolden {
    float by = 0.02f;  ///< the distance that edges move outwards, always in em; negative: inwards
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;  ///< the limit for sharp corners, at least 1; 0: no limit

    /// The bolder letter, and the working memory for making it.
    struct scratch : inner_region {
        boundary_mover mover;
        buffer<curve> curves;

        explicit scratch(memory source = heap()) noexcept : inner_region{source}, mover{source}, curves{source} {}
    };

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {by, mitre_limit, joins}; }

    /// See region_step.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(as_double(by))) return error::bad("by");
        if (!corner_rule{joins, mitre_limit}.is_valid()) return error::bad("embolden::mitre_limit");
        return {};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<stepped_region> operator()(const region& drawn, scratch& made, Caps& caps) const noexcept
    {
        if (error e = refused_options()) return e;
        const double em = drawn.grid().cells * drawn.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        double distance = as_double(by) * em;
        if (!(std::fabs(distance) < grid::reach)) return error::bad("by");
        auto moved = move(drawn, distance, made, caps);
        bool narrowed = false;
        while (moved.error() == error::crossing_contours && std::fabs(distance) >= boundary_mover::finest) {
            distance *= 0.5;
            narrowed = true;
            moved = move(drawn, distance, made, caps);
        }
        if (moved.error() == error::crossing_contours) return error::edges_not_moved;
        if (!moved) return moved.error();
        if (moved->points().empty()) return error::nothing_left;
        return stepped_region{*moved,   made.triangles.view(),       by > 0.0f,
                              narrowed, made.parting.still_touching, made.parting.corners};
    }

private:
    /// The region that the letter becomes; it has no points if nothing remains.
    template <cap_maker Caps>
    [[nodiscard]] result<region> move(const region& drawn, double distance, scratch& made, Caps& caps) const noexcept
    {
        made.curves.clear();
        if (!made.curves.append(drawn.curves())) return error::out_of_memory;
        if (error e = made.mover(drawn, distance, {joins, mitre_limit}, caps, made.curves, made.loops)) return e;
        made.loops.curves = made.curves.view();
        return made.fill(caps);
    }
};
static_assert(region_step<embolden>);

}  // namespace typemesh::inline TYPEMESH_ABI
