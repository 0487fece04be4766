// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/option_hash.hpp>
#include <typemesh/extrude/boundary_mover.hpp>
#include <typemesh/extrude/corner_rule.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/inner_solid.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan data of emboldened: the solid of the bolder letter.
template <class Solid>
struct emboldened_data : inner_solid<Solid> {
    boundary_mover mover;
    buffer<curve> curves;

    explicit emboldened_data(memory source = heap()) noexcept
        : inner_solid<Solid>{source}, mover{source}, curves{source}
    {
    }
};

/// Bolder or thinner letters, made into solids by any other extruder, whose parts they have.
///
///       .-->--.       All edges move outwards by the same distance, so that strokes become twice that wider, and
///      | ,-->-. |     counters that are narrower close. With a negative distance they move inwards.
///      ||     | |
///
///     emboldened<>{.by = 0.02f}
///     emboldened<bevelled>{.by = 0.02f, .solid = {.width = 0.01f}}
///
/// Corners stay as sharp as they are drawn, up to the mitre limit: at 4, which is that of strokes in SVG, those of 29
/// degrees and more. Sharper ones, which would grow spikes, become round.
///
/// Advances are the layout's: layout_options::letter_spacing of twice the distance keeps the letters' own spacing.
/// Letters are merged (text_options::merge) where they meet when they have grown.
///
/// A distance at which the new edges are not proven is halved for that glyph (solid_plan::narrowed). Where corners meet
/// and grow a spike beyond the limit, that glyph is moved with a limit of 1.5 first.
///
/// Fails  error::bad_option: `by` is not finite or 2^28 cells or more, the mitre limit is below 1 and not 0
///        ("emboldened::mitre_limit"), or as the other extruder does
///        error::nothing_left: the glyph is nowhere as thick as what is taken off
///        error::edges_not_moved: at none of these distances are the new edges proven
///        error::outline_beyond_grid, error::out_of_memory
template <extruder Solid = extruded<>>
struct emboldened {
    float by = 0.02f;  ///< how far edges move outwards, always in em; negative: inwards
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;  ///< at least 1; 0: none
    Solid solid = {};

    static constexpr std::size_t part_count = part_count_of<Solid>;
    using plan_data = emboldened_data<Solid>;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires std::is_empty_v<Solid> || requires(const Solid& e) {
            { e.cache_key() } noexcept;
        }
    {
        option_hash of_solid;
        of_solid.add_key_of(solid);
        option_bits bits{by, mitre_limit, of_solid.first, of_solid.second};
        bits.words[0] |= std::uint64_t{joins == bevel_joins::round} << 32;
        return bits;
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (!is_finite(as_double(by))) return error::bad("by");
        if (!corner_rule{joins, mitre_limit}.is_valid()) return error::bad("emboldened::mitre_limit");
        if (filled.points().empty()) return data.plan(solid, filled, caps);
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        double distance = as_double(by) * em;
        if (!(std::fabs(distance) < grid::reach)) return error::bad("by");
        auto moved = move(filled, distance, data, caps);
        bool narrowed = false;
        while (moved.error() == error::crossing_contours && std::fabs(distance) >= boundary_mover::finest) {
            distance *= 0.5;
            narrowed = true;
            moved = move(filled, distance, data, caps);
        }
        if (moved.error() == error::crossing_contours) return error::edges_not_moved;
        if (!moved) return moved.error();
        if (moved->points().empty()) return error::nothing_left;
        auto made = data.plan(solid, *moved, caps);
        if (made) made->narrowed = made->narrowed || narrowed;
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept { return solid.heights(); }

    // What the other extruder tells of the bolder letter.

    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
        requires tells_heights<Solid>
    {
        return s.points.empty() ? solid.heights() : solid.heights(s.data);
    }
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        if (!s.points.empty()) each_seen_from_front(solid, s.data, put);
    }
    [[nodiscard]] bool refit(const solid_with<plan_data>& s) noexcept
        requires refitting_extruder<Solid>
    {
        return !s.points.empty() && solid.refit(s.data);
    }

    /// Of a thinner letter that of the letter as it is drawn.
    [[nodiscard]] solid_outline outline(const solid_with<plan_data>& s) const noexcept
    {
        if (s.points.empty() || !(by > 0.0f)) return {s.points, s.starts};
        if constexpr (tells_outline<Solid>)
            return solid.outline(s.data);
        else
            return {s.data.points, s.data.starts};
    }

    /// As the other extruder counts them.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
        requires tells_hard_edges<Solid>
    {
        return solid.hard_edges(s.data);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        solid.template vertices<Wants>(p, s.data, at, std::forward<Put>(put));
    }
    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        solid.triangles(p, s.data, first, std::forward<Put>(put));
    }

private:
    /// The region that the letter becomes; without points if nothing is left of it.
    template <cap_maker Caps>
    [[nodiscard]] result<region> move(const region& filled, double distance, plan_data& data, Caps& caps) const noexcept
    {
        data.curves.clear();
        if (!data.curves.append(filled.curves())) return error::out_of_memory;
        if (error e = data.mover(filled, distance, {joins, mitre_limit}, caps, data.curves, data.loops)) return e;
        data.loops.curves = data.curves.view();
        return data.fill(caps);
    }
};
static_assert(extruder<emboldened<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
