// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/mixed_key.hpp>
#include <typemesh/extrude/axes.hpp>
#include <typemesh/extrude/bevel_data.hpp>
#include <typemesh/extrude/bevel_light.hpp>
#include <typemesh/extrude/bevel_strips.hpp>
#include <typemesh/extrude/bevel_vertices.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/ready_profiles.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/extrude/upright_walls.hpp>
#include <typemesh/offset/sweep_inwards.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Which edges are bevelled.
enum class bevel_sides : std::uint8_t { both, front, back };

/// What a bevel does where a stroke is thinner than twice its width.
enum class bevel_mode : std::uint8_t {
    clip,  ///< it closes in a ridge
    fit,   ///< the bevels of that glyph become narrower: 0.9 times the width at which a part of it would lose its cap
};

/// How a corner is filled that is turned away from the interior and sharper than the mitre limit.
enum class bevel_joins : std::uint8_t { round, bevelled };

/// A front, a back, walls between them, and bevels along the edges of front, back or both: five parts.
///
///            ______         front       z = 0       the bevel is carved in: the depth is that of the whole, front and
///          /        \       front_bevel             back stay where they are and become smaller
///         |          |      side
///          \ ______ /       back_bevel              the profile is drawn from the wall inwards
///                           back        z = -depth
///
/// A bevel's height over a point depends only on how far the edges had moved when they reached it, so it cannot cut
/// itself. Where a stroke is thinner than twice the width, its bevels meet in a ridge (bevel_mode).
///
///     bevelled<>{.depth = 0.2f, .width = 0.03f, .bevel_depth = 0.03f}
///     bevelled<round_profile>{.profile = {.steps = 4}}
///     bevelled<polyline_profile>{.profile = {{{0, 0}, {0.2f, 0.8f}, {1, 1}}}}
///
/// Normals are those of the contour's curves (curve_normals), tilted by the profile's slope, and are kept along the way
/// inwards. Texture coordinates in em mapping: u as on the walls, also kept on the way inwards, v goes on with the
/// profile's length.
///
/// Fails  error::bad_option: an option is out of range, the profile is not valid (profile_points), or the bevels
///        together are deeper than the whole
///        error::too_large: more than 2^30 - 1 points or vertices of a bevel
///        error::out_of_memory
template <bevel_profile Profile = chamfer_profile>
struct bevelled {
    float depth = 0.2f;         ///< of the whole; in em, or in output units: see text_options::depth_in
    float width = 0.02f;        ///< how far a bevel reaches inwards; always in em
    float bevel_depth = 0.02f;  ///< how deep a bevel is, in the unit of depth
    bevel_sides sides = bevel_sides::both;
    bevel_mode mode = bevel_mode::clip;
    bevel_joins joins = bevel_joins::round;
    bevel_shading shading = bevel_shading::by_slope;
    float mitre_limit = 2.0f;              ///< at least 1; 0: none
    float crease_degrees = 15.0f;          ///< 0 to 180; along the contour, see curve_normals
    float profile_crease_degrees = 30.0f;  ///< 0 to 180; across the profile, drawn as wide as it is deep; half of it
                                           ///< at the wall and at the cap
    bool centred = false;                  ///< front at z = depth / 2 and back at -depth / 2
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;
    [[no_unique_address]] Profile profile = {};

    static constexpr std::size_t part_count = 5;
    using plan_data = bevel_data;

    /// See option_bits. What does not fit beside the two lengths and the switches is hashed to 128 bits.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires std::is_empty_v<Profile> || requires(const Profile& p) {
            { p.cache_key() } noexcept;
        }
    {
        option_bits bits{width, std::uint64_t{0}, std::uint64_t{0x6A09'E667'F3BC'C908u},
                         std::uint64_t{0xBB67'AE85'84CA'A73Bu}};
        bits.words[0] |= option_bits{bevel_depth}.words[0] << 32;
        const bool flags[] = {front,
                              back,
                              side,
                              texture == texture_mapping::em,
                              sides != bevel_sides::back,
                              sides != bevel_sides::front,
                              mode == bevel_mode::fit,
                              joins == bevel_joins::round,
                              shading == bevel_shading::rounded,
                              !refused(),
                              has_walls(0.0f)};
        for (int i = 0; i < 11; ++i) bits.words[1] |= std::uint64_t{flags[i]} << i;
        bits.words[1] |= option_bits{mitre_limit}.words[0] << 32;
        option_bits own;
        if constexpr (requires { profile.cache_key(); }) own = profile.cache_key();
        const option_bits creases{crease_degrees, profile_crease_degrees};
        for (const std::uint64_t word :
             {creases.words[0], creases.words[1], own.words[0], own.words[1], own.words[2], own.words[3]}) {
            for (const std::uint64_t half : {word >> 32, word & 0xFFFF'FFFFu}) {
                bits.words[2] = mixed_key(bits.words[2], half);
                bits.words[3] = mixed_key(bits.words[3], ~half);
            }
        }
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
        const auto doubled = plan_sides(filled, curve_normals{crease_degrees}, texture, data.of<side_point>());
        if (!doubled) return doubled.error();

        profile_scale scale{as_double(width) * em, as_double(bevel_depth) * em, filled.tolerance()};
        if (error e = carve(scale, filled, data, caps)) return e;
        const profile_levels levels{points_of(scale), scale};
        if (error e = make_bevel(levels, filled, data, caps.space())) return e;
        const auto within = data.of<grid_point>().size();
        if (data.of<bevel_vertex>().size() > 0x3FFF'FFFFu || within > 0x3FFF'FFFFu) return error::too_large;
        return solid_plan{sizes(filled, *doubled, data)};
    }

    [[nodiscard]] height_range heights() const noexcept { return {low(), high()}; }

    /// As extruded counts them.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return count_hard(s.data.template of<side_point>());
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        with_axes(at, [&](const auto& axes) noexcept {
            if (p == part::front && front) cap<Wants>(s, axes, at, true, put);
            if (p == part::back && back) cap<Wants>(s, axes, at, false, put);
            if (p == part::side && side && has_walls(wall_height(s))) {
                const upright_walls walls{rim(true, wall_height(s)), rim(false, wall_height(s)), high(), texture};
                walls.template vertices<Wants>(s.points, s.data.template of<side_point>(), axes, at, put);
            }
            if (p == part::front_bevel && is_bevelled(true)) bevel<Wants>(s, axes, at, true, put);
            if (p == part::back_bevel && is_bevelled(false)) bevel<Wants>(s, axes, at, false, put);
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        const std::uint32_t base = first[p];
        if (p == part::front && front)
            for (const triangle t : cap_triangles(s, true)) put(base + t.a, base + t.b, base + t.c);
        if (p == part::back && back)
            for (const triangle t : cap_triangles(s, false)) put(base + t.a, base + t.c, base + t.b);
        if (p == part::side && side && has_walls(wall_height(s)))
            upright_walls::triangles(s.starts, s.data.template of<side_point>(), base, put);
        if (p == part::front_bevel && is_bevelled(true))
            for (const auto& [t] : s.data.template of<bevel_triangle>()) put(base + t.a, base + t.b, base + t.c);
        if (p == part::back_bevel && is_bevelled(false))
            for (const auto& [t] : s.data.template of<bevel_triangle>()) put(base + t.a, base + t.c, base + t.b);
    }

private:
    // --- planning

    [[nodiscard]] error refused() const noexcept
    {
        const auto is_length = [](float v) noexcept { return is_finite(as_double(v)) && v >= 0.0f; };
        if (!is_length(depth) || !(depth > 0.0f)) return error::bad("depth");
        if (!is_length(width)) return error::bad("width");
        const double bevels = sides == bevel_sides::both ? 2.0 : 1.0;
        if (!is_length(bevel_depth) || bevels * as_double(bevel_depth) > as_double(depth))
            return error::bad("bevel_depth");
        if (!is_length(mitre_limit) || (mitre_limit < 1.0f && mitre_limit > 0.0f)) return error::bad("mitre_limit");
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        if (!is_crease_angle(profile_crease_degrees)) return error::bad("profile_crease_degrees");
        const profile_points points = points_of({1.0, 1.0, 0.0});
        if (!points.is_valid()) return error::bad("profile");
        float h = 0.0f;
        for (const profile_point p : points.view()) {
            if (shading == bevel_shading::rounded && p.h < h) return error::bad("shading");
            h = p.h;
        }
        return {};
    }

    [[nodiscard]] profile_points points_of(const profile_scale& scale) const noexcept
    {
        profile_points points;
        profile(scale, points);
        return points;
    }

    /// Sweeps the region and makes the cap, with a narrower scale where the mode asks for it, or where the sweep or the
    /// cap is refused.
    template <cap_maker Caps>
    error carve(profile_scale& scale, const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        bool fits = mode == bevel_mode::clip;
        for (;;) {
            error e = sweep_to(scale, filled, caps.triangles(), data.swept, caps.space());
            const double loss = data.swept.first_loss;
            if (!e && !fits && loss >= 0.0) {
                scale.width = 0.9 * loss;
                fits = true;
                continue;
            }
            if (!e) e = make_cap(data, caps);
            if (!e || e != error::crossing_contours) return e;
            scale.width *= 0.5;
        }
    }

    error sweep_to(const profile_scale& scale, const region& filled, std::span<const triangle> triangles,
                   swept_region& out, workspace& space) const noexcept
    {
        const profile_levels profile_on_glyph{points_of(scale), scale};
        const auto levels = profile_on_glyph.view();
        out.clear();
        if (levels.size() == 1) return sweep_nowhere(filled, out) ? error{} : error{error::out_of_memory};
        double distances[profile_points::most];
        for (std::size_t i = 0; i < levels.size(); ++i) distances[i] = levels[i].distance;
        const sweep_options how{
            {distances, levels.size()}, as_double(mitre_limit), joins == bevel_joins::round ? filled.tolerance() : 0.0};
        workspace::scope scratch{space};
        return sweep_inwards(filled, triangles, how, scratch, out);
    }

    /// Fails  error::crossing_contours: what the sweep leaves is not proven as it is
    template <cap_maker Caps>
    error make_cap(plan_data& data, Caps& caps) const noexcept
    {
        if (data.swept.cap.points.empty()) return {};
        const std::uint64_t edges = edges_of(data.swept.cap);
        caps.loops() = std::move(data.swept.cap);  // which exchanges their storage
        const auto cap = caps.fill(data.of<triangle>());
        if (!cap) return cap.error();
        if (edges_of(caps.loops()) != edges) {
            data.of<triangle>().clear();
            return error::crossing_contours;
        }
        return data.of<grid_point>().append(cap->points()) ? error{} : error{error::out_of_memory};
    }

    /// What a sweep of width 0 gives: the region's own points and edges at level 0, no cell and no cap. False when
    /// memory runs out.
    [[nodiscard]] static bool sweep_nowhere(const region& filled, swept_region& out) noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        if (!out.nodes.reserve(n) || !out.edges_at.reserve(n)) return false;
        for (const grid_point p : filled.points()) out.nodes.push_back_unchecked({p, 0.0f});
        for (std::uint32_t k = 0; k < filled.loop_count(); ++k)
            for (std::uint32_t i = filled.starts()[k], end = filled.starts()[k + 1]; i < end; ++i)
                out.edges_at.push_back_unchecked({i, i, i + 1 == end ? filled.starts()[k] : i + 1});
        return out.levels.push_back(0.0) && out.at_level.push_back(0) && out.at_level.push_back(n);
    }

    /// A number that tells sets of edges apart, in whatever order they come.
    [[nodiscard]] static std::uint64_t edges_of(const contours& loops) noexcept
    {
        std::uint64_t sum = 0;
        const auto bits = [](grid_point p) noexcept {
            return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32 | static_cast<std::uint32_t>(p.y);
        };
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k) {
            grid_point from = loops.points[loops.starts[k + 1] - 1];
            for (std::uint32_t i = loops.starts[k]; i < loops.starts[k + 1]; ++i) {
                sum += mixed_key(mixed_key(1, bits(from)), bits(loops.points[i]));
                from = loops.points[i];
            }
        }
        return sum;
    }

    error make_bevel(const profile_levels& levels, const region& filled, plan_data& data,
                     workspace& space) const noexcept
    {
        if (!add_strips(levels, profile_crease_degrees, shading, data.of<bevel_strip>())) return error::out_of_memory;
        const bevel_rims rims{levels.view().front().arrives, levels.view().back().leaves, levels.view().size() == 1};
        if (!data.of<bevel_rims>().push_back(rims)) return error::out_of_memory;
        workspace::scope scratch{space};
        bevel_light light;
        if (!light.prepare(filled, data.of<side_point>().view(), data.swept, scratch)) return error::out_of_memory;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        const double most_apart = texture == texture_mapping::em ? em / 1024.0 : -1.0;
        return bevel_vertices{data, light, {crease_cosine(crease_degrees), most_apart}}.make(levels, scratch);
    }

    [[nodiscard]] part_sizes sizes(const region& filled, std::uint32_t doubled, plan_data& data) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        const bevel_rims& rims = data.of<bevel_rims>()[0];
        part_sizes all;
        for (const bool in_front : {true, false}) {
            const part cap = in_front ? part::front : part::back,
                       bevel = in_front ? part::front_bevel : part::back_bevel;
            const bool own = rims.own_cap || !is_bevelled(in_front);
            if (in_front ? front : back) {
                all.vertices[cap] = own ? n : static_cast<std::uint32_t>(data.of<grid_point>().size());
                all.triangles[cap] =
                    own ? filled.triangle_count() : static_cast<std::uint32_t>(data.of<triangle>().size());
            }
            if (!is_bevelled(in_front)) continue;
            all.vertices[bevel] = static_cast<std::uint32_t>(data.of<bevel_vertex>().size());
            all.triangles[bevel] = static_cast<std::uint32_t>(data.of<bevel_triangle>().size());
        }
        if (side && has_walls(rims.wall)) {
            all.vertices[part::side] = upright_walls::vertex_count(n, doubled);
            all.triangles[part::side] = 2 * n;
        }
        return all;
    }

    // --- heights, in the unit of depth

    [[nodiscard]] double high() const noexcept { return centred ? 0.5 * as_double(depth) : 0.0; }
    [[nodiscard]] double low() const noexcept { return high() - as_double(depth); }
    [[nodiscard]] bool is_bevelled(bool in_front) const noexcept
    {
        return sides != (in_front ? bevel_sides::back : bevel_sides::front);
    }

    /// Where a share of a bevel's depth lies, on the front or on the back. What is subtracted is rounded to a float
    /// first, so that no compiler can fuse the two.
    [[nodiscard]] double at_share(bool in_front, float share) const noexcept
    {
        const auto down = static_cast<float>(as_double(bevel_depth) * (1.0 - as_double(share)));
        return in_front ? high() - as_double(down) : low() + as_double(down);
    }

    /// Where the walls end.
    [[nodiscard]] double rim(bool in_front, float wall) const noexcept
    {
        return is_bevelled(in_front) ? at_share(in_front, wall) : in_front ? high() : low();
    }
    [[nodiscard]] bool has_walls(float wall) const noexcept { return rim(true, wall) > rim(false, wall); }

    static const bevel_rims& rims_of(const solid_with<plan_data>& s) noexcept
    {
        return s.data.template of<bevel_rims>()[0];
    }
    static float wall_height(const solid_with<plan_data>& s) noexcept { return rims_of(s).wall; }

    // --- writing

    [[nodiscard]] bool has_own_cap(const solid_with<plan_data>& s, bool in_front) const noexcept
    {
        return rims_of(s).own_cap || !is_bevelled(in_front);
    }
    [[nodiscard]] std::span<const triangle> cap_triangles(const solid_with<plan_data>& s, bool in_front) const noexcept
    {
        return has_own_cap(s, in_front) ? s.triangles : s.data.template of<triangle>();
    }

    template <attribute Wants, class Axes, class Put>
    void cap(const solid_with<plan_data>& s, const Axes& axes, const placement& at, bool in_front,
             Put& put) const noexcept
    {
        const float facing = in_front ? 1.0f : -1.0f;
        const float z = at.height(is_bevelled(in_front) ? at_share(in_front, rims_of(s).cap) : rim(in_front, 0.0f));
        const planar_texture planar{texture, at};
        surface_point<Wants> v;
        if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(0.0f, 0.0f, facing);
        if constexpr (has(Wants, attribute::tangent)) v.tangent = texture_tangent{at.frame}.on_cap(axes, facing);
        for (const grid_point g : has_own_cap(s, in_front) ? s.points : s.data.template of<grid_point>()) {
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), z);
            if constexpr (has(Wants, attribute::uv)) v.uv = planar(g);
            put(v);
        }
    }

    /// What all of a bevel's vertices at one place of the profile have in common.
    struct across {
        float z;          ///< in output units
        float v;          ///< as it is written
        bevel_tilt tilt;  ///< on the front
        bool riser;
    };

    template <attribute Wants, class Axes, class Put>
    void bevel(const solid_with<plan_data>& s, const Axes& axes, const placement& at, bool in_front,
               Put& put) const noexcept
    {
        const auto strips = s.data.template of<bevel_strip>();
        const float facing = in_front ? 1.0f : -1.0f;
        const double cells = at.cells_per_depth(), wall_end = high() - rim(in_front, wall_height(s));
        const bevel_slopes slopes{strips, as_double(bevel_depth) * cells, shading};
        const wall_texture walls{at};
        const auto place = [&](const bevel_vertex& b) noexcept -> across {
            const double down = wall_end - as_double(facing) * slopes.length(b) / cells;
            return {at.height(at_share(in_front, slopes.height(b))), walls.v(down), slopes.tilt(b), slopes.is_riser(b)};
        };
        across ends[4 * profile_points::most];  // of all strips: nearly all vertices lie there
        for (std::uint32_t i = 0; i < strips.size(); ++i) {
            ends[2 * i] = place({{}, {}, 0.0f, 0.0f, i});
            ends[2 * i + 1] = place({{}, {}, 0.0f, 1.0f, i});
        }
        const planar_texture planar{texture, at};
        texture_tangent tangents;
        if constexpr (has(Wants, attribute::tangent)) tangents = texture_tangent{at.frame};
        for (const bevel_vertex& b : s.data.template of<bevel_vertex>()) {
            const bool inner = b.share >= 1.0f;
            const across here = inner || b.share <= 0.0f ? ends[2 * b.strip + (inner ? 1u : 0u)] : place(b);
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(b.at), here.z);
            [[maybe_unused]] vec3 normal;
            if constexpr (has(Wants, attribute::normal | attribute::tangent))
                normal = {static_cast<float>(here.tilt.out * as_double(b.outward.x)),
                          static_cast<float>(here.tilt.out * as_double(b.outward.y)),
                          static_cast<float>(here.tilt.up) * facing};
            if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(normal.x, normal.y, normal.z);
            if constexpr (has(Wants, attribute::uv))
                v.uv = texture == texture_mapping::em ? vec2{walls.u(b.along), here.v} : planar(b.at);
            if constexpr (has(Wants, attribute::tangent))
                v.tangent = texture == texture_mapping::em || here.riser ? tangents.on_wall(axes, b.outward)
                                                                         : tangents.on_rim(axes, normal, facing);
            put(v);
        }
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
