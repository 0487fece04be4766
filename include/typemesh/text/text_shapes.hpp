// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/text/glyph_set.hpp>
#include <typemesh/text/glyph_shape.hpp>
#include <typemesh/text/pinned_shapes.hpp>
#include <typemesh/text/shape_store.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_report.hpp>

#include <cstddef>
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

/// One glyph of the mesh: who it is, what it looks like and where it stands.
struct shape_record {
    const glyph_shape* shape = nullptr;
    point origin;  ///< font units
    glyph_id id = no_glyph;
    cluster_id cluster = no_cluster;
    std::uint32_t line = 0;
    part_sizes before = {};  ///< the counts of all glyphs before it
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

/// By what a plan knows whether shapes that lie elsewhere are still there: a number that another plan changes.
struct lent_shapes {
    const std::uint64_t* now = nullptr;  ///< null: nothing lies elsewhere
    std::uint64_t then = 0;

    [[nodiscard]] bool are_there() const noexcept { return now == nullptr || *now == then; }
};

/// All of one text: its different glyphs, each meshed once, and its glyphs, each at its place. What a plan measured and
/// write() reads.
struct text_shapes {
    glyph_set different;                 ///< the glyphs that the text asks for
    pinned_shapes shapes;                ///< theirs, blank and refused ones included
    buffer<std::uint32_t> numbers;       ///< for each glyph of the run, which of them it is
    shape_store store;                   ///< where shapes lie that no cache keeps, and no glyph_team
    lent_shapes lent;                    ///< those that a glyph_team keeps
    buffer<shape_record> records;        ///< what is drawn
    buffer<box> line_boxes;              ///< in font units; filled for texture_box::line alone
    box ink;                             ///< around all records, font units
    part_sizes totals;
    text_placement placed;
    text_report report;
    bounds3 bounds;
    shapes_generation generation;

    explicit text_shapes(memory source) noexcept
        : different{source}, shapes{source}, numbers{source}, store{source}, records{source}, line_boxes{source}
    {
    }

    void clear() noexcept
    {
        different.clear();
        shapes.clear();
        numbers.clear();
        store.clear();
        lent = {};
        records.clear();
        line_boxes.clear();
        ink = {};
        totals = {};
        report = {};
        bounds = {};
        ++generation.number;
    }

    /// Puts a shape that is neither blank nor refused at its place, `s.before` apart, which is found here.
    /// Fails with error::too_large where 32 bits do not suffice, or error::out_of_memory; then all is as it was.
    error place_shape(shape_record s) noexcept
    {
        const part_sizes& sizes = s.shape->sizes();
        s.before = totals;
        part_sizes sum = totals;
        std::uint64_t vertices = 0, triangles = 0;
        for (const part p : all_parts) {
            vertices += std::uint64_t{totals.vertices[p]} + sizes.vertices[p];
            triangles += std::uint64_t{totals.triangles[p]} + sizes.triangles[p];
            sum.vertices[p] += sizes.vertices[p];
            sum.triangles[p] += sizes.triangles[p];
        }
        constexpr std::uint64_t most = 0xFFFF'FFFFu;
        if (vertices > most || 3 * triangles > most) return error::too_large;
        if (!records.push_back(s)) return error::out_of_memory;
        totals = sum;
        return {};
    }

    /// A glyph's own box, in font units, seen from the text's origin.
    [[nodiscard]] static box ink_of(const shape_record& s) noexcept
    {
        return {s.origin + s.shape->ink().low, s.origin + s.shape->ink().high};
    }

    [[nodiscard]] placement place(const shape_record& s) const noexcept
    {
        const box over = placed.texture_over == texture_box::text   ? ink
                         : placed.texture_over == texture_box::line ? line_boxes[s.line]
                                                                    : ink_of(s);
        const double cells = s.shape->cells();
        placement at;
        at.pen = cells * (s.origin - placed.centre);
        at.unit_per_cell = placed.unit_per_font_unit / cells;
        at.unit_per_em = placed.unit_per_font_unit * placed.units_per_em;
        at.em_per_cell = 1.0 / (cells * placed.units_per_em);
        at.em_pen = cells * s.origin;
        at.texture_pen = cells * (s.origin - over.low);
        at.texture_per_cell = {over.width() > 0.0 ? 1.0 / (cells * over.width()) : 0.0,
                               over.height() > 0.0 ? 1.0 / (cells * over.height()) : 0.0};
        at.frame = placed.frame;
        return at;
    }
};

}  // namespace typemesh
