// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/inflate/membrane.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The greatest height of a membrane, in em.
struct membrane_top {
    float height = 0.0f;
};

/// How far the triangles of a point inside lean away from its slope: the least product of its slope and the slope of a
/// triangle, which a limit has flattened, in em; 0 if none is negative.
struct membrane_lean {
    float least = 0.0f;
};

/// Writes an inflated letter, when its mesh and its membrane are known. Its points are the outline's, then the inner
/// ones, then some of both once more. Each has a membrane_point and a membrane_lean; on the outline the height is 0 and
/// the slope is a unit vector into the letter, or 0 where triangles do not rise.
struct inflated_surface {
    float height, limit, depth;  // no defaults: inflated has them
    bool is_dome = false;
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;
    curve_normals normals = {};

    using plan_data = plan_arrays<side_point, membrane_point, membrane_lean, membrane_top>;

    [[nodiscard]] bool has_walls() const noexcept { return side && is_dome; }

    /// Finds the normals of the outline. The sizes of the caps are the caller's.
    [[nodiscard]] result<part_sizes> plan(const region& filled, plan_data& data) const noexcept
    {
        part_sizes sizes;
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        if (n == 0) return sizes;
        const auto doubled = plan_sides(filled, normals, texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        if (has_walls()) {
            sizes.vertices[part::side] = upright_walls::vertex_count(n, *doubled);
            sizes.triangles[part::side] = 2 * n;
        }
        return sizes;
    }

    /// The height over the outline of a point of the membrane, in the unit of depths.
    [[nodiscard]] double raised(float membrane) const noexcept
    {
        const double z = as_double(height) * as_double(membrane);
        if (!(limit > 0.0f)) return z;
        const double share = z / as_double(limit);
        return z / std::sqrt(1.0 + share * share);
    }

    /// The heights of letters that are not known. No membrane is higher than half its letter is wide, so none is higher
    /// than half the grid is wide: 512 em in a font of 1024 units with the usual 512 cells each, and less in a font of
    /// more units. Fonts of fewer units, and outlines with fewer cells a unit, may have higher letters, whose own
    /// heights follow.
    [[nodiscard]] height_range heights() const noexcept { return between(raised(512.0f)); }
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
    {
        const auto top = s.data.of<membrane_top>();
        return between(top.empty() ? 0.0 : raised(top[0].height));
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        with_axes(at, [&](const auto& axes) noexcept {
            if (p == part::front && front) raised_cap<Wants>(s, axes, at, 1.0f, put);
            if (p == part::back && back) {
                if (is_dome)
                    flat_cap<Wants>(s, axes, at, put);
                else
                    raised_cap<Wants>(s, axes, at, -1.0f, put);
            }
            if (p == part::side && has_walls()) {
                const upright_walls walls{0.0, -as_double(depth), 0.0, texture};
                const auto sides = s.data.of<side_point>();
                walls.vertices<Wants>(s.points.first(sides.size()), sides, axes, at, put);
            }
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        const std::uint32_t base = first[p];
        if (p == part::front && front)
            for (const triangle& t : s.triangles) put(base + t.a, base + t.b, base + t.c);
        if (p == part::back && back)
            for (const triangle& t : s.triangles) put(base + t.a, base + t.c, base + t.b);
        if (p == part::side && has_walls()) upright_walls::triangles(s.starts, s.data.of<side_point>(), base, put);
    }

private:
    static constexpr double max_lean = 0.96875;  // above 1 a normal is behind a triangle; positions are rounded

    [[nodiscard]] height_range between(double top) const noexcept
    {
        const double bottom = is_dome ? -as_double(depth) : -top;
        return {back || has_walls() ? bottom : 0.0, front ? top : 0.0};
    }

    /// The front, or the back of a balloon.
    template <attribute Wants, class Axes, class Put>
    void raised_cap(const solid_with<plan_data>& s, const Axes& axes, const placement& at, float facing,
                    Put& put) const noexcept
    {
        const planar_texture uv{texture, at};
        texture_tangent tangents;
        if constexpr (has(Wants, attribute::tangent)) tangents = texture_tangent{at.frame};
        // dz / dx in output units, by that in em
        const double steepness = as_double(height) * (at.unit_per_depth / at.unit_per_cell) * at.em_per_cell;
        const auto membrane = s.data.of<membrane_point>();
        const auto leans = s.data.of<membrane_lean>();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const grid_point g = s.points[i];
            const membrane_point& m = membrane[i];
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position))
                v.position = axes.position(axes.foot(g), at.height(as_double(facing) * raised(m.height)));
            if constexpr (has(Wants, attribute::normal | attribute::tangent)) {
                const vec3 n = normal(m, leans[i], steepness, facing);
                if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(n.x, n.y, n.z);
                if constexpr (has(Wants, attribute::tangent)) v.tangent = tangents.on_rim(axes, n, facing);
            }
            if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
            put(v);
        }
    }

    /// The unit normal: (-dz/dx, -dz/dy, 1), all times the membrane's height, so that it is finite at the outline. If
    /// it would be behind a triangle, it leans half as far as it may.
    [[nodiscard]] vec3 normal(const membrane_point& m, membrane_lean lean, double steepness,
                              float facing) const noexcept
    {
        double along = steepness;
        if (limit > 0.0f) {
            const double share = as_double(height) * as_double(m.height) / as_double(limit),
                         flatter = 1.0 + share * share;
            along /= flatter * std::sqrt(flatter);
        }
        const double z = as_double(m.height), away = -steepness * along * as_double(lean.least);
        if (away > max_lean * z) along *= 0.5 * z / away;
        const double x = -along * as_double(m.slope.x), y = -along * as_double(m.slope.y),
                     square = x * x + y * y + z * z;
        if (!(square > 0.0)) return {0.0f, 0.0f, facing};
        const double scale = 1.0 / std::sqrt(square);
        return {static_cast<float>(scale * x), static_cast<float>(scale * y), facing * static_cast<float>(scale * z)};
    }

    /// The back of a dome.
    template <attribute Wants, class Axes, class Put>
    void flat_cap(const solid_with<plan_data>& s, const Axes& axes, const placement& at, Put& put) const noexcept
    {
        const float z = at.height(-as_double(depth));
        const vec3 normal = axes.direction(0.0f, 0.0f, -1.0f);
        const planar_texture uv{texture, at};
        vec4 tangent;
        if constexpr (has(Wants, attribute::tangent)) tangent = texture_tangent{at.frame}.on_cap(axes, -1.0f);
        for (const grid_point g : s.points) {
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), z);
            if constexpr (has(Wants, attribute::normal)) v.normal = normal;
            if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
            if constexpr (has(Wants, attribute::tangent)) v.tangent = tangent;
            put(v);
        }
    }
};
static_assert(extruder<inflated_surface>);

}  // namespace typemesh::inline TYPEMESH_ABI
