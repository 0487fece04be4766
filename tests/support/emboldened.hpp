// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/inner_solid.hpp>

#include <cstddef>

namespace test {

using namespace typemesh;

/// embolden as an extruder that has another one make the solid: for laws about regions that no mesher has planned, and
/// to compare the step in a mesher with.
template <extruder Solid = extruded<>>
struct emboldened {
    float by = 0.02f;
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;
    Solid solid = {};

    struct plan_data : inner_solid<Solid> {
        embolden::scratch step;

        explicit plan_data(memory source = heap()) noexcept : inner_solid<Solid>{source}, step{source} {}
    };
    using solid_type = solid_with<plan_data>;

    static constexpr std::size_t part_count = part_count_of<Solid>;

    [[nodiscard]] embolden step() const noexcept { return {by, joins, mitre_limit}; }

    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_hash both;
        both.add_key_of(step());
        both.add_key_of(solid);
        return {both.first, both.second};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = step().refused_options()) return e;
        if (filled.points().empty()) return data.plan(solid, filled, caps);
        const auto bolder = step()(filled, data.step, caps);
        if (!bolder) return bolder.error();
        if (!append_loops(bolder->filled, data.loops) || !data.triangles.append(bolder->triangles))
            return error::out_of_memory;
        auto made = data.inner_solid<Solid>::plan(solid, bolder->filled, caps);
        if (!made) return made;
        made->narrowed = made->narrowed || bolder->narrowed;
        made->touching = made->touching || bolder->touching;
        made->corners_moved += bolder->corners_moved;
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept { return solid.heights(); }
    [[nodiscard]] height_range heights(const solid_type& s) const noexcept
        requires has_heights<Solid>
    {
        return s.points.empty() ? solid.heights() : solid.heights(s.data);
    }
    template <class Put>
    void seen_from_front(const solid_type& s, Put&& put) const noexcept
    {
        if (!s.points.empty()) each_seen_from_front(solid, s.data, put);
    }
    [[nodiscard]] bool refit(const solid_type& s) noexcept
        requires refitting_extruder<Solid>
    {
        return !s.points.empty() && solid.refit(s.data);
    }
    [[nodiscard]] solid_outline outline(const solid_type& s) const noexcept
    {
        if (s.points.empty() || !(by > 0.0f)) return {s.points, s.starts};
        if constexpr (has_outline<Solid>)
            return solid.outline(s.data);
        else
            return {s.data.points, s.data.starts};
    }
    [[nodiscard]] std::uint64_t hard_edges(const solid_type& s) const noexcept
        requires has_hard_edges<Solid>
    {
        return solid.hard_edges(s.data);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_type& s, const placement& at, Put&& put) const noexcept
    {
        solid.template vertices<Wants>(p, s.data, at, put);
    }
    template <class Put>
    void triangles(part p, const solid_type& s, const first_vertices& first, Put&& put) const noexcept
    {
        solid.triangles(p, s.data, first, put);
    }
};

}  // namespace test
