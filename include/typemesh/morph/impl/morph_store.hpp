// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/layout/variation_axis.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// What a point of a morphed outline needs for walls.
struct morph_corner {
    std::uint32_t next = 0;  ///< the point at the end of the edge that begins here
    bool hard = false;       ///< whether the walls on its two sides have normals of their own
};

/// A stretch of the axis in which one glyph keeps its triangles: from key to key.
struct glyph_section {
    std::uint32_t first_key = 0;  ///< among the keys of the glyph
    std::uint32_t last_key = 0;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
};

/// One glyph in a morph_store.
struct morph_glyph {
    glyph_id id = no_glyph;
    std::uint32_t points = 0;
    std::uint32_t hard = 0;  ///< how many of them are hard
    std::uint32_t keys = 0;
    std::size_t first_key = 0;
    std::size_t first_point = 0;   ///< of the first key; `points` for each key
    std::size_t first_corner = 0;  ///< of corners
    std::uint32_t first_section = 0;
    std::uint32_t sections = 0;
    double cells = 512.0;  ///< cells per font unit

    bool overlapping = false;  ///< its contours cross, so that it consists of several solids that overlap
    bool refused = false;      ///< in a part of the axis, or everywhere, it has no section
    bool pinched = false;      ///< at a key, points of its outline meet, so that a triangle has no area there
    double normal_error = 0.0;
    error reason = {};  ///< why it is refused everywhere, if not because its outline crosses itself
};

/// The glyphs of a morph, in arrays that they share.
struct morph_store {
    buffer<morph_glyph> glyphs;
    buffer<axis_coordinate> keys;
    buffer<grid_point> points;  ///< of each glyph: all points at its first key, at its second key, ...
    buffer<vec2> normals;       ///< likewise, two for each point: of the wall that arrives and of the one that leaves
    buffer<morph_corner> corners;  ///< of each glyph: one for each point
    buffer<triangle> triangles;    ///< over the points of a glyph
    buffer<glyph_section> sections;

    explicit morph_store(memory source = heap()) noexcept
        : glyphs{source},
          keys{source},
          points{source},
          normals{source},
          corners{source},
          triangles{source},
          sections{source}
    {
    }

    [[nodiscard]] array_view<const axis_coordinate> keys_of(const morph_glyph& g) const noexcept
    {
        return keys.view().subspan(g.first_key, g.keys);
    }
    [[nodiscard]] array_view<const grid_point> points_of(const morph_glyph& g, std::size_t key) const noexcept
    {
        return points.view().subspan(g.first_point + key * g.points, g.points);
    }
    [[nodiscard]] array_view<const vec2> normals_of(const morph_glyph& g, std::size_t key) const noexcept
    {
        return normals.view().subspan(2 * (g.first_point + key * g.points), 2 * std::size_t{g.points});
    }
    [[nodiscard]] array_view<const morph_corner> corners_of(const morph_glyph& g) const noexcept
    {
        return corners.view().subspan(g.first_corner, g.points);
    }
    [[nodiscard]] array_view<const glyph_section> sections_of(const morph_glyph& g) const noexcept
    {
        return sections.view().subspan(g.first_section, g.sections);
    }
    [[nodiscard]] array_view<const triangle> triangles_of(const glyph_section& s) const noexcept
    {
        return triangles.view().subspan(s.first_triangle, s.triangle_count);
    }

    /// The section of a glyph that contains all coordinates from one to another, or null.
    [[nodiscard]] const glyph_section* section_over(const morph_glyph& g, axis_coordinate from,
                                                    axis_coordinate to) const noexcept
    {
        const auto at = keys_of(g);
        for (const glyph_section& s : sections_of(g))
            if (at[s.first_key] <= from && to <= at[s.last_key]) return &s;
        return nullptr;
    }

    void clear() noexcept
    {
        glyphs.clear();
        keys.clear();
        points.clear();
        normals.clear();
        corners.clear();
        triangles.clear();
        sections.clear();
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
