// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_report.hpp>

#include <cstdint>

namespace typemesh {

/// The box around all vertices, in the caller's frame and unit. Both corners zero for an empty mesh.
struct bounds3 {
    vec3 low;
    vec3 high;

    constexpr void add(vec3 p) noexcept
    {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
    }
};

/// One glyph of the mesh: who it is, where it stands, and which stretches of text_shapes are its own.
struct shape_record {
    glyph_id id = no_glyph;
    cluster_id cluster = no_cluster;
    std::uint32_t line = 0;
    point origin;                  ///< font units
    double cells = 512.0;          ///< its grid's cells a font unit
    grid_point low, high;          ///< the box around its points, in cells
    std::uint32_t first_point = 0, point_count = 0;
    std::uint32_t first_start = 0, start_count = 0;
    std::uint32_t first_triangle = 0, triangle_count = 0;
    std::uint32_t first_side = 0, side_count = 0;
    part_sizes sizes;              ///< its own counts
    part_sizes before;             ///< the counts of all glyphs before it
};

/// How placements are made: the same for all glyphs of a text.
struct text_placement {
    double units_per_em = 1000.0;
    double unit_per_font_unit = 1.0;  ///< output units a font unit
    point centre;                     ///< what is moved to the output's origin, font units
    texture_box texture_over = texture_box::text;
    typemesh::frame frame;
};

/// By what a plan knows whether its shapes are still those that it was made of: another number after every clear() and
/// every move, out of them or into them.
struct shapes_generation {
    std::uint64_t number = 0;

    shapes_generation() noexcept = default;
    shapes_generation(shapes_generation&& other) noexcept : number{other.number++} {}
    shapes_generation& operator=(shapes_generation&& other) noexcept
    {
        number += ++other.number;
        return *this;
    }
};

/// All shapes of one text in a few growing arrays: what a plan measured and write() reads.
struct text_shapes {
    buffer<grid_point> points;
    buffer<std::uint32_t> starts;
    triangle_list triangles;
    buffer<side_point> sides;
    buffer<shape_record> records;
    buffer<box> line_boxes;  ///< in font units; filled for texture_box::line alone
    box ink;                 ///< around all shapes, font units
    part_sizes totals;
    text_placement placed;
    text_report report;
    bounds3 bounds;
    shapes_generation generation;

    explicit text_shapes(memory source) noexcept
        : points{source}, starts{source}, triangles{source}, sides{source}, records{source}, line_boxes{source}
    {
    }

    void clear() noexcept
    {
        points.clear();
        starts.clear();
        triangles.clear();
        sides.clear();
        records.clear();
        line_boxes.clear();
        ink = {};
        totals = {};
        report = {};
        bounds = {};
        ++generation.number;
    }

    /// Keeps a region whose triangles and sides have been appended already, from s.first_triangle and s.first_side on.
    /// Fails with error::too_large where 32 bits do not suffice, or error::out_of_memory; then all else is as it was.
    error keep(shape_record s, const region& r, const part_sizes& sizes) noexcept
    {
        s.first_point = static_cast<std::uint32_t>(points.size());
        s.first_start = static_cast<std::uint32_t>(starts.size());
        s.point_count = static_cast<std::uint32_t>(r.points().size());
        s.start_count = static_cast<std::uint32_t>(r.starts().size());
        s.triangle_count = static_cast<std::uint32_t>(triangles.size() - s.first_triangle);
        s.side_count = static_cast<std::uint32_t>(sides.size() - s.first_side);
        s.cells = r.grid().cells;
        s.low = s.high = r.points().front();
        for (const grid_point p : r.points()) {
            s.low = {p.x < s.low.x ? p.x : s.low.x, p.y < s.low.y ? p.y : s.low.y};
            s.high = {p.x > s.high.x ? p.x : s.high.x, p.y > s.high.y ? p.y : s.high.y};
        }
        s.sizes = sizes;
        s.before = totals;
        std::uint64_t vertices = 0, triangle_sum = 0;
        for (const part p : all_parts) {
            vertices += std::uint64_t{totals.vertices[p]} + sizes.vertices[p];
            triangle_sum += std::uint64_t{totals.triangles[p]} + sizes.triangles[p];
        }
        constexpr std::uint64_t most = 0xFFFF'FFFFu;
        if (vertices > most || 3 * triangle_sum > most || points.size() + s.point_count > most) return error::too_large;
        if (!points.append(r.points()) || !starts.append(r.starts()) || !records.push_back(s)) {
            points.truncate(s.first_point);
            starts.truncate(s.first_start);
            return error::out_of_memory;
        }
        for (const part p : all_parts) {
            totals.vertices[p] += sizes.vertices[p];
            totals.triangles[p] += sizes.triangles[p];
        }
        return {};
    }

    [[nodiscard]] solid solid_of(const shape_record& s) const noexcept
    {
        return {points.view().subspan(s.first_point, s.point_count),
                starts.view().subspan(s.first_start, s.start_count),
                triangles.view().subspan(s.first_triangle, s.triangle_count),
                sides.view().subspan(s.first_side, s.side_count)};
    }

    /// A shape's own box, in font units, seen from the text's origin.
    [[nodiscard]] static box ink_of(const shape_record& s) noexcept
    {
        const grid g{s.cells};
        return {s.origin + g.place(s.low), s.origin + g.place(s.high)};
    }

    [[nodiscard]] placement place(const shape_record& s) const noexcept
    {
        const box over = placed.texture_over == texture_box::text   ? ink
                         : placed.texture_over == texture_box::line ? line_boxes[s.line]
                                                                    : ink_of(s);
        placement at;
        at.pen = s.cells * (s.origin - placed.centre);
        at.unit_per_cell = placed.unit_per_font_unit / s.cells;
        at.unit_per_em = placed.unit_per_font_unit * placed.units_per_em;
        at.em_per_cell = 1.0 / (s.cells * placed.units_per_em);
        at.em_pen = s.cells * s.origin;
        at.texture_pen = s.cells * (s.origin - over.low);
        at.texture_per_cell = {over.width() > 0.0 ? 1.0 / (s.cells * over.width()) : 0.0,
                               over.height() > 0.0 ? 1.0 / (s.cells * over.height()) : 0.0};
        at.frame = placed.frame;
        at.glyph = s.id;
        at.cluster = s.cluster;
        return at;
    }
};

}  // namespace typemesh
