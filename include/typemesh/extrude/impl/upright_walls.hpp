// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The upright walls over a region's edges, between two heights, with their own vertices.
///
///     vertices    a pair (upper, lower) for each point, along each contour; a doubled point has one for the wall
///                 before it and one for the wall after
///     triangles   two per edge
///
///     top     a-----c      seen from outside; each wall lies between the last pair of its first point and the first
///             | \   |      pair of its second
///     bottom a+1---c+1
///
/// Walls in several segments have a column of segments + 1 vertices (wall_rows.hpp) instead of each pair, and
/// 2 * segments triangles per edge, from the top down. A column's vertices share normal, tangent and u.
struct upright_walls {
    double top = 0.0;  ///< heights, in the extruder's unit
    double bottom = 0.0;
    double front = 0.0;  ///< the height where v is 1, except in box mapping
    texture_mapping texture = texture_mapping::em;
    std::uint32_t segments = 1;  ///< 1 to wall_rows::most

    template <attribute Wants, class Axes, class Put>
    void vertices(array_view<const grid_point> points, array_view<const side_point> side_points, const Axes& axes,
                  const placement& at, Put& put) const noexcept
    {
        if constexpr (has(Wants, attribute::uv | attribute::tangent))
            with_mapping(texture, [&]<class Mapping>() noexcept {
                if (segments == 1) [[likely]]
                    write<Wants, Mapping>(points, side_points, axes, at, put);
                else
                    write_columns<Wants, Mapping>(*this, points, side_points, axes, at, put);
            });
        else if (segments == 1) [[likely]]
            write<Wants, no_mapping>(points, side_points, axes, at, put);
        else
            write_columns<Wants, no_mapping>(*this, points, side_points, axes, at, put);
    }

    /// The triangles of walls in one segment.
    template <class Put>
    static void triangles(array_view<const std::uint32_t> starts, array_view<const side_point> side_points,
                          std::uint32_t first, Put& put) noexcept
    {
        const side_point* sides = side_points.data();
        std::uint32_t a = first;
        const auto wall = [&put](std::uint32_t from, std::uint32_t c) noexcept {
            put(from, from + 1, c + 1);
            put(from, c + 1, c);
        };
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            const std::uint32_t last = starts[loop + 1] - 1, start = a;
            for (std::uint32_t i = starts[loop]; i < last; ++i) {
                a += sides[i].doubled ? 2u : 0u;
                wall(a, a + 2);
                a += 2;
            }
            a += sides[last].doubled ? 2u : 0u;
            wall(a, start);
            a += 2;
        }
    }

    /// The triangles of walls in any number of segments.
    template <class Put>
    static void triangles(array_view<const std::uint32_t> starts, array_view<const side_point> side_points,
                          std::uint32_t segments, std::uint32_t first, Put& put) noexcept
    {
        if (segments == 1) [[likely]]
            return triangles(starts, side_points, first, put);
        column_triangles(starts, side_points, segments, first, put);
    }

    [[nodiscard]] static constexpr std::uint32_t vertex_count(std::uint32_t points, std::uint32_t doubled,
                                                              std::uint32_t segments = 1) noexcept
    {
        return (segments + 1) * (points + doubled);
    }

private:
    /// For output without texture: an em_mapping for each letter cost 2 % when only positions were written.
    struct no_mapping {
        explicit no_mapping(const placement&) noexcept {}
    };

    /// The triangles of walls in several segments. Inlined beside the other function, they cost the common case 4 %.
    template <class Put>
    [[gnu::noinline, gnu::cold]] static void column_triangles(array_view<const std::uint32_t> starts,
                                                              array_view<const side_point> side_points,
                                                              std::uint32_t segments, std::uint32_t first,
                                                              Put& put) noexcept
    {
        const std::uint32_t column = segments + 1;
        std::uint32_t next = first;  // the column that follows the last one so far
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            const std::uint32_t start = next;
            for (std::uint32_t i = starts[loop], end = starts[loop + 1]; i != end; ++i) {
                next += side_points[i].doubled ? 2 * column : column;
                std::uint32_t a = next - column, c = i + 1 == end ? start : next;
                for (std::uint32_t k = 0; k < segments; ++k, ++a, ++c) {
                    put(a, a + 1, c + 1);
                    put(a, c + 1, c);
                }
            }
        }
    }

    /// Flattened: otherwise g++ 12 leaves `put` a call, which cost 25 % where tangents are written.
    template <attribute Wants, class Mapping, class Axes, class Put>
    [[gnu::flatten]] void write(array_view<const grid_point> points, array_view<const side_point> side_points,
                                const Axes& axes, const placement& at, Put& put) const noexcept
    {
        const float upper = at.height(top), lower = at.height(bottom);
        [[maybe_unused]] const Mapping mapping{at};
        const wall_texture wall{at};
        [[maybe_unused]] const float v_top = wall.v(front - top), v_bottom = wall.v(front - bottom);
        const side_point* sides = side_points.data();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const grid_point g = points[i];
            const side_point& here = sides[i];
            surface_point<Wants> front_point, back_point;
            if constexpr (has(Wants, attribute::position)) {
                const auto foot = axes.foot(g);
                front_point.position = axes.position(foot, upper);
                back_point.position = axes.position(foot, lower);
            }
            if constexpr (has(Wants, attribute::normal)) {
                front_point.normal = back_point.normal = axes.direction(here.before.x, here.before.y, 0.0f);
            }
            wall_place place{placement::exact(g), here.along, v_top, here.before};
            if constexpr (has(Wants, attribute::uv)) {
                front_point.uv = mapping.uv(place);
                back_point.uv = mapping.uv(place.with_v(v_bottom));
            }
            if constexpr (has(Wants, attribute::tangent)) {
                front_point.tangent = back_point.tangent = mapping.tangent(axes, place);
            }
            put(front_point);
            put(back_point);
            if (!here.doubled) continue;
            if constexpr (has(Wants, attribute::normal)) {
                front_point.normal = back_point.normal = axes.direction(here.after.x, here.after.y, 0.0f);
            }
            place.outward = here.after;
            if constexpr (has(Wants, attribute::uv)) {
                if (here.seam) {
                    place.along = Mapping::after_seam(here.along);
                    front_point.uv = mapping.uv(place);
                    back_point.uv = mapping.uv(place.with_v(v_bottom));
                }
            }
            if constexpr (has(Wants, attribute::tangent)) {
                front_point.tangent = back_point.tangent = mapping.tangent(axes, place);
            }
            put(front_point);
            put(back_point);
        }
    }

    /// The same for several segments: bit for bit, the first and the last vertex of a column are the pair of write().
    /// Inlined beside write(), it cost the common case 1 %.
    template <attribute Wants, class Mapping, class Axes, class Put>
    [[gnu::noinline, gnu::cold]] static void write_columns(upright_walls walls, array_view<const grid_point> points,
                                                           array_view<const side_point> side_points, const Axes& axes,
                                                           const placement& at, Put& put) noexcept
    {
        struct level {
            float z, v;  // as written
        };
        level levels[wall_rows::most + 1];
        const wall_rows rows{walls.top, walls.bottom, walls.segments};
        const wall_texture wall{at};
        for (std::uint32_t k = 0; k <= walls.segments; ++k) {
            const double height = rows.height(k);
            levels[k] = {at.height(height), wall.v(walls.front - height)};
        }
        [[maybe_unused]] const Mapping mapping{at};
        const auto column = [&](grid_point g, float along, vec2 outward) noexcept {
            surface_point<Wants> v;
            [[maybe_unused]] const auto foot = axes.foot(g);
            [[maybe_unused]] const wall_place place{placement::exact(g), along, 0.0f, outward};
            if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(outward.x, outward.y, 0.0f);
            if constexpr (has(Wants, attribute::tangent)) v.tangent = mapping.tangent(axes, place);
            for (std::uint32_t k = 0; k <= walls.segments; ++k) {
                if constexpr (has(Wants, attribute::position)) v.position = axes.position(foot, levels[k].z);
                if constexpr (has(Wants, attribute::uv)) v.uv = mapping.uv(place.with_v(levels[k].v));
                put(v);
            }
        };
        for (std::size_t i = 0; i < points.size(); ++i) {
            const side_point& here = side_points[i];
            column(points[i], here.along, here.before);
            if (!here.doubled) continue;
            float along = here.along;
            if constexpr (has(Wants, attribute::uv)) along = here.seam ? Mapping::after_seam(along) : along;
            column(points[i], along, here.after);
        }
    }
};

namespace detail {

/// Fills with n times side_point{}, whose bytes are zero; in pieces, because memset is slow to start on large blocks.
inline void clear_sides(side_point* sides, std::size_t n) noexcept
{
    static_assert(std::is_trivially_copyable_v<side_point>);
    constexpr std::size_t piece = 64;
    for (; n > piece; n -= piece, sides += piece) std::memset(static_cast<void*>(sides), 0, piece * sizeof *sides);
    std::memset(static_cast<void*>(sides), 0, n * sizeof *sides);
}

}  // namespace detail

/// The number of points whose walls meet hard: each has two pairs of vertices. Seams are not counted.
[[nodiscard]] inline std::uint64_t count_hard(array_view<const side_point> sides) noexcept
{
    std::uint64_t hard = 0;
    for (const side_point& one : sides) hard += one.doubled && !(one.seam && one.before == one.after) ? 1u : 0u;
    return hard;
}

/// Fills `out`, which is empty, with a side_point for each point of the region, lit by `normals`, and returns the
/// number of doubled points (0 for styles that share the caps' vertices). If the mapping has seams, a contour without a
/// doubled point gets one for its seam.
///
/// Fails  error::out_of_memory, and as `normals` does
template <side_normals Normals>
[[nodiscard]] result<std::uint32_t> plan_sides(const region& filled, const Normals& normals, texture_mapping texture,
                                               buffer<side_point>& out) noexcept
{
    const std::size_t n = filled.points().size();
    side_point* sides = out.append(n);
    if (sides == nullptr) return error::out_of_memory;
    detail::clear_sides(sides, n);
    if (error e = normals(filled, {sides, n})) return e;
    if constexpr (Normals::shares_caps) return 0u;
    return with_mapping(texture, [&]<class Mapping>() noexcept { return Mapping::plan(filled, {sides, n}); });
}

}  // namespace typemesh::inline TYPEMESH_ABI
