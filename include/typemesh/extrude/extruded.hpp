// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/same.hpp>
#include <typemesh/extrude/axes.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/extrude/wall_normal.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A front, a back and walls between them.
///
///         front  z = 0                 vertices      front N, back N, walls 2N, and 2 more for every doubled point;
///     +----------+                                   with shared_normals the walls have none of their own
///     |\         |\      walls:        triangles     front and back n + 2h - 2c each (region.hpp), walls 2 per edge
///     | +--------|-+     two triangles
///     | |        | |     per edge      doubled       the H hard points that the style of normals finds; in em mapping
///     +-|--------+ |                                 also one point of each contour without a hard one: its seam
///      \|         \|
///       +----------+  back  z = -depth
///
/// A part that is switched off has no vertices and triangles; only shared_normals and cap_normals keep the vertices of
/// a cap that its walls share.
///
/// plan() cannot know which attributes a vertex will want: it finds the normals and places the seams in any case (box
/// mapping has no seams). Writing computes only what is requested.
///
///     extruded{}                                     curve_normals, 0.2 em deep, one texture tile per em
///     extruded<>{.depth = 0.3f}                      the <> is for clang before 17; others do without
///     extruded<shared_normals>{.depth = 0.3f}
///     extruded<>{.texture = texture_mapping::box}    one texture over the whole text instead (texture.hpp)
///     extruded<creased_normals>{.normals = {.crease_degrees = 20.0f}}
///
/// Fails  error::bad_option: depth is not positive and finite, or an option of the normals is out of range
///        error::too_large: more than 2^30 - 1 points
///        error::out_of_memory
/// Cost   O(n), and one side_point per contour point if there are walls
template <side_normals Normals = curve_normals>
struct extruded {
    float depth = 0.2f;    ///< in em, or in output units: see text_options::depth_in
    bool centred = false;  ///< front at z = depth / 2 and back at -depth / 2
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;
    [[no_unique_address]] Normals normals = {};

    /// See option_bits. Depth matters only for writing, but a depth that plan() refuses must not find what another one
    /// cached. The normals have three of the numbers.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires std::is_empty_v<Normals> || requires(const Normals& n) {
            { n.cache_key() } noexcept;
        }
    {
        option_bits bits;
        if constexpr (requires { normals.cache_key(); }) bits = normals.cache_key();
        TYPEMESH_ASSERT(bits.words[3] == 0, "the normals of an extruded{} may use three of the four option_bits");
        const bool deep = is_finite(as_double(depth)) && depth > 0.0f;
        const bool flags[] = {front, back, side, texture == texture_mapping::em, deep};
        for (int i = 0; i < 5; ++i) bits.words[3] |= std::uint64_t{flags[i]} << i;
        return bits;
    }

    using plan_data = plan_arrays<side_point>;  ///< one per contour point, if there are walls to be lit

    [[nodiscard]] result<part_sizes> plan(const region& filled, plan_data& data) const noexcept
    {
        if (!is_finite(as_double(depth)) || !(depth > 0.0f)) return error::bad("depth");
        const std::size_t n = filled.points().size();
        if (n > 0x3FFF'FFFFu) return error::too_large;
        if (!side || n == 0 || (Normals::shares_caps && !leans)) {
            if (error e = normals(region{}, {})) return e;
            return sizes(filled, 0);
        }

        side_point* sides = data.of<side_point>().append(n);
        if (sides == nullptr) return error::out_of_memory;
        clear(sides, n);
        if (error e = normals(filled, {sides, n})) return e;
        if constexpr (Normals::shares_caps) return sizes(filled, 0);
        if (texture == texture_mapping::em) return sizes(filled, measure(filled, sides));
        std::uint32_t doubled = 0;
        for (std::size_t i = 0; i < n; ++i) doubled += sides[i].doubled;
        return sizes(filled, doubled);
    }

    [[nodiscard]] height_range heights() const noexcept
    {
        const double high = centred ? 0.5 * as_double(depth) : 0.0, low = high - as_double(depth);
        return {side || back ? low : front ? high : 0.0, side || front ? high : back ? low : 0.0};
    }

    /// The points whose walls meet hard: they have two pairs of vertices; seams are not counted.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        std::uint64_t hard = 0;
        for (const side_point& one : s.data.of<side_point>())
            hard += one.doubled && !(one.seam && one.before == one.after) ? 1u : 0u;
        return hard;
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        const double high = centred ? 0.5 * as_double(depth) : 0.0;
        const float top = at.height(high), bottom = at.height(high - as_double(depth));
        const planar_texture planar{texture, at};
        texture_tangent tangents;
        if constexpr (has(Wants, attribute::tangent)) tangents = texture_tangent{at.frame};
        with_axes(at, [&](const auto& axes) noexcept {
            if (p == part::front && has_front()) cap<Wants>(s, axes, top, 1.0f, front, planar, tangents, put);
            if (p == part::back && has_back()) cap<Wants>(s, axes, bottom, -1.0f, back, planar, tangents, put);
            if constexpr (!Normals::shares_caps) {
                if (p == part::side && side) walls<Wants>(s, axes, top, bottom, at, planar, tangents, put);
            }
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p == part::front && front) {
            const std::uint32_t base = first[part::front];
            for (const triangle t : s.triangles) put(base + t.a, base + t.b, base + t.c);
        }
        if (p == part::back && back) {
            const std::uint32_t base = first[part::back];
            for (const triangle t : s.triangles) put(base + t.a, base + t.c, base + t.b);
        }
        if (p == part::side && side) {
            if constexpr (Normals::shares_caps)
                join_caps(s, first, put);
            else
                join_walls(s, first[part::side], put);
        }
    }

private:
    /// Whether the normals of caps lean towards the walls that share their vertices.
    static constexpr bool leans = Normals::shares_caps && !requires { requires Normals::leaves_caps_alone; };

    [[nodiscard]] bool has_front() const noexcept { return front || (Normals::shares_caps && side); }
    [[nodiscard]] bool has_back() const noexcept { return back || (Normals::shares_caps && side); }

    [[nodiscard]] part_sizes sizes(const region& filled, std::uint32_t doubled) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        part_sizes all;
        all.vertices[part::front] = has_front() ? n : 0;
        all.vertices[part::back] = has_back() ? n : 0;
        all.vertices[part::side] = side && !Normals::shares_caps ? 2 * (n + doubled) : 0;
        all.triangles[part::front] = front ? filled.triangle_count() : 0;
        all.triangles[part::back] = back ? filled.triangle_count() : 0;
        all.triangles[part::side] = side ? 2 * n : 0;
        return all;
    }

    /// n times side_point{}, whose bytes are zero: in pieces, because memset is slow to start on large ones.
    static void clear(side_point* sides, std::size_t n) noexcept
    {
        static_assert(std::is_trivially_copyable_v<side_point>);
        constexpr std::size_t piece = 64;
        for (; n > piece; n -= piece, sides += piece) std::memset(static_cast<void*>(sides), 0, piece * sizeof *sides);
        std::memset(static_cast<void*>(sides), 0, n * sizeof *sides);
    }

    /// Measures lengths along each contour, from its first doubled point; without one its first point is doubled.
    /// Returns how many are doubled then.
    static std::uint32_t measure(const region& filled, side_point* sides) noexcept
    {
        const grid_point* points = filled.points().data();
        std::uint32_t doubled = 0;
        for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
            const std::uint32_t first = filled.starts()[loop], last = filled.starts()[loop + 1] - 1;
            std::uint32_t seam = first;
            while (seam < last && !sides[seam].doubled) ++seam;
            if (!sides[seam].doubled) seam = first;
            sides[seam].doubled = sides[seam].seam = true;
            double along = 0.0;
            const auto add_lengths = [&](std::uint32_t from, std::uint32_t to) noexcept {
                for (std::uint32_t i = from; i < to; ++i) {
                    const grid_point a = points[i], b = points[i + 1];  // below 2^28: differences fit, and are cheaper
                    along += length({static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)});
                    sides[i + 1].along = static_cast<float>(along);
                    doubled += sides[i + 1].doubled;
                }
            };
            add_lengths(seam, last);
            along += length(delta(points[last], points[first]));
            sides[first].along = static_cast<float>(along);
            doubled += sides[first].doubled;
            add_lengths(first, seam);
        }
        return doubled;
    }

    template <attribute Wants, class Axes, class Put>
    void cap(const solid_with<plan_data>& s, const Axes& axes, float z, float facing, bool lit_by_cap,
             planar_texture uv, texture_tangent tangents, Put& put) const noexcept
    {
        const vec3 flat_normal = axes.direction(0.0f, 0.0f, facing);
        vec4 flat_tangent;
        if constexpr (has(Wants, attribute::tangent)) flat_tangent = tangents.on_cap(axes, facing);
        const side_point* sides = s.data.of<side_point>().data();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const grid_point g = s.points[i];
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), z);
            if constexpr (has(Wants, attribute::normal)) {
                v.normal = flat_normal;
                if constexpr (leans) {
                    if (side) {
                        const vec3 n = shared(sides[i], lit_by_cap ? facing : 0.0f);
                        v.normal = axes.direction(n.x, n.y, n.z);
                    }
                }
            }
            if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
            if constexpr (has(Wants, attribute::tangent)) {
                v.tangent = flat_tangent;
                if constexpr (leans) {
                    if (side) v.tangent = tangents.on_rim(axes, shared(sides[i], lit_by_cap ? facing : 0.0f), facing);
                }
            }
            put(v);
        }
    }

    /// The normalised sum of two walls' normals and of a cap's, in the text's own axes; cap is its z, or 0 for none.
    static vec3 shared(const side_point& s, float cap) noexcept
    {
        const point before{as_double(s.before.x), as_double(s.before.y)},
            after{as_double(s.after.x), as_double(s.after.y)};
        point sum = before + after;
        if (dot(sum, sum) < 0x1p-30) {  // a needle's tip: the same line from the edges' directions (see joint_normal)
            sum = {after.y - before.y, before.x - after.x};
            if (!is_zero(cap)) sum = {};
            if (cross(before, after) < 0.0) sum = -1.0 * sum;
        }
        const double scale = 1.0 / std::sqrt(dot(sum, sum) + as_double(cap) * as_double(cap));
        return {static_cast<float>(scale * sum.x), static_cast<float>(scale * sum.y), static_cast<float>(scale) * cap};
    }

    /// Pairs (front, back) along each contour; a doubled point has one for the wall before it and one for the wall
    /// after.
    template <attribute Wants, class Axes, class Put>
    void walls(const solid_with<plan_data>& s, const Axes& axes, float top, float bottom, const placement& at,
               planar_texture planar, texture_tangent tangents, Put& put) const noexcept
    {
        const bool by_length = texture == texture_mapping::em;
        const wall_texture wall{at};
        const float v_top = wall.v(0.0), v_bottom = wall.v(as_double(depth));
        const side_point* sides = s.data.of<side_point>().data();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const grid_point g = s.points[i];
            const side_point& here = sides[i];
            surface_point<Wants> front_point, back_point;
            if constexpr (has(Wants, attribute::position)) {
                const auto foot = axes.foot(g);
                front_point.position = axes.position(foot, top);
                back_point.position = axes.position(foot, bottom);
            }
            if constexpr (has(Wants, attribute::normal)) {
                front_point.normal = back_point.normal = axes.direction(here.before.x, here.before.y, 0.0f);
            }
            if constexpr (has(Wants, attribute::uv)) {
                front_point.uv = back_point.uv = by_length ? vec2{wall.u(here.along), v_top} : planar(g);
                if (by_length) back_point.uv.y = v_bottom;
            }
            if constexpr (has(Wants, attribute::tangent)) {
                front_point.tangent = back_point.tangent = tangents.on_wall(axes, here.before);
            }
            put(front_point);
            put(back_point);
            if (!here.doubled) continue;
            if constexpr (has(Wants, attribute::normal)) {
                front_point.normal = back_point.normal = axes.direction(here.after.x, here.after.y, 0.0f);
            }
            if constexpr (has(Wants, attribute::uv)) {
                if (here.seam) front_point.uv.x = back_point.uv.x = 0.0f;
            }
            if constexpr (has(Wants, attribute::tangent)) {
                front_point.tangent = back_point.tangent = tangents.on_wall(axes, here.after);
            }
            put(front_point);
            put(back_point);
        }
    }

    /// Two triangles per edge, between the caps' own vertices.
    template <class Put>
    static void join_caps(const solid& s, const first_vertices& first, Put& put) noexcept
    {
        const std::uint32_t top = first[part::front], bottom = first[part::back];
        for (std::size_t loop = 0; loop + 1 < s.starts.size(); ++loop) {
            const std::uint32_t begin = s.starts[loop], end = s.starts[loop + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t next = i + 1 == end ? begin : i + 1;
                put(top + i, bottom + i, bottom + next);
                put(top + i, bottom + next, top + next);
            }
        }
    }

    ///     front  a-----c      seen from outside; each wall lies between the last pair of its first point and
    ///            | \   |      the first pair of its second
    ///     back  a+1---c+1
    template <class Put>
    static void join_walls(const solid_with<plan_data>& s, std::uint32_t first, Put& put) noexcept
    {
        const side_point* sides = s.data.of<side_point>().data();
        std::uint32_t a = first;
        const auto wall = [&put](std::uint32_t from, std::uint32_t c) noexcept {
            put(from, from + 1, c + 1);
            put(from, c + 1, c);
        };
        for (std::size_t loop = 0; loop + 1 < s.starts.size(); ++loop) {
            const std::uint32_t last = s.starts[loop + 1] - 1, start = a;
            for (std::uint32_t i = s.starts[loop]; i < last; ++i) {
                a += sides[i].doubled ? 2u : 0u;
                wall(a, a + 2);
                a += 2;
            }
            a += sides[last].doubled ? 2u : 0u;
            wall(a, start);
            a += 2;
        }
    }
};

static_assert(extruder<extruded<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
