// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/bevel_mode.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/extrude/impl/bevel_carver.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/bevel_light.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/bevel_vertices.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/impl/exact_fill.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/offset/impl/touching_walls.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Plans bevels: sweeps a region, makes the cap that remains, and the vertices and triangles of the bevel. `Bevel` has
/// the options of bevelled; the planner refers to them.
template <class Bevel>
class bevel_planner {
public:
    using plan_data = bevel_data;

    bevel_planner(const Bevel& how, const bevel_heights& heights) noexcept : how_{how}, heights_{heights} {}

    /// Plans bevels that are carved into the region.
    template <cap_maker Caps>
    error plan_inward(const region& filled, profile_scale& scale, plan_data& data, Caps& caps,
                      solid_plan& made) const noexcept
    {
        const auto doubled =
            plan_sides(filled, curve_normals{how_.crease_degrees}, how_.texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        bevel_carver carve = carver_of(filled, false);
        const auto make = [&](const swept_region&) noexcept {
            const error e = divide(data, scale, none, caps);
            return e ? e : make_cap(data, false, carve, caps);
        };
        const auto profile_at = [this](const profile_scale& at) noexcept { return how_.profile.at(at); };
        if (error e = carve({filled, caps.triangles()}, profile_at, scale, caps.space(), data.swept, make)) return e;
        made.narrowed = made.narrowed || carve.narrowed;
        if (error e = make_bevel({how_.profile.at(scale), scale}, filled, none, data, caps)) return e;
        made.sizes = sizes(filled, *doubled, data);
        return {};
    }

    /// Plans outward bevels: the sweep covers the surroundings of the region, and the walls stand where the sweep ends.
    template <cap_maker Caps>
    error plan_outward(const region& filled, profile_scale& scale, plan_data& data, Caps& caps,
                       solid_plan& made) const noexcept
    {
        const double reach = farthest_way(filled, scale.width, as_double(how_.mitre_limit));
        if (error e = surround(filled, reach, caps.loops())) return e;
        data.triangles.clear();
        const auto around = caps.fill(data.triangles);
        if (!around) return around.error();
        data.around = std::move(caps.loops());  // move exchanges the storage: `around` still refers to it
        const auto doubled =
            plan_sides(*around, curve_normals{how_.crease_degrees}, how_.texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        const double way = reach / scale.width;
        bevel_carver carve = carver_of(filled, true);
        const std::uint32_t frame = frame_of(*around);
        const auto make = [&](const swept_region&) noexcept {
            if (error e = divide(data, scale, frame, caps)) return e;
            constexpr double slack = 4.0;  // a margin for rounding
            if (!is_in_reach(data.swept.cap, filled, way * scale.width + slack)) return error{error::crossing_contours};
            leave_frame(data.swept.cap);
            if (filled.corners() != touching::keep) {
                const auto found = count_touching_walls(data.swept, caps.space());
                if (!found) return found.error();
                made.corners_moved += *found;
                carve.touches = *found != 0;
                if (*found != 0) return error{error::crossing_contours};
            }
            if (how_.sides != bevel_sides::both) return make_cap(data, true, carve, caps);
            if (filled.corners() != touching::keep) {
                const auto proven = fill_exactly(data.swept.cap, caps, data.of<triangle>());
                data.of<triangle>().clear();
                carve.touches = !proven;
                if (!proven) return proven.error();
            }
            return keep(data.swept.cap.points.view(), data.swept.cap.starts.view(), data);
        };
        const auto profile_at = [this](const profile_scale& at) noexcept { return how_.profile.at(at); };
        const region_to_carve given{*around, data.triangles.view()};
        if (error e = carve(given, profile_at, scale, caps.space(), data.swept, make)) return e;
        made.narrowed = carve.narrowed;
        if (scale.width < profile_levels::finest) {
            data.clear();
            return plan_inward(filled, scale, data, caps, made);
        }
        if (error e = make_bevel({how_.profile.at(scale), scale}, *around, frame, data, caps)) return e;
        for (std::uint32_t i = 0; i < 4; ++i) data.of<side_point>()[frame + i].doubled = false;
        made.sizes = sizes(filled, 0, data);
        for (const bevel_vertex& b : data.of<bevel_vertex>()) made.around.add(placement::exact(b.at));
        return {};
    }

private:
    /// Lets a cap_maker that bends solids divide the slopes: see bendable_caps in bendable.hpp.
    template <cap_maker Caps>
    error divide(plan_data& data, const profile_scale& scale, std::uint32_t frame, Caps& caps) const noexcept
    {
        if constexpr (requires(const detail::swept_heights& to) { caps.divide(data.swept, to); })
            return caps.divide(data.swept, {{how_.profile.at(scale), scale}, as_double(how_.bevel_depth), frame});
        return {};
    }

    [[nodiscard]] bevel_carver carver_of(const region& filled, bool outwards) const noexcept
    {
        const double em = filled.grid().cells * filled.grid().units_per_em;
        const double joins_at =
            how_.wanted > how_.width ? as_double(how_.wanted) * em : 0.0;  // the width before refit()
        return {{as_double(how_.mitre_limit), filled.tolerance(), how_.joins == bevel_joins::round, outwards, joins_at},
                how_.mode != bevel_mode::clip};
    }

    /// Lets a cap_maker that refines caps do so: see refinable_caps.
    ///
    /// Fails  error::crossing_contours: the region that the sweep leaves is not proven simple
    template <cap_maker Caps>
    error make_cap(plan_data& data, bool turned, bevel_carver& carve, Caps& caps) const noexcept
    {
        const auto cap = fill_exactly(data.swept.cap, caps, data.of<triangle>());
        if (!cap) return cap.error();
        if constexpr (requires { caps.refine(data, *cap, turned); }) {
            const error e = caps.refine(data, *cap, turned);
            carve.touches = e == error::crossing_contours;
            return e;
        } else {
            return keep(cap->points(), cap->starts(), data);
        }
    }

    /// Stores loops of the cap, or of the walls of outward bevels.
    static error keep(array_view<const grid_point> points, array_view<const std::uint32_t> starts,
                      plan_data& data) noexcept
    {
        const bool kept = data.of<grid_point>().append(points) && data.of<std::uint32_t>().append(starts);
        return kept ? error{} : error{error::out_of_memory};
    }

    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// `frame` is the index of the first of the four points around an outward bevel's surroundings, or none.
    template <cap_maker Caps>
    error make_bevel(const profile_levels& levels, const region& filled, std::uint32_t frame, plan_data& data,
                     Caps& caps) const noexcept
    {
        if (!add_strips(levels, how_.profile_crease_degrees, how_.shading, data.of<bevel_strip>()))
            return error::out_of_memory;
        workspace::scope scratch{caps.space()};
        bevel_light light{with_mapping(how_.texture, []<class Mapping>() noexcept { return &Mapping::after_seam; })};
        const auto sides_of = data.of<side_point>().view();
        if (!light.prepare(filled, sides_of, data.swept, scratch)) return error::out_of_memory;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        const double max_apart =
            with_mapping(how_.texture, [em]<class Mapping>() noexcept { return Mapping::max_apart(em); });
        bevel_vertices vertices{data, light, {crease_cosine(how_.crease_degrees), max_apart}};
        bevel_rims rims{levels.view().front().arrives, levels.view().back().leaves};
        rims.own_cap = levels.view().size() == 1;
        if (frame != none) {
            light.turn_round(filled, sides_of, data.swept);
            vertices.outwards(frame);
            rims.outward = true;
        }
        if (error e = vertices.make(levels, scratch)) return e;
        if (filled.corners() != touching::keep)
            if (error e = keep_apart(lowest(filled, solid_place_of(caps)), vertices, data, rims, scratch)) return e;
        rims.top =
            data.of<grid_point>().empty() && !rims.has_own_cap(true) ? rims.wall : (std::max)(rims.wall, rims.cap);
        for (const bevel_vertex& v : data.of<bevel_vertex>())
            rims.top = (std::max)(rims.top, height_of(v, data.of<bevel_strip>().view()));
        rims.vertices = static_cast<std::uint32_t>(data.of<bevel_vertex>().size());
        rims.triangles = static_cast<std::uint32_t>(data.of<bevel_triangle>().size());
        if (rims.outward && how_.side && heights_.has_walls(rims.wall))
            if (error e = vertices.add_walls(scratch)) return e;
        return data.of<bevel_rims>().push_back(rims) ? error{} : error{error::out_of_memory};
    }

    /// Where front and back of a solid without walls would meet inside the outline, gives it low walls instead: all
    /// that is lower than they are is raised to their end. Walls that have less than `low` for each segment grow to it.
    ///
    ///     share 0 ____________ both sides     share 0 .____________.     each raised by `low` for each segment
    ///              \ ________/                         |\ ________/|
    error keep_apart(double low, const bevel_vertices& vertices, plan_data& data, bevel_rims& rims,
                     workspace::scope& scratch) const noexcept
    {
        if (!(how_.bevel_depth > 0.0f)) return {};
        const double lowest_walls = how_.segments * low;
        const double walls =
            (heights_.rim(true, rims.wall) - heights_.rim(false, rims.wall)) / as_double(how_.bevel_depth);
        if (walls >= (std::min)(lowest_walls, 1.0)) return {};
        if (!(walls > 0.0) || !how_.side) {
            if (!has_two_sides()) return {};
            const auto meets = vertices.is_low_inside(static_cast<float>(low), scratch);
            if (!meets) return meets.error();
            if (!*meets) return {};
        }
        const double sides = heights_.sides == bevel_sides::both ? 2.0 : 1.0;
        const double wall = as_double(rims.wall) + (walls > 0.0 ? (lowest_walls - walls) / sides : lowest_walls);
        rims.touches = !how_.side || !(wall + static_cast<double>(data.of<bevel_strip>().size()) * low < 1.0);
        if (rims.touches) return {};
        rims.wall = static_cast<float>(wall);
        rims.cap = (std::max)(rims.cap, raise_strips(data.of<bevel_strip>(), rims.wall, static_cast<float>(low)));
        return {};
    }

    /// Raises what is lower than `wall`; risers there become `low` high. Returns the height that all then have.
    [[nodiscard]] static float raise_strips(buffer<bevel_strip>& strips, float wall, float low) noexcept
    {
        float floor = wall;
        for (bevel_strip& s : strips) {
            s.from = (std::max)(s.from, floor);
            if (is_zero(s.run) && same(s.from, floor) && s.to < floor + low) floor += low;
            s.to = (std::max)(s.to, floor);
        }
        return floor;
    }

    /// Whether both sides have slopes or a cap.
    [[nodiscard]] bool has_two_sides() const noexcept
    {
        return (heights_.is_bevelled(true) || how_.front) && (heights_.is_bevelled(false) || how_.back);
    }

    /// The height of a segment of low walls, as a share of the bevel's depth: four cells, as between all levels, or
    /// 2^-20 of the depth if that is more. 32-bit floats keep this apart from 0: no height is three such depths from
    /// the origin, because walls that are raised were lower than one, and its two roundings move it by less than 2^-22
    /// of the depth.
    [[nodiscard]] double lowest(const region& filled, const solid_place& place) const noexcept
    {
        const double depth = as_double(how_.bevel_depth) * place.em_per_depth;  // in em
        return (std::max)(0x1p-20, finest_band / (depth * filled.grid().cells * filled.grid().units_per_em));
    }

    [[nodiscard]] part_sizes sizes(const region& filled, std::uint32_t doubled, plan_data& data) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        const bevel_rims& rims = data.of<bevel_rims>()[0];
        part_sizes all;
        for (const bool in_front : {true, false}) {
            const part cap = in_front ? part::front : part::back,
                       bevel = in_front ? part::front_bevel : part::back_bevel;
            const bool own = rims.has_own_cap(heights_.is_bevelled(in_front));
            if (in_front ? how_.front : how_.back) {
                all.vertices[cap] = own ? n : static_cast<std::uint32_t>(data.of<grid_point>().size());
                all.triangles[cap] =
                    own ? filled.triangle_count() : static_cast<std::uint32_t>(data.of<triangle>().size());
            }
            if (!heights_.is_bevelled(in_front)) continue;
            all.vertices[bevel] = rims.vertices;
            all.triangles[bevel] = rims.triangles;
        }
        if (rims.outward) {
            const std::uint32_t of_walls = static_cast<std::uint32_t>(data.of<bevel_vertex>().size()) - rims.vertices;
            all.vertices[part::side] = of_walls / 2 * (how_.segments + 1);  // a column for each pair
            all.triangles[part::side] =
                how_.segments * (static_cast<std::uint32_t>(data.of<bevel_triangle>().size()) - rims.triangles);
        } else if (how_.side && heights_.has_walls(rims.wall)) {
            all.vertices[part::side] = upright_walls::vertex_count(n, doubled, how_.segments);
            all.triangles[part::side] = 2 * how_.segments * n;
        }
        return all;
    }

    const Bevel& how_;
    const bevel_heights heights_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
