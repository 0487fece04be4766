// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>
#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan data of refined: the solid of the refined region.
template <class Solid, class Refiner>
struct refined_data : refined_solid<Solid> {
    typename Refiner::scratch working;  ///< the refiner's memory, which is not stored with the glyph

    explicit refined_data(memory source = heap()) noexcept : refined_solid<Solid>{source}, working{source} {}
};

/// An extruder that refines each glyph's triangles before another extruder makes the solid. Use it for meshes that will
/// be bent, displaced or used in a simulation. Caps and walls share the points that are added to the outline, so the
/// solid stays closed.
///
///     refined<>{.how = {.max_edge = 0.05f}}                    extruded, no edge of its caps longer than 0.05 em
///     refined<flat>{.how = {.min_angle = 30.0f}}
///     refined<extruded<creased_normals>>{.solid = {.depth = 0.1f}}
///
/// It has the other extruder's parts. All triangles of merged glyphs belong to shared_glyph.
///
/// Fails  as the refiner and the other extruder do
template <refinable_extruder Solid = extruded<>, refiner Refiner = delaunay_refined>
struct refined {
    Solid solid = {};
    Refiner how = {};

    static constexpr std::size_t part_count = part_count_of<Solid>;
    using plan_data = refined_data<Solid, Refiner>;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires cacheable_policy<Solid> && cacheable_policy<Refiner>
    {
        option_hash all;
        all.add_key_of(solid);
        all.add_key_of(how);
        return {all.first, all.second};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = how.refused_options()) return e;
        if (filled.points().empty()) return data.plan(solid, filled, caps);
        std::uint32_t kept = 0;
        if (error e = how(filled, caps.triangles(), data.working, data.out(kept))) return e;
        return data.plan_refined(solid, filled, caps);
    }

    // The reports of the other extruder.

    [[nodiscard]] height_range heights() const noexcept { return solid.heights(); }
    /// The name of the other extruder's option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return heights_name_of(solid); }

    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        each_seen_from_front(solid, s.data, put);
    }

    /// The number of hard edges that the other extruder counts.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
        requires has_hard_edges<Solid>
    {
        return solid.hard_edges(s.data);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        solid.template vertices<Wants>(p, s.data, at, put);
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        solid.triangles(p, s.data, first, put);
    }
};
static_assert(extruder<refined<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
