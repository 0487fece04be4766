// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>
#include <typemesh/extrude/impl/rim_refinement.hpp>
#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder whose caps can be refined.
template <class E>
concept refinable = refinable_extruder<E> || refinable_caps<E>;

/// The plan data of refined: the solid of the refined region.
template <class Solid, class Refiner>
struct refined_data : refined_solid<Solid> {
    typename Refiner::scratch working;  ///< the refiner's memory, which is not stored with the glyph
    detail::rim_refinement rim;         ///< likewise, for caps within bevels
    triangle_list own_cap;              ///< likewise, the refined triangles of the region's own cap
    std::uint32_t own_kept = 0;         ///< likewise, how many of these miss the refiner's aim

    explicit refined_data(memory source = heap()) noexcept
        : refined_solid<Solid>{source}, working{source}, rim{source}, own_cap{source}
    {
    }

    // --- for extruders that make caps of their own: see refinable_caps

    std::uint32_t kept = 0;  ///< afterwards: of all these caps

    /// Gives the solid the refined cap of the region.
    [[nodiscard]] error region_cap(std::uint32_t& added) noexcept
    {
        kept += own_kept;
        this->triangles.swap(own_cap);
        added = static_cast<std::uint32_t>(this->inner.size());
        return this->loops.points.append(this->inner.view()) ? error{} : error{error::out_of_memory};
    }
    /// The cap within a bevel has been refined together with its rim.
    [[nodiscard]] error cap(buffer<grid_point>&, array_view<const std::uint32_t>, buffer<triangle>&,
                            std::uint32_t& added) noexcept
    {
        added = 0;
        kept += rim.kept();
        return {};
    }
};

namespace detail {

/// A cap_maker that refines the caps within bevels: see refinable_caps.
template <cap_maker Caps, class Solid, refiner Refiner>
class refining_caps : public caps_of_region<Caps> {
public:
    refining_caps(Caps& caps, refined_data<Solid, Refiner>& data, const Refiner& how) noexcept
        : caps_of_region<Caps>{caps, data.triangles.view()}, data_{data}, how_{how}
    {
    }

    template <class Data>
    error refine(Data& bevel, const region& cap, bool turned) noexcept
    {
        return data_.rim.run(bevel, cap, turned, how_, data_.working);
    }

private:
    refined_data<Solid, Refiner>& data_;
    const Refiner& how_;
};

}  // namespace detail

/// An extruder that refines each glyph's triangles before another extruder makes the solid. Use it for meshes that will
/// be bent, displaced or used in a simulation. Caps and walls share the points that are added to the outline, so the
/// solid stays closed.
///
///     refined<>{.how = {.max_edge = 0.05f}}                    extruded, no edge of its caps longer than 0.05 em
///     refined<flat>{.how = {.min_angle = 30.0f}}
///     refined<extruded<creased_normals>>{.solid = {.depth = 0.1f}}
///     refined<bevelled>{.solid = {.width = 0.02f}, .how = {.min_angle = 30.0f}}
///     outlined<refined<>>{.width = 0.02f}                      hollow letters: the ring is refined
///
/// Around bevels the outline is refined first, and the slopes begin at its new points. Then each cap within a bevel is
/// refined. Points on its edges divide the slopes' triangles there, so all parts share every point. The slopes get no
/// other points, but their innermost bands get other diagonals, which leave room for these. Where two slopes almost
/// meet, a cap can be a few cells narrow, which leaves no room for points. If a refiner of your own adds a point that
/// would turn a triangle of a slope, the bevel becomes narrower.
///
/// It has the other extruder's parts. All triangles of merged glyphs belong to shared_glyph. Glyphs are merged if they
/// meet before they are refined: where the refined outlines alone meet, beyond the chords of a coarse tolerance, the
/// solids intersect. A ring of `outlined` and the letter within it are refined one by one, so their common edges get
/// different points.
///
/// solid_plan::kept_triangles counts the triangles that miss the refiner's aim.
///
/// Fails  as the refiner and the other extruder do
template <refinable Solid = extruded<>, refiner Refiner = delaunay_refined>
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
        if (error e = how(filled, caps.triangles(), data.working, data.out(data.own_kept))) return e;
        if constexpr (refinable_extruder<Solid>) {
            auto made = data.plan_refined(solid, filled, caps);
            if (made) made->kept_triangles += data.own_kept;
            return made;
        } else {
            return plan_caps(filled, data, caps);
        }
    }

    // The reports of the other extruder.

    [[nodiscard]] height_range heights() const noexcept { return solid.heights(); }
    /// See extruder.hpp.
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
        requires has_heights<Solid>
    {
        return s.points.empty() ? heights() : solid.heights(s.data);
    }
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

    /// See extruder.hpp.
    [[nodiscard]] solid_outline outline(const solid_with<plan_data>& s) const noexcept
        requires has_outline<Solid>
    {
        if (s.points.empty()) return {s.points, s.starts};
        const solid_outline own = solid.outline(s.data);
        return own.points.data() == s.data.points.data() ? solid_outline{s.points, s.starts} : own;
    }
    /// See extruder.hpp.
    [[nodiscard]] bool refit(const solid_with<plan_data>& s) noexcept
        requires refitting_extruder<Solid>
    {
        return !s.points.empty() && solid.refit(s.data);
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

private:
    /// The plan of an extruder that makes caps of its own. Its sweep begins with the boundary, without inner points.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_caps(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        const region boundary = data.boundary_of(filled);
        data.own_cap.clear();
        data.own_cap.swap(data.triangles);
        if (error e = caps(boundary, data.triangles)) return e;
        detail::refining_caps<Caps, Solid, Refiner> own{caps, data, how};
        auto made = data.plan_by(solid, boundary, own);
        if (!made) return made;
        data.kept = 0;
        if (error e = solid.refine_caps(data, data.data, *made)) return e;
        made->kept_triangles += data.kept;
        return made;
    }
};
static_assert(extruder<refined<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
