// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/extrude/placed_bounds.hpp>
#include <typemesh/glyph/impl/solid_ref.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/text/text_options.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Finds the bounds of all vertices, after the text is placed.
inline void bound(text_glyphs& all, solid_ref how) noexcept
{
    const text_placement& placed = all.placed;
    placement at;
    at.unit_per_depth = placed.unit_per_depth;
    at.frame = placed.frame;
    float bottom = at.height(how.heights().low), top = at.height(how.heights().high);
    const bool along_axes = placed.frame.is_along_axes(), each_has_own = how.has_heights_of_each();
    for (const drawn_glyph& s : all.records) {
        at.frame = placed.frame;
        at.pen = s.built->cells() * (s.origin - placed.centre);
        const bool turns = all.turns(s);
        if (turns) turn(at, s.right);
        at.unit_per_cell = placed.unit_per_font_unit * s.built->font_units_per_cell();
        const box& around = s.built->around();
        if (each_has_own) {
            const height_range own = how.heights_of(*s.built);
            bottom = at.height(own.low);
            top = at.height(own.high);
        }
        if (&s == all.records.begin()) {
            const vec3 corner = at.position(at.foot(around.low), bottom);
            all.bounds = {corner, corner};
        }
        add_placed(all.bounds, around, bottom, top, at, along_axes && !turns);
    }
}

}  // namespace detail

/// Output units per font unit; `ink` matters only for a unit_box.
[[nodiscard]] inline double unit_per_font_unit(const text_options& options, double units_per_em,
                                               const box& ink) noexcept
{
    switch (options.unit) {
    case output_unit::em: return options.size * (1.0 / units_per_em);
    case output_unit::font_units: return options.size;
    case output_unit::pixels: return options.size * (options.pixels_per_em / units_per_em);
    case output_unit::unit_box: break;
    }
    const double longer = ink.width() > ink.height() ? ink.width() : ink.height();
    return options.size * (longer > 0.0 ? 2.0 / longer : 1.0);
}

/// Computes the data of a text that need all its glyphs: the bounding boxes of its ink and of its lines, its unit, and
/// the bounds of its vertices.
///
/// Fails  error::out_of_memory
inline error arrange(text_glyphs& all, const glyph_run& run, const text_options& options, double units_per_em,
                     solid_ref how) noexcept
{
    const bool by_line = options.texture_over == texture_box::line;
    if (by_line) {
        const std::size_t lines = run.lines.empty() ? 1 : run.lines.size();
        box* boxes = all.line_boxes.append(lines);
        if (boxes == nullptr) return error::out_of_memory;
        for (std::size_t i = 0; i < lines; ++i) boxes[i] = {};
    }
    const bool has_own = all.in_place || all.turned;  // boxes that textures span
    for (const drawn_glyph& s : all.records) {
        const box ink = text_glyphs::ink_of(s);
        all.ink.merge(ink);
        if (has_own) all.textured.merge(text_glyphs::textured_of(s));
        if (by_line) all.line_boxes[s.line].merge(has_own ? text_glyphs::textured_of(s) : ink);
    }

    if (!has_own) all.textured = all.ink;

    text_placement& placed = all.placed;
    placed = {};
    placed.units_per_em = units_per_em;
    placed.em_per_font_unit = 1.0 / units_per_em;
    placed.texture_over = options.texture_over;
    placed.frame = options.frame;
    placed.unit_per_font_unit = unit_per_font_unit(options, units_per_em, all.ink);
    if (options.unit == output_unit::unit_box && !all.ink.empty()) placed.centre = lerp(all.ink.low, all.ink.high, 0.5);
    placed.unit_per_em = placed.unit_per_font_unit * units_per_em;
    placed.unit_per_depth = options.depth_in == depth_unit::output ? 1.0 : placed.unit_per_em;
    placed.em_per_depth = options.depth_in == depth_unit::output ? 1.0 / placed.unit_per_em : 1.0;
    placed.texture_per_font_unit = text_glyphs::texture_over(all.textured);

    detail::bound(all, how);
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
