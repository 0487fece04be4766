// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that makes only the front, at z = 0: N vertices and n + 2h - 2c triangles (region.hpp).
struct flat {
    static constexpr bool writes_inner_points = true;  ///< see refined.hpp

    texture_mapping texture = texture_mapping::em;

    /// See option_bits. The source of texture coordinates matters only for writing.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    [[nodiscard]] result<part_sizes> plan(const region& filled) const noexcept
    {
        if (filled.points().size() > 0x3FFF'FFFFu) return error::too_large;
        part_sizes sizes;
        sizes.vertices[part::front] = static_cast<std::uint32_t>(filled.points().size());
        sizes.triangles[part::front] = filled.triangle_count();
        return sizes;
    }

    [[nodiscard]] height_range heights() const noexcept { return {}; }

    template <attribute Wants, class Put>
    void vertices(part p, const solid& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const planar_texture uv{texture, at};
        with_axes(at, [&](const auto& axes) noexcept {
            const vec3 normal = axes.direction(0.0f, 0.0f, 1.0f);
            vec4 tangent;
            if constexpr (has(Wants, attribute::tangent)) tangent = texture_tangent{at.frame}.on_cap(axes, 1.0f);
            for (const grid_point g : s.points) {
                surface_point<Wants> v;
                if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), 0.0f);
                if constexpr (has(Wants, attribute::normal)) v.normal = normal;
                if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
                if constexpr (has(Wants, attribute::tangent)) v.tangent = tangent;
                put(v);
            }
        });
    }

    template <class Put>
    void triangles(part p, const solid& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const std::uint32_t base = first[part::front];
        for (const triangle t : s.triangles) put(base + t.a, base + t.b, base + t.c);
    }
};
static_assert(extruder<flat>);

}  // namespace typemesh::inline TYPEMESH_ABI
