// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>

#include <cmath>
#include <cstdint>

namespace stranger {

/// Letters that flare: caps twice as large as the letter, walls of the letter itself, and a slope between each cap and the
/// walls: five parts, with levels and caps of its own. Written only from the comments on extruder, plan_arrays, cap_maker.
///
///     ______________________     front   z = 0        the letter twice as large about its middle: on the grid, and simple
///      \                  /      part 3
///       |                |       side                 the letter's own walls
///      /                  \      part 4
///     ----------------------     back    z = -depth
struct flared {
    float depth = 0.3f, rim = 0.05f;  ///< em; a slope is as deep as the rim

    static constexpr std::size_t part_count = 5;
    static constexpr typemesh::part front_slope{3}, back_slope{4};

    /// What is known of the contour edge from a point to the next one of its loop.
    struct edge {
        std::uint32_t next;
        typemesh::vec2 outward;
    };
    using plan_data = typemesh::plan_arrays<edge, typemesh::grid_point, typemesh::triangle>;  // and of the caps

    typemesh::option_bits cache_key() const noexcept { return {depth, rim}; }
    typemesh::height_range heights() const noexcept { return {-double{depth}, 0.0}; }

    template <typemesh::cap_maker Caps>
    typemesh::result<typemesh::solid_plan> plan(const typemesh::region& r, plan_data& data, Caps& caps) const noexcept
    {
        using typemesh::part;
        if (!(rim > 0.0f) || !(depth > 2.0f * rim)) return typemesh::error::bad("rim");
        const std::size_t n = r.points().size();
        if (n > 0x0FFF'FFFFu) return typemesh::error::too_large;
        typemesh::contours larger{caps.space().source()};
        if (!enlarge(r, larger) || !note_edges(r, data.of<edge>())) return typemesh::error::out_of_memory;
        const auto cap = typemesh::region::proven(larger, r.holes(), r.outers(), r.is_touching());
        if (!data.of<typemesh::grid_point>().append(cap.points())) return typemesh::error::out_of_memory;
        if (typemesh::error e = caps(cap, data.of<typemesh::triangle>())) return e;

        typemesh::solid_plan made;
        for (const auto p : cap.points()) made.around.add({double(p.x), double(p.y)});
        for (const part p : {part::front, part::back}) {
            made.sizes.vertices[p] = static_cast<std::uint32_t>(n);
            made.sizes.triangles[p] = cap.triangle_count();
        }
        for (const part p : {part::side, front_slope, back_slope}) {
            made.sizes.vertices[p] = static_cast<std::uint32_t>(4 * n);
            made.sizes.triangles[p] = static_cast<std::uint32_t>(2 * n);
        }
        return made;
    }
    std::uint64_t hard_edges(const typemesh::solid& s) const noexcept { return s.points.size(); }

    template <typemesh::attribute Wants, class Put>
    void vertices(typemesh::part p, const typemesh::solid_with<plan_data>& s, const typemesh::placement& at,
                  Put&& put) const noexcept
    {
        using typemesh::part;
        const auto large = s.data.of<typemesh::grid_point>();
        const double front = 0.0, back = -double{depth}, top = -double{rim}, bottom = back + double{rim};
        if (p == part::front) cap<Wants>(large, front, 1.0f, at, put);
        if (p == part::back) cap<Wants>(large, back, -1.0f, at, put);
        if (p == part::side) band<Wants>(s, {s.points, top}, {s.points, bottom}, at, put);
        if (p == front_slope) band<Wants>(s, {large, front}, {s.points, top}, at, put);
        if (p == back_slope) band<Wants>(s, {s.points, bottom}, {large, back}, at, put);
    }
    template <class Put>
    void triangles(typemesh::part p, const typemesh::solid_with<plan_data>& s, const typemesh::first_vertices& first,
                   Put&& put) const noexcept
    {
        const std::uint32_t base = first[p];
        if (p == typemesh::part::front) {
            for (const auto t : s.data.of<typemesh::triangle>()) put(base + t.a, base + t.b, base + t.c);
        } else if (p == typemesh::part::back) {
            for (const auto t : s.data.of<typemesh::triangle>()) put(base + t.a, base + t.c, base + t.b);
        } else {
            for (std::uint32_t a = base; a < base + 4 * s.points.size(); a += 4) {
                put(a, a + 1, a + 3);
                put(a, a + 3, a + 2);
            }
        }
    }

private:
    /// Points at a height.
    struct level {
        std::span<const typemesh::grid_point> points;
        double z;
    };

    static bool enlarge(const typemesh::region& r, typemesh::contours& to) noexcept
    {
        to.grid = r.grid();
        to.grid.span *= 2.0;
        if (r.points().empty()) return true;
        if (!to.points.append(r.points()) || !to.edges.append(r.edges()) || !to.starts.append(r.starts())) return false;
        auto low = r.points().front(), high = low;
        for (const auto p : r.points()) {
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
        }
        for (auto& p : to.points) p = {2 * p.x - (low.x + high.x) / 2, 2 * p.y - (low.y + high.y) / 2};
        to.curves = r.curves();
        return true;
    }

    static bool note_edges(const typemesh::region& r, typemesh::buffer<edge>& edges) noexcept
    {
        if (!edges.reserve(r.points().size())) return false;
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) {
                const std::uint32_t next = i + 1 == r.starts()[k + 1] ? r.starts()[k] : i + 1;
                const double x = double(r.points()[next].y) - r.points()[i].y,
                             y = double(r.points()[i].x) - r.points()[next].x;
                const double l = std::hypot(x, y);
                edges.push_back_unchecked({next, {static_cast<float>(x / l), static_cast<float>(y / l)}});
            }
        }
        return true;
    }

    template <typemesh::attribute Wants, class Put>
    static void cap(std::span<const typemesh::grid_point> points, double z, float facing, const typemesh::placement& at,
                    Put& put) noexcept
    {
        using typemesh::attribute;
        const typemesh::planar_texture texture{typemesh::texture_mapping::em, at};
        for (const auto p : points) {
            typemesh::surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = at.position({double(p.x), double(p.y), z});
            if constexpr (has(Wants, attribute::normal)) v.normal = at.direction({0.0f, 0.0f, facing});
            if constexpr (has(Wants, attribute::uv)) v.uv = texture(p);
            if constexpr (has(Wants, attribute::tangent))
                v.tangent = typemesh::texture_tangent{at.frame}.along(at, {1.0f, 0.0f, 0.0f}, facing);
            put(v);
        }
    }

    /// Four vertices an edge: above and below at its start, above and below at its end.
    template <typemesh::attribute Wants, class Put>
    static void band(const typemesh::solid_with<plan_data>& s, const level& above, const level& below,
                     const typemesh::placement& at, Put& put) noexcept
    {
        using typemesh::attribute;
        const auto edges = s.data.of<edge>();
        const typemesh::wall_texture texture{at};
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            const typemesh::vec2 out = edges[i].outward;
            const auto a = above.points[i], b = below.points[i];
            const double inwards = (double(a.x) - b.x) * double{out.x} + (double(a.y) - b.y) * double{out.y},
                         down = (above.z - below.z) * at.cells_per_depth(), l = std::hypot(inwards, down);
            const auto along = static_cast<float>(down / l), towards = static_cast<float>(-inwards / l);
            typemesh::surface_point<Wants> v;
            if constexpr (has(Wants, attribute::normal))
                v.normal = at.direction({along * out.x, along * out.y, towards});
            if constexpr (has(Wants, attribute::tangent))
                v.tangent = typemesh::texture_tangent{at.frame}.along(at, {-out.y, out.x, 0.0f}, 1.0f);
            for (const std::uint32_t end : {i, edges[i].next}) {
                for (const level* which : {&above, &below}) {
                    const auto p = which->points[end];
                    if constexpr (has(Wants, attribute::position))
                        v.position = at.position({double(p.x), double(p.y), which->z});
                    if constexpr (has(Wants, attribute::uv)) v.uv = texture(0.0f, -which->z);
                    put(v);
                }
            }
        }
    }
};
static_assert(typemesh::extruder<flared>);
static_assert(typemesh::capping_extruder<flared>);

}  // namespace stranger
