// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_heights.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/impl/wall_rows.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The style in which a bevelled solid is written.
struct bevel_style {
    bevel_heights heights;
    texture_mapping texture = texture_mapping::em;
    bevel_shading shading = bevel_shading::by_slope;
    std::uint32_t segments = 1;  ///< of the walls, along the depth
};

/// Writes the caps, walls and bevels of a planned solid. `in_front` selects one of its two sides.
class bevel_writer {
public:
    bevel_writer(const solid_with<bevel_data>& s, const bevel_style& style) noexcept
        : solid_{s},
          rims_{s.data.of<bevel_rims>()[0]},
          heights_{style.heights},
          texture_{style.texture},
          shading_{style.shading},
          segments_{style.segments}
    {
    }

    [[nodiscard]] array_view<const triangle> cap_triangles(bool in_front) const noexcept
    {
        return has_own_cap(in_front) ? solid_.triangles : solid_.data.of<triangle>();
    }
    [[nodiscard]] array_view<const bevel_triangle> bevel_triangles() const noexcept
    {
        return solid_.data.of<bevel_triangle>().first(rims_.triangles);
    }

    template <attribute Wants, class Axes, class Put>
    void cap(const Axes& axes, const placement& at, bool in_front, Put& put) const noexcept
    {
        const float facing = in_front ? 1.0f : -1.0f;
        const bool bevelled = heights_.is_bevelled(in_front);
        const float z = at.height(bevelled ? heights_.at_share(in_front, rims_.cap) : heights_.rim(in_front, 0.0f));
        const planar_texture planar{texture_, at};
        surface_point<Wants> v;
        if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(0.0f, 0.0f, facing);
        if constexpr (has(Wants, attribute::tangent)) v.tangent = texture_tangent{at.frame}.on_cap(axes, facing);
        for (const grid_point g : has_own_cap(in_front) ? solid_.points : solid_.data.of<grid_point>()) {
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), z);
            if constexpr (has(Wants, attribute::uv)) v.uv = planar(g);
            put(v);
        }
    }

    /// Calls put(a, b, c) for each triangle of the walls, whose first vertex is number `first`.
    template <class Put>
    void wall_triangles(std::uint32_t first, Put& put) const noexcept
    {
        if (!rims_.outward) {
            if (heights_.has_walls(rims_.wall))
                upright_walls::triangles(solid_.starts, solid_.data.of<side_point>(), segments_, first, put);
            return;
        }
        const auto triangles = solid_.data.of<bevel_triangle>().subspan(rims_.triangles);
        if (segments_ != 1) return outer_wall_triangles(triangles, first, put);
        const std::uint32_t own = first - rims_.vertices;  // may wrap; the sums wrap back
        for (const auto& [t] : triangles) put(own + t.a, own + t.b, own + t.c);
    }

    template <attribute Wants, class Axes, class Put>
    void walls(const Axes& axes, const placement& at, Put& put) const noexcept
    {
        if (rims_.outward) return outer_walls<Wants>(axes, at, put);
        if (!heights_.has_walls(rims_.wall)) return;
        const upright_walls upright{heights_.rim(true, rims_.wall), heights_.rim(false, rims_.wall), heights_.high(),
                                    texture_, segments_};
        const auto sides = solid_.data.of<side_point>();  // inner points may follow the loops' points
        upright.vertices<Wants>(solid_.points.first(sides.size()), sides, axes, at, put);
    }

    template <attribute Wants, class Axes, class Put>
    void bevel(const Axes& axes, const placement& at, bool in_front, Put& put) const noexcept
    {
        if constexpr (has(Wants, attribute::uv | attribute::tangent))
            with_mapping(texture_,
                         [&]<class Mapping>() noexcept { mapped_bevel<Wants, Mapping>(axes, at, in_front, put); });
        else
            mapped_bevel<Wants, em_mapping>(axes, at, in_front, put);
    }

private:
    /// The common data of all vertices of a bevel at one place of the profile.
    struct across {
        float z;        ///< in output units
        float v;        ///< as written
        float out, up;  ///< the normal: along `outward`, and towards the reader
    };

    template <attribute Wants, class Mapping, class Axes, class Put>
    void mapped_bevel(const Axes& axes, const placement& at, bool in_front, Put& put) const noexcept
    {
        const auto strips = solid_.data.of<bevel_strip>();
        const float facing = in_front ? 1.0f : -1.0f;
        const double cells = at.cells_per_depth(), wall_end = heights_.high() - heights_.rim(in_front, rims_.wall);
        const bevel_slopes slopes{strips, as_double(heights_.bevel_depth) * cells, shading_};
        const wall_texture walls{at};
        const auto place = [&](const bevel_vertex& b) noexcept -> across {
            const double down = wall_end - as_double(facing) * slopes.length(b) / cells;
            const float z = at.height(heights_.at_share(in_front, slopes.height(b)));
            const bevel_tilt tilt = slopes.tilt(b);
            return {z, walls.v(down), static_cast<float>(tilt.out), static_cast<float>(tilt.up) * facing};
        };
        across ends[4 * profile_points::most];  // at the ends of all strips, where nearly all vertices lie
        for (std::uint32_t i = 0; i < strips.size(); ++i) {
            ends[2 * i] = place({{}, {}, 0.0f, 0.0f, i});
            ends[2 * i + 1] = place({{}, {}, 0.0f, 1.0f, i});
        }
        const bevel_surface<Wants, Mapping, Axes> surface{axes, at, slopes, facing};
        const auto vertices = solid_.data.of<bevel_vertex>().first(rims_.vertices);
        // Vertices within a strip have their own loop, so that the other loop makes no calls and stays in registers.
        for (const bevel_vertex *b = vertices.data(), *const end = b + vertices.size(); b != end; ++b) {
            for (; b != end; ++b) {
                const bool inner = b->share >= 1.0f;
                if (!inner && b->share > 0.0f) break;
                put(surface(*b, ends[2 * b->strip + (inner ? 1u : 0u)]));
            }
            if (b == end) break;
            put(surface(*b, place(*b)));
        }
    }

    /// Makes surface points of a bevel's vertices. The mapping is a parameter, so that their loop does not branch on
    /// it.
    template <attribute Wants, class Mapping, class Axes>
    class bevel_surface {
    public:
        bevel_surface(const Axes& axes, const placement& at, const bevel_slopes& slopes, float facing) noexcept
            : axes_{axes}, mapping_{at}, slopes_{slopes}, facing_{facing}
        {
        }

        [[nodiscard]] surface_point<Wants> operator()(const bevel_vertex& b, const across& here) const noexcept
        {
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes_.position(axes_.foot(b.at), here.z);
            [[maybe_unused]] vec3 normal;
            if constexpr (has(Wants, attribute::normal | attribute::tangent))
                normal = {here.out * b.outward.x, here.out * b.outward.y, here.up};
            if constexpr (has(Wants, attribute::normal)) v.normal = axes_.direction(normal.x, normal.y, normal.z);
            if constexpr (has(Wants, attribute::uv | attribute::tangent)) {
                const wall_place place{placement::exact(b.at), b.along, here.v, b.outward, normal, facing_,
                                       slopes_.is_riser(b)};
                if constexpr (has(Wants, attribute::uv)) v.uv = mapping_.uv(place);
                if constexpr (has(Wants, attribute::tangent)) v.tangent = mapping_.tangent(axes_, place);
            }
            return v;
        }

    private:
        Axes axes_;  // copies: writing vertices cannot alias them
        Mapping mapping_;
        const bevel_slopes& slopes_;
        float facing_;
    };

    /// The triangles of an outward bevel's walls in several segments. The plan has a pair of vertices for each column,
    /// and two triangles for each edge; each of them stands for one triangle per segment.
    template <class Put>
    void outer_wall_triangles(array_view<const bevel_triangle> triangles, std::uint32_t first, Put& put) const noexcept
    {
        const auto lowest = [&](std::uint32_t planned) noexcept {
            const std::uint32_t v = planned - rims_.vertices;
            return first + v / 2 * (segments_ + 1) + v % 2;
        };
        for (std::size_t i = 0; i + 1 < triangles.size(); i += 2)
            for (std::uint32_t k = 0; k < segments_; ++k)
                for (const triangle& t : {triangles[i].corners, triangles[i + 1].corners})
                    put(lowest(t.a) + k, lowest(t.b) + k, lowest(t.c) + k);
    }

    /// The walls of an outward bevel.
    template <attribute Wants, class Axes, class Put>
    void outer_walls(const Axes& axes, const placement& at, Put& put) const noexcept
    {
        if constexpr (has(Wants, attribute::uv | attribute::tangent))
            with_mapping(texture_,
                         [&]<class Mapping>() noexcept { mapped_outer_walls<Wants>(Mapping{at}, axes, at, put); });
        else
            mapped_outer_walls<Wants>(em_mapping{at}, axes, at, put);
    }
    template <attribute Wants, class Mapping, class Axes, class Put>
    void mapped_outer_walls(const Mapping& mapping, const Axes& axes, const placement& at, Put& put) const noexcept
    {
        const double back = heights_.rim(false, rims_.wall), front = heights_.rim(true, rims_.wall);
        const wall_texture walls{at};
        const auto put_at = [&](const bevel_vertex& b, double z) noexcept {
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(b.at), at.height(z));
            if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(b.outward.x, b.outward.y, 0.0f);
            const wall_place place{
                placement::exact(b.at), b.along, walls.v(heights_.high() - z), b.outward, {}, 1.0f, true};
            if constexpr (has(Wants, attribute::uv)) v.uv = mapping.uv(place);
            if constexpr (has(Wants, attribute::tangent)) v.tangent = mapping.tangent(axes, place);
            put(v);
        };
        const auto vertices = solid_.data.of<bevel_vertex>().subspan(rims_.vertices);
        if (segments_ == 1) {
            for (const bevel_vertex& b : vertices) put_at(b, b.share > 0.0f ? front : back);
            return;
        }
        const wall_rows rows{back, front, segments_};
        for (std::size_t i = 0; i + 1 < vertices.size(); i += 2)
            for (std::uint32_t k = 0; k <= segments_; ++k) put_at(vertices[i], rows.height(k));
    }

    [[nodiscard]] bool has_own_cap(bool in_front) const noexcept
    {
        return rims_.has_own_cap(heights_.is_bevelled(in_front));
    }

    const solid_with<bevel_data>& solid_;
    const bevel_rims& rims_;
    bevel_heights heights_;
    texture_mapping texture_;
    bevel_shading shading_;
    std::uint32_t segments_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
