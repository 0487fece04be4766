// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/boundary_mover.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/impl/inner_solid.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/fill/corner_parting.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The place of a hollow letter's ring: inside the letter's edges, on both sides of them, or around them.
enum class outline_place : std::uint8_t { inner, centre, outer };

/// An extruder with no output: no letter within the ring.
struct no_letter {
    [[nodiscard]] result<part_sizes> plan(const region&) const noexcept { return part_sizes{}; }
    [[nodiscard]] height_range heights() const noexcept { return {}; }
    template <attribute Wants, class Put>
    void vertices(part, const solid&, const placement&, Put&&) const noexcept
    {
    }
    template <class Put>
    void triangles(part, const solid&, const first_vertices&, Put&&) const noexcept
    {
    }
};
static_assert(extruder<no_letter>);

/// The plan data of outlined: the ring's solid, the solid of the letter within it, and the outline if the letter grew.
template <class Ring, class Letter>
struct outlined_data {
    using outline_arrays = plan_arrays<grid_point, std::uint32_t>;  ///< points, starts
    /// The three as their extruders read them.
    struct view {
        typename outline_arrays::view outline;
        solid_of<Ring> ring;
        solid_of<Letter> letter;
    };

    outline_arrays outline;
    inner_solid<Ring> ring;
    inner_solid<Letter> letter;
    boundary_mover mover;
    buffer<curve> curves;

    explicit outlined_data(memory source = heap()) noexcept
        : outline{source}, ring{source}, letter{source}, mover{source}, curves{source}
    {
    }
    void clear() noexcept
    {
        outline.clear();
        ring.clear();
        letter.clear();
    }
    [[nodiscard]] view read() const noexcept { return {outline.read(), ring.read(), letter.read()}; }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept { return 16 + outline.bytes() + ring.bytes() + letter.bytes(); }

    ///     block   [ start of the ring, start of the letter ][ outline ][ ring ][ letter ]
    void copy_to(std::byte* block) const noexcept
    {
        const std::uint64_t of_ring = 16 + outline.bytes(), at[] = {of_ring, of_ring + ring.bytes()};
        std::memcpy(block, at, sizeof at);
        outline.copy_to(block + sizeof at);
        ring.copy_to(block + at[0]);
        letter.copy_to(block + at[1]);
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        std::uint64_t at[2];
        std::memcpy(at, block, sizeof at);
        return {outline_arrays::read_from(block + sizeof at), inner_solid<Ring>::read_from(block + at[0]),
                inner_solid<Letter>::read_from(block + at[1])};
    }
};

/// An extruder of hollow letters: a ring along the edges, made into a solid by any other extruder. Optionally another
/// extruder makes the letter within the ring.
///
///      .-->--.       inner     the ring reaches from the letter's edges inwards: the letter keeps its size
///     | .-<-. |      centre    half of it lies within the edges, half around them
///     | |   | |      outer     it lies around the letter, which grows
///     | '->-' |
///      '--<--'       Where a stroke is thinner than the thickness that is removed, the ring fills it.
///
///     outlined<>{.width = 0.02f}
///     outlined<extruded<>, extruded<>>{.place = outline_place::outer, .letter = {.depth = 0.1f, .centred = true}}
///
/// The ring's parts come first, then the letter's. With two `extruded` these are part{0} to part{2} and part{3} to
/// part{5}, with their own materials. At most eight parts are possible. Edges that ring and letter share are identical,
/// point by point, in opposite directions, so there is no gap between the two. If every edge of the mesh must have two
/// faces (text_options::corners), the letter keeps 8 cells away from its ring, and from bridges that join its corners.
///
/// Corners, advances, letters that meet after they have grown, and distances at which the edges are not proven simple
/// are treated as with `embolden`.
///
/// If a letter is drawn within the ring, neither extruder may grow its solid (for example by outward bevels), because
/// ring and letter would intersect: error::bad_option "ring" or "letter".
///
/// Fails  error::bad_option: the width is not positive and finite, or on a glyph it is below four cells (centre: eight)
///        or at least 2^28; the mitre limit is below 1 and not 0 ("outlined::width", "outlined::mitre_limit"); or as
///        the two extruders do
///        error::edges_not_moved: the new edges are not proven simple, even at a fraction of the width
///        error::outline_beyond_grid, error::out_of_memory
template <extruder Ring = extruded<>, extruder Letter = no_letter>
struct outlined {
    float width = 0.02f;  ///< the width of the ring, always in em
    outline_place place = outline_place::inner;
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;  ///< the limit for sharp corners, at least 1; 0: no limit
    Ring ring = {};
    Letter letter = {};

    static constexpr bool has_letter = !std::is_same_v<Letter, no_letter>;
    static constexpr std::size_t ring_parts = part_count_of<Ring>;
    static constexpr std::size_t part_count = ring_parts + (has_letter ? part_count_of<Letter> : 0);
    static_assert(part_count <= max_parts,
                  "typemesh: an outlined{} has at most eight parts for ring and letter: bevel only one of them");
    using plan_data = outlined_data<Ring, Letter>;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires(std::is_empty_v<Ring> || requires(const Ring& e) {
                    { e.cache_key() } noexcept;
                }) && (std::is_empty_v<Letter> || requires(const Letter& e) {
                    { e.cache_key() } noexcept;
                })
    {
        option_hash of_solids;
        of_solids.add_key_of(ring);
        of_solids.add_key_of(letter);
        option_bits bits{width, mitre_limit, of_solids.first, of_solids.second};
        bits.words[0] |= std::uint64_t{joins == bevel_joins::round} << 32 | static_cast<std::uint64_t>(place) << 33;
        return bits;
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (!is_finite(as_double(width)) || !(width > 0.0f)) return error::bad("outlined::width");
        if (!corner_rule{joins, mitre_limit}.is_valid()) return error::bad("outlined::mitre_limit");
        if (filled.points().empty()) return plan_both({}, {}, data, caps);
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        const double least = boundary_mover::finest * (place == outline_place::centre ? 2.0 : 1.0);
        double distance = as_double(width) * em;
        if (!(distance >= least && distance < grid::reach)) return error::bad("outlined::width");
        region of_ring, of_letter;
        error e = make_regions(filled, distance, data, caps, {of_ring, of_letter});
        bool narrowed = false;
        while (e == error::crossing_contours && 0.5 * distance >= least) {
            distance *= 0.5;
            narrowed = true;
            e = make_regions(filled, distance, data, caps, {of_ring, of_letter});
        }
        if (e == error::crossing_contours) return error::edges_not_moved;
        if (e) return e;
        auto made = plan_both(of_ring, of_letter, data, caps);
        if (made) made->narrowed = made->narrowed || narrowed;
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept
    {
        const height_range a = ring.heights();
        if constexpr (!has_letter) return a;
        const height_range b = letter.heights();
        return {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
    }

    /// The ring's triangles, then the letter's.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        each_seen_from_front(ring, s.data.ring, put);
        if constexpr (has_letter) each_seen_from_front(letter, s.data.letter, put);
    }

    // The reports of the two extruders about the ring and the letter.

    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
        requires(has_letter || has_heights<Ring>)
    {
        const height_range a = heights_of(ring, s.data.ring);
        if (!has_letter || s.data.letter.points.empty()) return a;
        const height_range b = heights_of(letter, s.data.letter);
        return {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
    }
    [[nodiscard]] bool refit(const solid_with<plan_data>& s) noexcept
        requires(refitting_extruder<Ring> || refitting_extruder<Letter>)
    {
        bool changed = false;
        if constexpr (refitting_extruder<Ring>) changed = !s.data.ring.points.empty() && ring.refit(s.data.ring);
        if constexpr (refitting_extruder<Letter>)
            changed = (!s.data.letter.points.empty() && letter.refit(s.data.letter)) || changed;
        return changed;
    }

    /// The outline of the letter with the ring around it, or the outline of the ring's extruder if this extruder makes
    /// it grow.
    [[nodiscard]] solid_outline outline(const solid_with<plan_data>& s) const noexcept
    {
        if (s.points.empty()) return {s.points, s.starts};
        if constexpr (has_outline<Ring>) {
            const solid_outline own = ring.outline(s.data.ring);
            if (own.points.data() != s.data.ring.points.data()) return own;
        }
        if (place == outline_place::inner) return {s.points, s.starts};
        return {s.data.outline.template of<grid_point>(), s.data.outline.template of<std::uint32_t>()};
    }

    /// The sum of the two extruders' counts.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
        requires has_hard_edges<Ring> && (!has_letter || has_hard_edges<Letter>)
    {
        std::uint64_t all = ring.hard_edges(s.data.ring);
        if constexpr (has_letter) all += letter.hard_edges(s.data.letter);
        return all;
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (is_of_ring(p))
            ring.template vertices<Wants>(p, s.data.ring, at, put);
        else
            letter.template vertices<Wants>(of_letter(p), s.data.letter, at, put);
    }
    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (is_of_ring(p)) return ring.triangles(p, s.data.ring, first, put);
        first_vertices own;
        for (std::size_t i = ring_parts; i < max_parts; ++i) own.of[i - ring_parts] = first.of[i];
        letter.triangles(of_letter(p), s.data.letter, own, put);
    }

private:
    static constexpr double gap = 2.0 * boundary_mover::finest;  // between ring and letter, in cells, if edges must
                                                                 // have two faces

    template <class E>
    static height_range heights_of(const E& how, const solid_of<E>& s) noexcept
    {
        if constexpr (has_heights<E>)
            if (!s.points.empty()) return how.heights(s);
        return how.heights();
    }

    template <class E>
    static bool grows([[maybe_unused]] const E& how, [[maybe_unused]] const inner_solid<E>& of) noexcept
    {
        if constexpr (has_outline<E>) {
            const auto made = of.read();
            return !made.points.empty() && how.outline(made).points.data() != made.points.data();
        }
        return false;
    }

    static constexpr bool is_of_ring(part p) noexcept { return static_cast<std::size_t>(p) < ring_parts; }
    static constexpr part of_letter(part p) noexcept
    {
        return static_cast<part>(static_cast<std::size_t>(p) - ring_parts);
    }

    /// The loops of the ring and of the letter within it.
    template <cap_maker Caps>
    [[nodiscard]] error make_loops(const region& filled, double distance, plan_data& data, Caps& caps) const noexcept
    {
        const double around = place == outline_place::outer    ? distance
                              : place == outline_place::centre ? 0.5 * distance
                                                               : 0.0;
        const corner_rule corners{joins, mitre_limit};
        contours &outer = data.ring.loops, &inner = data.letter.loops;
        data.curves.clear();
        if (!data.curves.append(filled.curves())) return error::out_of_memory;
        if (error e = data.mover(filled, around, corners, caps, data.curves, outer)) return e;
        if (error e = data.mover(filled, around - distance, corners, caps, data.curves, inner)) return e;
        if (place != outline_place::inner) {
            data.outline.clear();
            if (!data.outline.template of<grid_point>().append(outer.points.view()) ||
                !data.outline.template of<std::uint32_t>().append(outer.starts.view()))
                return error::out_of_memory;
        }
        const std::uint32_t own = outer.contour_count();
        if (!append_loops(inner, outer)) return error::out_of_memory;
        for (std::uint32_t k = own; k < outer.contour_count(); ++k) turn_loop(outer, k);
        if (has_letter && filled.corners() != touching::keep) {
            const double bridge = filled.corners() == touching::join ? 2.0 * corner_parting::reach(filled.grid()) : 0.0;
            if (error e = data.mover(filled, around - distance - gap - bridge, corners, caps, data.curves, inner))
                return e;
        }
        outer.curves = inner.curves = data.curves.view();
        return {};
    }

    struct both_regions {
        region &ring, &letter;
    };

    /// The region of the ring and, if the letter is drawn, the region of the letter within it.
    template <cap_maker Caps>
    [[nodiscard]] error make_regions(const region& filled, double distance, plan_data& data, Caps& caps,
                                     const both_regions& out) const noexcept
    {
        if (error e = make_loops(filled, distance, data, caps)) return e;
        const auto of_ring = data.ring.fill(caps);
        if (!of_ring) return of_ring.error();
        out.ring = *of_ring;
        if constexpr (has_letter) {
            const auto of_letter = data.letter.fill(caps);
            if (!of_letter) return of_letter.error();
            out.letter = *of_letter;
        } else {
            data.letter.clear();
        }
        return {};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_both(const region& of_ring, const region& of_letter, plan_data& data,
                                               Caps& caps) const noexcept
    {
        auto all = data.ring.plan(ring, of_ring, caps);
        if (!all || !has_letter) return all;
        const auto within = data.letter.plan(letter, of_letter, caps);
        if (!within) return within.error();
        for (std::size_t i = ring_parts; i < part_count; ++i) {
            all->sizes.vertices.of[i] = within->sizes.vertices.of[i - ring_parts];
            all->sizes.triangles.of[i] = within->sizes.triangles.of[i - ring_parts];
        }
        all->around.merge(within->around);
        all->narrowed = all->narrowed || within->narrowed;
        all->touching = all->touching || within->touching;
        all->corners_moved += within->corners_moved;
        all->lost_caps += within->lost_caps;
        all->kept_triangles += within->kept_triangles;
        if (grows(ring, data.ring)) return error::bad("ring");
        if (grows(letter, data.letter)) return error::bad("letter");
        return all;
    }
};
static_assert(extruder<outlined<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
