// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/plate/impl/rim_offset.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The strips of a solid's bevels and fillets, kept for writing. A sheet is all strips along one outline.
///
///     section      t = 0, the height `from`            t = 1, the height `to`
///     chamfer      the outline, at the wall's end      its inner offset, at the cap
///     round        likewise
///     fillet       its outer offset, on the floor      the outline, at the wall's end
///
/// The normals of a section are the circle's own; a chamfer has the normals of its slope.
class rim_sheets {
public:
    struct sheet {
        std::uint32_t of = 0;  ///< the number of its part
        rim_section section = rim_section::chamfer;
        bool up = true;  ///< whether it faces the reader
        float from = 0.0f, to = 0.0f;
        std::uint32_t first_vertex = 0, vertex_count = 0, first_triangle = 0, triangle_count = 0;
    };
    /// A vertex for writing.
    struct vertex {
        grid_point at;
        vec2 outward;   ///< unit vector
        float t, h;     ///< its place in the section: both from 0 to 1
        float out, up;  ///< the normal: along `outward`, and away from the solid's middle
    };

    explicit rim_sheets(memory source = heap()) noexcept : sheets_{source}, vertices_{source}, triangles_{source} {}

    void clear() noexcept
    {
        sheets_.clear();
        vertices_.clear();
        triangles_.clear();
    }

    /// Keeps the strips of an offset. `how` has the part, the section, the side and the heights.
    ///
    /// Fails  error::too_large, error::out_of_memory
    [[nodiscard]] error add(rim_offset& made, sheet how) noexcept
    {
        const auto vertices = made.strip_vertices();
        const auto triangles = made.strip_triangles();
        constexpr std::size_t max_count = 0xFFFF'FFFFu;
        if (vertices_.size() + vertices.size() > max_count || triangles_.size() + triangles.size() > max_count)
            return error::too_large;
        how.first_vertex = static_cast<std::uint32_t>(vertices_.size());
        how.vertex_count = static_cast<std::uint32_t>(vertices.size());
        how.first_triangle = static_cast<std::uint32_t>(triangles_.size());
        how.triangle_count = static_cast<std::uint32_t>(triangles.size());
        if (!vertices_.reserve(vertices_.size() + vertices.size()) ||
            !triangles_.reserve(triangles_.size() + triangles.size()) || !sheets_.push_back(how))
            return error::out_of_memory;
        const auto strips = made.strips();
        double begin[2 * profile_points::most] = {}, width = 0.0;
        for (std::size_t i = 0; i < strips.size(); ++i) {
            begin[i] = width;
            width += as_double(strips[i].run);
        }
        for (const bevel_vertex& v : vertices) {
            const double t = (begin[v.strip] + as_double(v.share) * as_double(strips[v.strip].run)) / width;
            vertices_.push_back_unchecked(placed(v, how.section, t, height_of(v, strips)));
        }
        for (const bevel_triangle& t : triangles) triangles_.push_back_unchecked(t.corners);
        return {};
    }

    [[nodiscard]] array_view<const sheet> all() const noexcept { return sheets_.view(); }
    [[nodiscard]] array_view<const vertex> vertices(const sheet& s) const noexcept
    {
        return vertices_.view().subspan(s.first_vertex, s.vertex_count);
    }
    [[nodiscard]] array_view<const triangle> triangles(const sheet& s) const noexcept
    {
        return triangles_.view().subspan(s.first_triangle, s.triangle_count);
    }

    /// The height of a vertex; at both ends of the section the sheet's own, to the bit.
    [[nodiscard]] static float height(const sheet& s, const vertex& v) noexcept
    {
        if (!(v.h > 0.0f)) return s.from;
        if (!(v.h < 1.0f)) return s.to;
        const auto risen = static_cast<float>(as_double(v.h) * (as_double(s.to) - as_double(s.from)));
        return static_cast<float>(as_double(s.from) + as_double(risen));
    }

    /// The volume between a sheet and the height `from`, as if its section were 1 high, in cells.
    [[nodiscard]] double volume(const sheet& s) const noexcept
    {
        double sum = 0.0;
        const auto all = vertices(s);
        for (const triangle& t : triangles(s)) {
            const vertex &a = all[t.a], &b = all[t.b], &c = all[t.c];
            sum +=
                static_cast<double>(orientation(a.at, b.at, c.at)) * (as_double(a.h) + as_double(b.h) + as_double(c.h));
        }
        return sum / 6.0;
    }

private:
    [[nodiscard]] static vertex placed(const bevel_vertex& v, rim_section section, double t, float h) noexcept
    {
        double out = 1.0, up = 1.0;
        if (section == rim_section::round) {
            out = 1.0 - t;
            up = as_double(h);
        } else if (section == rim_section::fillet) {
            out = t;
            up = 1.0 - as_double(h);
        }
        const double length = std::sqrt(out * out + up * up);
        return {v.at,
                v.outward,
                static_cast<float>(t),
                h,
                static_cast<float>(out / length),
                static_cast<float>(up / length)};
    }

    buffer<sheet> sheets_;
    buffer<vertex> vertices_;
    buffer<triangle> triangles_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
