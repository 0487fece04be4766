// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/layout/variation_axis.hpp>
#include <typemesh/morph/impl/morph_store.hpp>
#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A stretch of the axis in which a text keeps its triangles.
struct morph_section {
    axis_coordinate first = 0, last = 0;
    std::size_t first_key = 0, keys = 0;
    std::size_t first_letter = 0, letters = 0;
    std::size_t first_origin = 0;
    mesh_size size;
    mesh_range ranges[3];  // front, back, side
};

/// One glyph of a section.
struct morph_letter {
    std::uint32_t glyph = 0;    // in the store
    std::uint32_t section = 0;  // in the store
    cluster_id cluster = no_cluster;
};

/// How a morph is written: from font units to the output's unit and frame.
struct morph_form {
    double units_per_em = 1000.0;
    double size = 1.0;
    float depth = 0.0f;  // in the output's unit
    typemesh::frame frame = {};
};

/// A step from one key to the next, and the share of it that lies before a place.
struct morph_step {
    std::size_t key = 0;
    double share = 0.0;
};

/// The step in which a coordinate lies; beyond the ends, it is the end.
[[nodiscard]] inline morph_step step_in(array_view<const axis_coordinate> keys, double coordinate) noexcept
{
    if (keys.size() < 2) return {};
    std::size_t k = 0;
    while (k + 2 < keys.size() && coordinate >= static_cast<double>(keys[k + 1])) ++k;
    const double low = static_cast<double>(keys[k]), high = static_cast<double>(keys[k + 1]);
    const double share = (coordinate - low) / (high - low);
    return {k, share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share};
}

/// What is written: a mesh, or differences to the mesh at the first key.
enum class morph_output : std::uint8_t { mesh, differences };

namespace detail {

/// Writes one section of a morph_plan.
struct morph_writer {
    const morph_store& store;
    const morph_section& section;
    array_view<const axis_coordinate> keys;
    array_view<const morph_letter> letters;
    array_view<const point> origins;
    array_view<placement::footprint> feet;  // room for all points
    const morph_form& form;

    template <morph_output Output, class Sink>
    void vertices(double coordinate, Sink& sink) const noexcept
    {
        constexpr bool differs = Output == morph_output::differences;
        const double start = static_cast<double>(keys[0]);
        place_feet(coordinate, false);
        if constexpr (differs) place_feet(start, true);
        caps<differs>(part::front, 0.0f, 1.0f, sink);
        if (!(form.depth > 0.0f)) return;
        caps<differs>(part::back, -form.depth, -1.0f, sink);
        std::size_t first = 0;
        for (const morph_letter& l : letters) {
            walls<differs>(l, first, coordinate, sink);
            first += store.glyphs[l.glyph].points;
        }
    }

    template <class Sink>
    void triangles(Sink& sink) const noexcept
    {
        const bool turned = form.frame.turns_triangles();
        const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
            turned ? sink.triangle(a, c, b) : sink.triangle(a, b, c);
        };
        for (std::size_t p = 0; p < 2; ++p) {
            if (p == 1 && !(form.depth > 0.0f)) return;
            std::uint32_t first = section.ranges[p].first_vertex;
            for (const morph_letter& l : letters) {
                for (const triangle& t : store.triangles_of(store.sections[l.section]))
                    p == 0 ? put(first + t.a, first + t.b, first + t.c) : put(first + t.a, first + t.c, first + t.b);
                first += store.glyphs[l.glyph].points;
            }
        }
        std::uint32_t first = section.ranges[2].first_vertex;
        for (const morph_letter& l : letters) {
            const morph_glyph& g = store.glyphs[l.glyph];
            const auto corners = store.corners_of(g);
            // Vertices of the walls: top and bottom of each soft point; of a hard one top and bottom for the wall that
            // arrives, then for the wall that leaves. A contour's first point comes first.
            std::uint32_t at = first, contour = first;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const std::uint32_t own = at + (corners[i].hard ? 2 : 0);
                const bool closes = corners[i].next <= i;
                const std::uint32_t next = closes ? contour : own + 2;
                put(own, own + 1, next + 1);
                put(own, next + 1, next);
                at = own + 2;
                if (closes) contour = at;
            }
            first = at;
        }
    }

private:
    static constexpr point mixed(grid_point a, grid_point b, double s) noexcept
    {
        return {a.x + s * (static_cast<double>(b.x) - a.x), a.y + s * (static_cast<double>(b.y) - a.y)};
    }

    /// Computes the feet of all points at a coordinate, for `base` in the second half of the room.
    void place_feet(double coordinate, bool base) const noexcept
    {
        const morph_step of_text = step_in(keys, coordinate);
        placement::footprint* to = feet.data() + (base ? feet.size() / 2 : 0);
        for (std::size_t j = 0; j < letters.size(); ++j) {
            const morph_glyph& g = store.glyphs[letters[j].glyph];
            const morph_step step = step_of(g, coordinate);
            const point pen = lerp(origins[of_text.key * letters.size() + j],
                                   origins[next_key(of_text, keys.size()) * letters.size() + j], of_text.share);
            const placement at = place(g, pen);
            const grid_point* const a = store.points_of(g, step.key).data();
            const grid_point* const b = store.points_of(g, next_key(step, g.keys)).data();
            for (std::uint32_t i = 0; i < g.points; ++i) *to++ = at.foot(mixed(a[i], b[i], step.share));
        }
    }
    static std::size_t next_key(morph_step step, std::size_t count) noexcept
    {
        return step.key + 1 < count ? step.key + 1 : step.key;
    }
    [[nodiscard]] morph_step step_of(const morph_glyph& g, double coordinate) const noexcept
    {
        return step_in(store.keys_of(g), coordinate);
    }
    [[nodiscard]] placement place(const morph_glyph& g, point pen) const noexcept
    {
        placement at;
        at.pen = g.cells * pen;
        at.unit_per_cell = form.size / (form.units_per_em * g.cells);
        at.frame = form.frame;
        return at;
    }

    static vec3 difference(vec3 a, vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

    /// The position of the point of a number, or its way from the base.
    template <bool Differs>
    [[nodiscard]] vec3 position(std::size_t i, float z) const noexcept
    {
        const placement at{.frame = form.frame};
        const vec3 there = at.position(feet[i], z);
        if constexpr (Differs)
            return difference(there, at.position(feet[feet.size() / 2 + i], z));
        else
            return there;
    }

    template <bool Differs, class Sink>
    void caps(part p, float z, float facing, Sink& sink) const noexcept
    {
        constexpr attribute wants = Sink::wants;
        surface_point<wants> v;
        if constexpr (has(wants, attribute::part)) v.part = p;
        if constexpr (has(wants, attribute::normal)) v.normal = Differs ? vec3{} : form.frame(0.0f, 0.0f, facing);
        std::size_t foot = 0;
        for (const morph_letter& l : letters) {
            const morph_glyph& g = store.glyphs[l.glyph];
            if constexpr (has(wants, attribute::glyph)) v.glyph = g.id;
            if constexpr (has(wants, attribute::cluster)) v.cluster = l.cluster;
            for (std::uint32_t i = 0; i < g.points; ++i, ++foot) {
                if constexpr (has(wants, attribute::position)) v.position = position<Differs>(foot, z);
                sink.vertex(v);
            }
        }
    }

    template <bool Differs, class Sink>
    void walls(const morph_letter& l, std::size_t first, double coordinate, Sink& sink) const noexcept
    {
        constexpr attribute wants = Sink::wants;
        const morph_glyph& g = store.glyphs[l.glyph];
        const morph_step step = step_of(g, coordinate), base = step_of(g, static_cast<double>(keys[0]));
        const auto corners = store.corners_of(g);
        surface_point<wants> v;
        if constexpr (has(wants, attribute::part)) v.part = part::side;
        if constexpr (has(wants, attribute::glyph)) v.glyph = g.id;
        if constexpr (has(wants, attribute::cluster)) v.cluster = l.cluster;
        for (std::uint32_t i = 0; i < g.points; ++i) {
            for (std::uint32_t leaves = corners[i].hard ? 0 : 1; leaves < 2; ++leaves) {
                if constexpr (has(wants, attribute::normal)) {
                    v.normal = normal(g, step, 2 * i + leaves, !Differs);
                    if constexpr (Differs) v.normal = difference(v.normal, normal(g, base, 2 * i + leaves, false));
                }
                if constexpr (has(wants, attribute::position)) v.position = position<Differs>(first + i, 0.0f);
                sink.vertex(v);
                if constexpr (has(wants, attribute::position)) v.position = position<Differs>(first + i, -form.depth);
                sink.vertex(v);
            }
        }
    }

    /// The mixture of the normals at two keys. If they cancel, it is the first of them.
    [[nodiscard]] vec3 normal(const morph_glyph& g, morph_step step, std::size_t i, bool unit) const noexcept
    {
        const vec2 a = store.normals_of(g, step.key)[i], b = store.normals_of(g, next_key(step, g.keys))[i];
        const auto s = static_cast<float>(step.share);
        float x = a.x + s * (b.x - a.x), y = a.y + s * (b.y - a.y);
        const float square = x * x + y * y;
        if (unit && square > 1e-12f) {
            const float scale = 1.0f / std::sqrt(square);
            x *= scale;
            y *= scale;
        } else if (unit) {
            x = a.x;
            y = a.y;
        }
        return form.frame(x, y, 0.0f);
    }
};

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
