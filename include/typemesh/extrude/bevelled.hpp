// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/extrude/bevel_mode.hpp>
#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/bevel_planner.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/bevel_writer.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/texture.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that makes a front, a back, walls between them, and bevels along the edges of front, back or both: five
/// parts.
///
///            ______         front       z = 0       the bevel is carved in: `depth` is the whole depth; front and
///          /        \       front_bevel             back stay where they are and become smaller
///         |          |      side
///          \ ______ /       back_bevel              the profile is drawn from the wall inwards
///                           back        z = -depth
///
/// An outward bevel is added instead: front and back keep their size, and the walls stand outside of the letter.
///
/// A bevel's height at a point depends only on how far the edges had moved when they reached the point, so a bevel
/// cannot cross itself. Where a stroke is thinner than twice the width, its bevels meet in a ridge (bevel_mode).
///
///     bevelled{.depth = 0.2f, .width = 0.03f, .bevel_depth = 0.03f}
///     bevelled{.profile = round_profile(4)}                                bevel_profile.hpp
///     bevelled{.profile = {{0, 0}, {0.2f, 0.8f}, {1, 1}}}
///
/// With several segments, the walls between the bevels are divided along the depth, as in extruded.
///
/// If a glyph's bevel is not proven simple at its full width, it becomes narrower. The plan reports this as
/// solid_plan::narrowed. It also reports bevels that had to be less than half as wide to fit.
///
/// With text_options::corners, a solid without walls gets low walls if front and back would meet inside its outline.
/// On each bevelled side they have for each segment the height of four cells, or of 2^-20 of the bevel's depth if that
/// is more. Walls that exist are raised to this height for each segment, both sides together, if they are lower, and
/// lower than the bevel is deep. If `side` is false, or there is no room for such walls, the plan reports
/// solid_plan::touching instead.
///
/// Levels of a profile that are less than four cells of the grid apart become one. Here the depth is read as em: with
/// depth_unit::output, a bevel_depth that is less than four cells, read as em, is left out.
///
/// The normals are the normals of the contour's curves (curve_normals), tilted by the profile's slope. They do not
/// change along the path of an edge inwards. In em mapping, u is the u of the walls and does not change on this path
/// either; v continues along the length of the profile.
///
/// Fails  error::bad_option: an option is out of range; the profile is not valid (profile_points); the bevels together
///        are deeper than the solid; or they are as deep as the solid, and the profile returns to 0 beyond the wall
///        error::too_large: more than 2^24 points, or 2^30 - 1 vertices of a bevel
///        error::crossing_contours, too_many_pieces, outline_beyond_grid: the region around an outward bevel is not
///        proven simple, or reaches beyond the grid; the glyph is left out
///        error::out_of_memory
struct bevelled {
    float depth = 0.2f;         ///< the depth of the whole solid, in em or in output units: see text_options::depth_in
    float width = 0.02f;        ///< the width of a bevel, always in em; below 2^28 cells, or 2^25 cells for outward
                                ///< bevels
    float bevel_depth = 0.02f;  ///< the depth of a bevel, in the unit of depth
    bevel_sides sides = bevel_sides::both;
    bevel_mode mode = bevel_mode::clip;
    bool outward = false;  ///< bevels are added around the letter: it grows, and its caps keep their size
    bevel_joins joins = bevel_joins::round;
    bevel_shading shading = bevel_shading::by_slope;
    float mitre_limit = 2.0f;              ///< the limit for sharp corners, at least 1; 0: no limit
    float crease_degrees = 15.0f;          ///< the crease angle along the contour, 0 to 180: see curve_normals
    float profile_crease_degrees = 30.0f;  ///< the crease angle across the profile, 0 to 180, measured as if the bevel
                                           ///< were as wide as it is deep; it is half as large where the bevel meets
                                           ///< the wall or the cap
    bool centred = false;                  ///< whether the front is at z = depth / 2 and the back at -depth / 2
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;
    bevel_profile profile = {};
    std::uint32_t segments = 1;  ///< the number of equal pieces into which walls are divided along the depth: 1 to 1024
    float wanted = 0.0f;         ///< the width before refit() reduced it; leave this at 0
    bool standing = false;       ///< whether the back is at z = 0 and the front at z = depth, as of a relief

    static constexpr std::size_t part_count = 5;
    using plan_data = bevel_data;

    /// See option_bits. All options except width, bevel_depth and the switches are hashed to 128 bits.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits{width, std::uint64_t{0}};
        bits.words[0] |= option_bits{bevel_depth}.words[0] << 32;
        int bit = 0;
        const auto note = [&](std::initializer_list<bool> flags) noexcept {
            for (const bool flag : flags) bits.words[1] |= std::uint64_t{flag} << bit++;
        };
        note({front, back, side, own_heights().is_bevelled(true), own_heights().is_bevelled(false), outward});
        note({mode != bevel_mode::clip, joins == bevel_joins::round});
        note({shading == bevel_shading::rounded, !refused()});
        bits.words[1] |= static_cast<std::uint64_t>(texture) << bit;
        bits.words[1] |= option_bits{mitre_limit}.words[0] << 32;
        option_hash rest;
        rest.add(option_bits{crease_degrees, profile_crease_degrees});
        rest.add(option_bits{wanted > width ? wanted : 0.0f}.words[0]);  // joins are computed for the wanted width
        rest.add(option_bits{own_heights().thin_walls()}.words[0]);
        rest.add(std::uint64_t{segments});
        rest.add_key_of(profile);
        bits.words[2] = rest.first;
        bits.words[3] = rest.second;
        return bits;
    }

    /// `width_option` is the name of the option that is at fault if the width is out of range: extruders that are a
    /// bevel may have another one.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps,
                                          const char* width_option = "width") const noexcept
    {
        if (error e = refused(width_option)) return e;
        const std::size_t n = filled.points().size();
        if (n == 0) return solid_plan{};
        if (n > 0x3FFF'FFFFu) return error::too_large;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        profile_scale scale = scale_of(filled, em);
        if (!(scale.width < (outward ? 0x1p25 : grid::reach))) return error::bad(width_option);
        solid_plan made;
        const bevel_planner<bevelled> planner{*this, own_heights()};
        const error e = outward && scale.width >= profile_levels::finest
                            ? planner.plan_outward(filled, scale, data, caps, made)
                            : planner.plan_inward(filled, scale, data, caps, made);
        if (e) return e;
        const bool is_narrower = scale.width < as_double(width) * em;
        float& reached = data.of<bevel_rims>()[0].width;
        reached = is_narrower ? static_cast<float>(scale.width / em) : width;
        if (mode != bevel_mode::clip) {
            made.narrowed = made.narrowed || reached < 0.5f * (std::max)(width, wanted);
            made.lost_caps = data.swept.lost;
        }
        const auto within = data.of<grid_point>().size();
        const std::uint64_t vertices = data.of<bevel_vertex>().size();
        if (vertices > 0x3FFF'FFFFu || within > 0x3FFF'FFFFu) return error::too_large;
        const bevel_rims& rims = data.of<bevel_rims>()[0];
        made.touching = made.touching || rims.touches;
        const std::uint64_t of_walls = !side ? 0 : rims.outward ? vertices - rims.vertices : n;
        if (of_walls * segments > 0x3FFF'FFFFu) return error::too_large;
        return made;
    }

    /// See bendable_caps in bendable.hpp.
    [[nodiscard]] upright_faces uprights(const region& filled) const noexcept
    {
        if (refused()) return {};
        const profile_scale scale = scale_of(filled, filled.grid().cells * filled.grid().units_per_em);
        const profile_levels levels{profile.at(scale), scale};
        const bool apart = outward && scale.width >= profile_levels::finest;
        const profile_level &wall = levels.view().front(), &own = apart ? levels.view().back() : wall;
        const double walls = own_heights().rim(true, wall.arrives) - own_heights().rim(false, wall.arrives);
        return {side && walls > 0.0 ? walls : 0.0, as_double(bevel_depth) * own.riser(), apart};
    }
    /// See refinable_caps.
    template <class Refine>
    [[nodiscard]] error refine_caps(Refine& refine, plan_data& data, solid_plan& made) const noexcept
    {
        if (data.of<bevel_rims>().empty()) return {};
        const auto is_own = [&](bool in_front) noexcept {
            return data.of<bevel_rims>()[0].has_own_cap(own_heights().is_bevelled(in_front));
        };
        std::uint32_t own = 0, within = 0;
        if ((front && is_own(true)) || (back && is_own(false)))
            if (error e = refine.region_cap(own)) return e;
        if (!data.of<triangle>().empty())
            if (error e =
                    refine.cap(data.of<grid_point>(), data.of<std::uint32_t>().view(), data.of<triangle>(), within))
                return e;
        for (const bool in_front : {true, false}) {
            const part cap = in_front ? part::front : part::back;
            if (made.sizes.triangles[cap] == 0) continue;
            made.sizes.vertices[cap] += is_own(in_front) ? own : within;
            made.sizes.triangles[cap] += 2 * (is_own(in_front) ? own : within);
        }
        return {};
    }

    [[nodiscard]] height_range heights() const noexcept { return {own_heights().low(), own_heights().high()}; }

    /// The heights of a planned solid: its bevels may meet in a ridge below their full height.
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
    {
        const bevel_heights own = own_heights();
        if (s.points.empty()) return heights();
        const float top = s.data.of<bevel_rims>()[0].top;
        return {own.rim(false, top), own.rim(true, top)};
    }

    /// The triangles of one side's bevel, and of each cap that is drawn.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        const auto strips = s.data.of<bevel_strip>();
        const auto vertices = s.data.of<bevel_vertex>();
        const bevel_rims& rims = s.data.of<bevel_rims>()[0];
        for (const auto& [t] : s.data.of<bevel_triangle>().first(rims.triangles))
            if (!is_zero(strips[vertices[t.a].strip].run)) put(vertices[t.a].at, vertices[t.b].at, vertices[t.c].at);
        const auto within = s.data.of<grid_point>();
        for (const triangle t : s.data.of<triangle>()) put(within[t.a], within[t.b], within[t.c]);
        if (rims.has_own_cap(own_heights().is_bevelled(true)) || rims.has_own_cap(own_heights().is_bevelled(false)))
            for (const triangle t : s.triangles) put(s.points[t.a], s.points[t.b], s.points[t.c]);
    }

    /// The outline of the walls, if bevels are outward.
    [[nodiscard]] solid_outline outline(const solid_with<plan_data>& s) const noexcept
    {
        if (s.points.empty() || !s.data.of<bevel_rims>()[0].outward) return {s.points, s.starts};
        return {s.data.of<grid_point>(), s.data.of<std::uint32_t>()};
    }

    /// The width of a planned solid's bevels, in em: less than requested if they had to fit or were narrowed.
    [[nodiscard]] float width_of(const solid_with<plan_data>& s) const noexcept
    {
        return s.points.empty() ? 0.0f : s.data.of<bevel_rims>()[0].width;
    }

    /// For bevel_mode::fit_text: adopts the width of a solid if it is narrower.
    [[nodiscard]] bool refit(const solid_with<plan_data>& s) noexcept
    {
        if (mode != bevel_mode::fit_text || s.points.empty() || !(width_of(s) < width)) return false;
        if (!(wanted > width)) wanted = width;
        width = width_of(s);
        return true;
    }

    /// The count of hard points, as in extruded.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return count_hard(s.data.of<side_point>());
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        const bevel_writer writer{s, {own_heights(), texture, shading, segments}};
        with_axes(at, [&](const auto& axes) noexcept {
            if (p == part::front && front) writer.cap<Wants>(axes, at, true, put);
            if (p == part::back && back) writer.cap<Wants>(axes, at, false, put);
            if (p == part::side && side) writer.walls<Wants>(axes, at, put);
            if (p == part::front_bevel && own_heights().is_bevelled(true)) writer.bevel<Wants>(axes, at, true, put);
            if (p == part::back_bevel && own_heights().is_bevelled(false)) writer.bevel<Wants>(axes, at, false, put);
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        const bevel_writer writer{s, {own_heights(), texture, shading, segments}};
        const std::uint32_t base = first[p];
        if (p == part::front && front)
            for (const triangle t : writer.cap_triangles(true)) put(base + t.a, base + t.b, base + t.c);
        if (p == part::back && back)
            for (const triangle t : writer.cap_triangles(false)) put(base + t.a, base + t.c, base + t.b);
        if (p == part::side && side) writer.wall_triangles(base, put);
        if (p == part::front_bevel && own_heights().is_bevelled(true))
            for (const auto& [t] : writer.bevel_triangles()) put(base + t.a, base + t.b, base + t.c);
        if (p == part::back_bevel && own_heights().is_bevelled(false))
            for (const auto& [t] : writer.bevel_triangles()) put(base + t.a, base + t.c, base + t.b);
    }

private:
    [[nodiscard]] bevel_heights own_heights() const noexcept { return {depth, bevel_depth, sides, centred, standing}; }

    [[nodiscard]] error refused(const char* width_option = "width") const noexcept
    {
        const auto is_length = [](float v) noexcept { return is_finite(as_double(v)) && v >= 0.0f; };
        if (!is_length(depth) || !(depth > 0.0f)) return error::bad("depth");
        if (!is_length(width)) return error::bad(width_option);
        if (!wall_rows::is_valid(segments)) return error::bad("segments");
        const double bevels = sides == bevel_sides::both ? 2.0 : 1.0;
        if (!is_length(bevel_depth) || bevels * as_double(bevel_depth) > as_double(depth))
            return error::bad("bevel_depth");
        if (!corner_rule{joins, mitre_limit}.is_valid()) return error::bad("mitre_limit");
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        if (!is_crease_angle(profile_crease_degrees)) return error::bad("profile_crease_degrees");
        const profile_points points = profile.at(bevel_profile::finest);
        if (!profile.is_valid()) return error::bad("profile");
        const bool takes_all = bevels * as_double(bevel_depth) >= as_double(depth);
        constexpr float least = 0x1p-20f;  // the least height that 32-bit floats distinguish from 0
        float h = 0.0f;
        for (const profile_point p : points.view()) {
            if (takes_all && p.t > 0.0f && p.h < least) return error::bad("bevel_depth");  // no thickness there
            if (shading == bevel_shading::rounded && p.h < h) return error::bad("shading");
            h = p.h;
        }
        return {};
    }

    [[nodiscard]] profile_scale scale_of(const region& filled, double em) const noexcept
    {
        return {as_double(width) * em, as_double(bevel_depth) * em, filled.tolerance(),
                filled.corners() != touching::keep};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
