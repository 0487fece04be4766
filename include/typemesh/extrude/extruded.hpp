// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/shared_normals.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that makes a front, a back and walls between them.
///
///         front  z = 0                 vertices      front N, back N, walls 2N, and 2 more for every doubled point;
///     +----------+                                   with shared_normals the walls have no vertices of their own
///     |\         |\      walls:        triangles     front and back n + 2h - 2c each (region.hpp), walls 2 per edge
///     | +--------|-+     two triangles
///     | |        | |     per edge      doubled       the H hard points that the style of normals finds; and the seam
///     +-|--------+ |                                 of each contour without a hard point: one of its points, unless
///      \|         \|                                 the mapping is box
///       +----------+  back  z = -depth
///
/// With several segments, the walls are divided along the depth, for meshes that will be bent, twisted or displaced.
/// They have segments + 1 rows of vertices at equal distances, and 2 * segments triangles per edge. Normal, tangent and
/// u are equal along the depth. With shared_normals and cap_normals the rows between the caps are vertices of the side,
/// one per point and row. Their normals are the normalised sums of their two walls' normals; their texture coordinates
/// are the caps'.
///
/// A part that is switched off has no vertices and no triangles. With shared_normals and cap_normals, however, a cap
/// keeps its vertices as long as walls share them.
///
/// plan() cannot know which attributes a vertex will want, so it always finds the normals and places the seams (box
/// mapping has no seams). Writing computes only the requested attributes.
///
///     extruded{}                                     curve_normals, 0.2 em deep, one texture tile per em
///     extruded<>{.depth = 0.3f}                      only clang before 17 needs the <>
///     extruded<shared_normals>{.depth = 0.3f}
///     extruded<>{.texture = texture_mapping::box}    one texture over the whole text instead (texture.hpp)
///     extruded<creased_normals>{.normals = {.crease_degrees = 20.0f}}
///     extruded<>{.depth = 1.0f, .segments = 8}       a mesh that can be bent along its depth
///
/// Fails  error::bad_option: depth is not positive and finite, segments are 0 or more than 1024, or an option of the
///        normals is out of range
///        error::too_large: more than 2^30 - 1 points, or walls of as many quadrilaterals
///        error::out_of_memory
/// Cost   O(n), and one side_point per contour point if there are walls
template <side_normals Normals = curve_normals>
struct extruded {
    float depth = 0.2f;    ///< the depth of the solid, in em or in output units: see text_options::depth_in
    bool centred = false;  ///< whether the front is at z = depth / 2 and the back at -depth / 2
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;
    Normals normals = {};
    std::uint32_t segments = 1;  ///< the number of equal pieces into which walls are divided along the depth: 1 to 1024

    /// See option_bits. The depth matters only for writing. But a depth that plan() refuses needs a key of its own, so
    /// that no result cached for another depth is found. The Normals policy may use the first three of the four numbers
    /// in option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
        requires std::is_empty_v<Normals> || requires(const Normals& n) {
            { n.cache_key() } noexcept;
        }
    {
        option_bits bits;
        if constexpr (requires { normals.cache_key(); }) bits = normals.cache_key();
        TYPEMESH_ASSERT(bits.words[3] == 0, "the normals of an extruded{} may use three of the four option_bits");
        const bool deep = is_finite(as_double(depth)) && depth > 0.0f;
        const bool flags[] = {front, back, side, deep};
        for (int i = 0; i < 4; ++i) bits.words[3] |= std::uint64_t{flags[i]} << i;
        bits.words[3] |= static_cast<std::uint64_t>(texture) << 4;
        bits.words[3] |= std::uint64_t{segments} << 32;
        return bits;
    }

    static constexpr bool writes_inner_points = true;  ///< see refined.hpp
    using plan_data = plan_arrays<side_point>;  ///< one side_point per contour point, if there are walls with normals

    [[nodiscard]] result<part_sizes> plan(const region& filled, plan_data& data) const noexcept
    {
        if (!is_finite(as_double(depth)) || !(depth > 0.0f)) return error::bad("depth");
        if (!wall_rows::is_valid(segments)) return error::bad("segments");
        const std::size_t n = filled.points().size();
        if (std::uint64_t{n} * (side ? segments : 1) > 0x3FFF'FFFFu) return error::too_large;
        const bool is_lit = side && n != 0 && (segments != 1 || !keeps_caps);
        if (keeps_caps || !is_lit)
            if (error e = normals(region{}, {})) return e;
        if (!is_lit) return sizes(filled, 0);

        const auto doubled = plan_sides(filled, wall_normals(), texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        return sizes(filled, *doubled);
    }

    [[nodiscard]] height_range heights() const noexcept
    {
        const double high = centred ? 0.5 * as_double(depth) : 0.0, low = high - as_double(depth);
        return {side || back ? low : front ? high : 0.0, side || front ? high : back ? low : 0.0};
    }

    /// The number of points whose walls meet hard: each has two pairs of vertices. Seams are not counted.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return count_hard(s.data.of<side_point>());
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        with_axes(at, [&](const auto& axes) noexcept {
            if (p == part::front && has_front()) cap<Wants>(s, axes, at, high(), 1.0f, put);
            if (p == part::back && has_back()) cap<Wants>(s, axes, at, low(), -1.0f, put);
            if constexpr (!Normals::shares_caps) {
                if (p == part::side && side) {
                    const upright_walls walls{high(), low(), high(), texture, segments};
                    const auto sides = s.data.of<side_point>();
                    walls.vertices<Wants>(s.points.first(sides.size()), sides, axes, at, put);
                }
            } else {
                if (p == part::side && side && segments != 1) rows_between_caps<Wants>(s, axes, at, put);
            }
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p == part::front && front) {
            const std::uint32_t base = first[part::front];
            for (const triangle& t : s.triangles) put(base + t.a, base + t.b, base + t.c);
        }
        if (p == part::back && back) {
            const std::uint32_t base = first[part::back];
            for (const triangle& t : s.triangles) put(base + t.a, base + t.c, base + t.b);
        }
        if (p == part::side && side) {
            if constexpr (!Normals::shares_caps)
                upright_walls::triangles(s.starts, s.data.of<side_point>(), segments, first[part::side], put);
            else if (segments == 1)
                join_caps(s, first, put);
            else
                join_rows(s, first, put);
        }
    }

private:
    /// Whether the normals of caps lean towards the walls that share their vertices.
    static constexpr bool leans = Normals::shares_caps && !requires { requires Normals::leaves_caps_alone; };
    /// Whether walls share the caps' vertices, and use their normals unchanged.
    static constexpr bool keeps_caps = Normals::shares_caps && !leans;

    /// The normals that light the walls' own vertices.
    [[nodiscard]] auto wall_normals() const noexcept
    {
        if constexpr (keeps_caps)
            return shared_normals{};
        else
            return normals;
    }

    [[nodiscard]] double high() const noexcept { return centred ? 0.5 * as_double(depth) : 0.0; }
    [[nodiscard]] double low() const noexcept { return high() - as_double(depth); }

    [[nodiscard]] bool has_front() const noexcept { return front || (Normals::shares_caps && side); }
    [[nodiscard]] bool has_back() const noexcept { return back || (Normals::shares_caps && side); }

    [[nodiscard]] part_sizes sizes(const region& filled, std::uint32_t doubled) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        part_sizes all;
        all.vertices[part::front] = has_front() ? n : 0;
        all.vertices[part::back] = has_back() ? n : 0;
        if (side)
            all.vertices[part::side] =
                Normals::shares_caps ? (segments - 1) * n : upright_walls::vertex_count(n, doubled, segments);
        all.triangles[part::front] = front ? filled.triangle_count() : 0;
        all.triangles[part::back] = back ? filled.triangle_count() : 0;
        all.triangles[part::side] = side ? 2 * segments * n : 0;
        return all;
    }

    template <attribute Wants, class Axes, class Put>
    void cap(const solid_with<plan_data>& s, const Axes& axes, const placement& at, double height, float facing,
             Put& put) const noexcept
    {
        const float z = at.height(height);
        [[maybe_unused]] const bool lit_by_cap = facing > 0.0f ? front : back;
        const vec3 flat_normal = axes.direction(0.0f, 0.0f, facing);
        const planar_texture uv{texture, at};
        texture_tangent tangents;
        vec4 flat_tangent;
        if constexpr (has(Wants, attribute::tangent)) {
            tangents = texture_tangent{at.frame};
            flat_tangent = tangents.on_cap(axes, facing);
        }
        [[maybe_unused]] const auto sides = s.data.of<side_point>();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const grid_point g = s.points[i];
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), z);
            if constexpr (has(Wants, attribute::normal)) {
                v.normal = flat_normal;
                if constexpr (leans) {
                    if (i < sides.size()) {
                        const vec3 n = shared(sides[i], lit_by_cap ? facing : 0.0f);
                        v.normal = axes.direction(n.x, n.y, n.z);
                    }
                }
            }
            if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
            if constexpr (has(Wants, attribute::tangent)) {
                v.tangent = flat_tangent;
                if constexpr (leans) {
                    if (i < sides.size()) {
                        const vec3 n = shared(sides[i], lit_by_cap ? facing : 0.0f);
                        v.tangent = tangents.on_rim(axes, n, facing);
                    }
                }
            }
            put(v);
        }
    }

    /// The normalised sum of the normals of two walls and a cap, in the text's own axes; cap is its z, or 0 for none.
    static vec3 shared(const side_point& s, float cap) noexcept
    {
        const point before{as_double(s.before.x), as_double(s.before.y)},
            after{as_double(s.after.x), as_double(s.after.y)};
        point sum = before + after;
        if (dot(sum, sum) < 0x1p-30) {  // a needle's tip: the line comes from the edges' directions (see joint_normal)
            sum = {after.y - before.y, before.x - after.x};
            if (!is_zero(cap)) sum = {};
            if (cross(before, after) < 0.0) sum = -1.0 * sum;
        }
        const double scale = 1.0 / std::sqrt(dot(sum, sum) + as_double(cap) * as_double(cap));
        return {static_cast<float>(scale * sum.x), static_cast<float>(scale * sum.y), static_cast<float>(scale) * cap};
    }

    /// The rows between the caps, for walls that share the caps' vertices: point by point, each from the top down.
    template <attribute Wants, class Axes, class Put>
    void rows_between_caps(const solid_with<plan_data>& s, const Axes& axes, const placement& at,
                           Put& put) const noexcept
    {
        const auto sides = s.data.of<side_point>();
        const wall_rows rows{high(), low(), segments};
        const planar_texture uv{texture, at};
        [[maybe_unused]] const texture_tangent tangents{at.frame};
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const grid_point g = s.points[i];
            [[maybe_unused]] const vec3 n = shared(sides[i], 0.0f);
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(n.x, n.y, n.z);
            if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
            if constexpr (has(Wants, attribute::tangent)) v.tangent = tangents.on_rim(axes, n, 1.0f);
            for (std::uint32_t k = 1; k < segments; ++k) {
                if constexpr (has(Wants, attribute::position))
                    v.position = axes.position(axes.foot(g), at.height(rows.height(k)));
                put(v);
            }
        }
    }

    /// 2 * segments triangles per edge, between the caps' own vertices and the rows between them.
    template <class Put>
    void join_rows(const solid& s, const first_vertices& first, Put& put) const noexcept
    {
        const std::uint32_t top = first[part::front], bottom = first[part::back], between = first[part::side];
        const auto vertex = [&](std::uint32_t i, std::uint32_t row) noexcept {
            return row == 0 ? top + i : row == segments ? bottom + i : between + i * (segments - 1) + row - 1;
        };
        for (std::size_t loop = 0; loop + 1 < s.starts.size(); ++loop) {
            const std::uint32_t begin = s.starts[loop], end = s.starts[loop + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t next = i + 1 == end ? begin : i + 1;
                for (std::uint32_t k = 0; k < segments; ++k) {
                    put(vertex(i, k), vertex(i, k + 1), vertex(next, k + 1));
                    put(vertex(i, k), vertex(next, k + 1), vertex(next, k));
                }
            }
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
};

static_assert(extruder<extruded<>>);

}  // namespace typemesh::inline TYPEMESH_ABI
