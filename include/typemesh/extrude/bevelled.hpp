// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/extrude/impl/bevel_carver.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/bevel_light.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/bevel_vertices.hpp>
#include <typemesh/extrude/impl/bevel_writer.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/impl/exact_fill.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/offset/impl/touching_walls.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The treatment of bevels where a stroke is thinner than twice their width.
enum class bevel_mode : std::uint8_t {
    clip,  ///< the bevels close in a ridge
    fit,   ///< the glyph's bevels become narrower: at most 0.9 times the width at which a connected component of the
           ///< glyph would lose all of its cap. Thinner strokes of a component still close in ridges. A speck is a
           ///< component too small to hold a circle of the tolerance; it may lose its cap (solid_plan::lost_caps)
           ///< unless all components are specks
    fit_text,  ///< all bevels of the text become as narrow as the narrowest bevels that any of its glyphs needs; the
               ///< text is planned twice. Only a text_mesher does this; elsewhere it means fit
};

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

    /// See option_bits. All options except depth, width and the switches are hashed to 128 bits.
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
        note({shading == bevel_shading::rounded, !refused(), own_heights().has_walls(0.0f)});
        bits.words[1] |= static_cast<std::uint64_t>(texture) << bit;
        bits.words[1] |= option_bits{mitre_limit}.words[0] << 32;
        option_hash rest;
        rest.add(option_bits{crease_degrees, profile_crease_degrees});
        rest.add(option_bits{wanted > width ? wanted : 0.0f}.words[0]);  // joins are computed for the wanted width
        rest.add(std::uint64_t{segments});
        rest.add_key_of(profile);
        bits.words[2] = rest.first;
        bits.words[3] = rest.second;
        return bits;
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = refused()) return e;
        const std::size_t n = filled.points().size();
        if (n == 0) return solid_plan{};
        if (n > 0x3FFF'FFFFu) return error::too_large;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        profile_scale scale = scale_of(filled, em);
        if (!(scale.width < (outward ? 0x1p25 : grid::reach))) return error::bad("width");
        solid_plan made;
        const error e = outward && scale.width >= profile_levels::finest ? plan_outward(filled, scale, data, caps, made)
                                                                         : plan_inward(filled, scale, data, caps, made);
        if (e) return e;
        const bool is_narrower = scale.width < as_double(width) * em;
        float& reached = data.of<bevel_rims>()[0].width;
        reached = is_narrower ? static_cast<float>(scale.width / em) : width;
        if (mode != bevel_mode::clip) {
            made.narrowed = made.narrowed || reached < 0.5f * (std::max)(width, wanted);
            made.lost_caps = data.swept.lost;
        }
        // Specks stay at height 0, where bevels that take the whole depth leave no thickness.
        const bool takes_all = own_heights().rim(true, 0.0f) <= own_heights().rim(false, 0.0f);
        if (mode != bevel_mode::clip && takes_all && data.swept.lost != 0 && filled.corners() != touching::keep)
            made.touching = true;
        const auto within = data.of<grid_point>().size();
        const std::uint64_t vertices = data.of<bevel_vertex>().size();
        if (vertices > 0x3FFF'FFFFu || within > 0x3FFF'FFFFu) return error::too_large;
        const bevel_rims& rims = data.of<bevel_rims>()[0];
        const std::uint64_t of_walls = !side ? 0 : rims.outward ? vertices - rims.vertices : n;
        if (of_walls * segments > 0x3FFF'FFFFu) return error::too_large;
        return made;
    }

    /// See bendable_caps in bent.hpp.
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
    /// See refinable_caps in refined.hpp.
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

    [[nodiscard]] error refused() const noexcept
    {
        const auto is_length = [](float v) noexcept { return is_finite(as_double(v)) && v >= 0.0f; };
        if (!is_length(depth) || !(depth > 0.0f)) return error::bad("depth");
        if (!is_length(width)) return error::bad("width");
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

    /// Lets a cap_maker that bends solids divide the slopes: see bendable_caps in bent.hpp.
    template <cap_maker Caps>
    error divide(plan_data& data, const profile_scale& scale, std::uint32_t frame, Caps& caps) const noexcept
    {
        if constexpr (requires(const detail::swept_heights& to) { caps.divide(data.swept, to); })
            return caps.divide(data.swept, {{profile.at(scale), scale}, as_double(bevel_depth), frame});
        return {};
    }

    [[nodiscard]] bevel_carver carver_of(const region& filled, bool outwards) const noexcept
    {
        const double em = filled.grid().cells * filled.grid().units_per_em;
        const double joins_at = wanted > width ? as_double(wanted) * em : 0.0;  // the width before refit()
        return {{as_double(mitre_limit), filled.tolerance(), joins == bevel_joins::round, outwards, joins_at},
                mode != bevel_mode::clip};
    }

    template <cap_maker Caps>
    error plan_inward(const region& filled, profile_scale& scale, plan_data& data, Caps& caps,
                      solid_plan& made) const noexcept
    {
        const auto doubled = plan_sides(filled, curve_normals{crease_degrees}, texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        bevel_carver carve = carver_of(filled, false);
        const auto make = [&](const swept_region&) noexcept {
            const error e = divide(data, scale, none, caps);
            return e ? e : make_cap(data, false, carve, caps);
        };
        const auto profile_at = [this](const profile_scale& at) noexcept { return profile.at(at); };
        if (error e = carve({filled, caps.triangles()}, profile_at, scale, caps.space(), data.swept, make)) return e;
        made.narrowed = made.narrowed || carve.narrowed;
        if (error e = make_bevel({profile.at(scale), scale}, filled, none, data, caps.space())) return e;
        made.sizes = sizes(filled, *doubled, data);
        return {};
    }

    /// Plans outward bevels: the sweep covers the surroundings of the region, and the walls stand where the sweep ends.
    template <cap_maker Caps>
    error plan_outward(const region& filled, profile_scale& scale, plan_data& data, Caps& caps,
                       solid_plan& made) const noexcept
    {
        const double reach = farthest_way(filled, scale.width, as_double(mitre_limit));
        if (error e = surround(filled, reach, caps.loops())) return e;
        data.triangles.clear();
        const auto around = caps.fill(data.triangles);
        if (!around) return around.error();
        data.around = std::move(caps.loops());  // move exchanges the storage: `around` still refers to it
        const auto doubled = plan_sides(*around, curve_normals{crease_degrees}, texture, data.of<side_point>());
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
            if (sides != bevel_sides::both) return make_cap(data, true, carve, caps);
            if (filled.corners() != touching::keep) {
                const auto proven = fill_exactly(data.swept.cap, caps, data.of<triangle>());
                data.of<triangle>().clear();
                carve.touches = !proven;
                if (!proven) return proven.error();
            }
            return keep(data.swept.cap.points.view(), data.swept.cap.starts.view(), data);
        };
        const auto profile_at = [this](const profile_scale& at) noexcept { return profile.at(at); };
        const region_to_carve given{*around, data.triangles.view()};
        if (error e = carve(given, profile_at, scale, caps.space(), data.swept, make)) return e;
        made.narrowed = carve.narrowed;
        if (scale.width < profile_levels::finest) {
            data.clear();
            return plan_inward(filled, scale, data, caps, made);
        }
        if (error e = make_bevel({profile.at(scale), scale}, *around, frame, data, caps.space())) return e;
        for (std::uint32_t i = 0; i < 4; ++i) data.of<side_point>()[frame + i].doubled = false;
        made.sizes = sizes(filled, 0, data);
        for (const bevel_vertex& b : data.of<bevel_vertex>()) made.around.add(placement::exact(b.at));
        return {};
    }

    /// Lets a cap_maker that refines caps do so: see refinable_caps in refined.hpp.
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
    error make_bevel(const profile_levels& levels, const region& filled, std::uint32_t frame, plan_data& data,
                     workspace& space) const noexcept
    {
        if (!add_strips(levels, profile_crease_degrees, shading, data.of<bevel_strip>())) return error::out_of_memory;
        workspace::scope scratch{space};
        bevel_light light{with_mapping(texture, []<class Mapping>() noexcept { return &Mapping::after_seam; })};
        const auto sides_of = data.of<side_point>().view();
        if (!light.prepare(filled, sides_of, data.swept, scratch)) return error::out_of_memory;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        const double max_apart =
            with_mapping(texture, [em]<class Mapping>() noexcept { return Mapping::max_apart(em); });
        bevel_vertices vertices{data, light, {crease_cosine(crease_degrees), max_apart}};
        bevel_rims rims{levels.view().front().arrives, levels.view().back().leaves};
        rims.own_cap = levels.view().size() == 1;
        if (frame != none) {
            light.turn_round(filled, sides_of, data.swept);
            vertices.outwards(frame);
            rims.outward = true;
        }
        if (error e = vertices.make(levels, scratch)) return e;
        rims.top =
            data.of<grid_point>().empty() && !rims.has_own_cap(true) ? rims.wall : (std::max)(rims.wall, rims.cap);
        for (const bevel_vertex& v : data.of<bevel_vertex>())
            rims.top = (std::max)(rims.top, height_of(v, data.of<bevel_strip>().view()));
        rims.vertices = static_cast<std::uint32_t>(data.of<bevel_vertex>().size());
        rims.triangles = static_cast<std::uint32_t>(data.of<bevel_triangle>().size());
        if (rims.outward && side && own_heights().has_walls(rims.wall))
            if (error e = vertices.add_walls(scratch)) return e;
        return data.of<bevel_rims>().push_back(rims) ? error{} : error{error::out_of_memory};
    }

    [[nodiscard]] part_sizes sizes(const region& filled, std::uint32_t doubled, plan_data& data) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        const bevel_rims& rims = data.of<bevel_rims>()[0];
        part_sizes all;
        for (const bool in_front : {true, false}) {
            const part cap = in_front ? part::front : part::back,
                       bevel = in_front ? part::front_bevel : part::back_bevel;
            const bool own = rims.has_own_cap(own_heights().is_bevelled(in_front));
            if (in_front ? front : back) {
                all.vertices[cap] = own ? n : static_cast<std::uint32_t>(data.of<grid_point>().size());
                all.triangles[cap] =
                    own ? filled.triangle_count() : static_cast<std::uint32_t>(data.of<triangle>().size());
            }
            if (!own_heights().is_bevelled(in_front)) continue;
            all.vertices[bevel] = rims.vertices;
            all.triangles[bevel] = rims.triangles;
        }
        if (rims.outward) {
            const std::uint32_t of_walls = static_cast<std::uint32_t>(data.of<bevel_vertex>().size()) - rims.vertices;
            all.vertices[part::side] = of_walls / 2 * (segments + 1);  // a column for each pair
            all.triangles[part::side] =
                segments * (static_cast<std::uint32_t>(data.of<bevel_triangle>().size()) - rims.triangles);
        } else if (side && own_heights().has_walls(rims.wall)) {
            all.vertices[part::side] = upright_walls::vertex_count(n, doubled, segments);
            all.triangles[part::side] = 2 * segments * n;
        }
        return all;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
