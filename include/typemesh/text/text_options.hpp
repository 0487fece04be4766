// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/vertex/frame.hpp>

#include <cstdint>
#include <optional>

namespace typemesh::inline TYPEMESH_ABI {

/// The unit of positions, before text_options::size multiplies them. It applies to x and y, and also to z unless
/// text_options::depth_in says otherwise.
enum class output_unit : std::uint8_t {
    em,          ///< an em is 1, so `size` is the size of an em
    font_units,  ///< the font's own units, units_per_em per em
    pixels,      ///< pixels: an em is text_options::pixels_per_em of them
    unit_box,    ///< the text's box is scaled to fit [-1, 1]: its longer side spans the interval, and its centre is at
                 ///< 0
};

/// The unit of an extruder's depths.
enum class depth_unit : std::uint8_t {
    em,      ///< em: depth scales with the size of the letters
    output,  ///< output units, for any unit and size of x and y: a depth of 1 ends at z = -1
};

/// The area that the square [0, 1] of the `box` texture mapping covers: the whole text, each line, or each glyph.
enum class texture_box : std::uint8_t { text, line, glyph };

/// The options of a text: how it is set and written. All defaults suit a headline in a 3D scene.
///
///     {.size = 0.37}                               letters of 0.37 units of your world per em
///     {.layout = {.align = alignment::centre}}     lines centred on x = 0
///     {.unit = output_unit::unit_box,              a box of [-1, 1], and the back of extruded<>{.depth = 1.0f} at
///      .depth_in = depth_unit::output}             z = -1
///
/// Tolerance is given in em, and so is depth unless depth_in says otherwise. Both scale with the size; vertices and
/// triangles stay the same. plan() fails with error::bad_option if 32-bit floats cannot hold the result, that is, if an
/// em is below 2^-100 output units, or if a depth or size makes coordinates greater than 3.4e38. Letters that are too
/// far away are left out and reported.
struct text_options {
    shape_options shape = {};    ///< direction, language, features, letter spacing, styles
    layout_options layout = {};  ///< alignment, spacing of lines, tab stops

    double tolerance = quality::high;    ///< the largest distance between curve and mesh, in em; see quality.hpp
    std::optional<fill_rule> fill = {};  ///< replaces the outline source's own rule

    /// The greatest number of pieces into which crossings may divide the edges of a glyph, or of a group of merged
    /// glyphs. A glyph with more pieces is left out and reported: error::too_many_pieces. This limits memory; a hostile
    /// glyph may still take ten seconds.
    std::uint32_t max_pieces = default_max_pieces;

    /// A glyph with more curves than this, or with curves that need more points at the given tolerance, is left out and
    /// reported: error::too_many_points. This limits the memory that a font can use: 0.3 kB per point, 1.5 kB with
    /// bevels.
    std::uint32_t max_points = default_max_points;

    output_unit unit = output_unit::em;
    double size = 1.0;            ///< multiplies the unit: the size of an em in your world
    double pixels_per_em = 64.0;  ///< the size of an em, used only with output_unit::pixels
    depth_unit depth_in = depth_unit::em;
    texture_box texture_over = texture_box::text;  ///< the area that the `box` texture mapping covers; see texture.hpp
    typemesh::frame frame = right_handed_y_up;

    /// Whether glyphs whose outlines meet are merged into one solid without inner walls: kerned, cursive or accented
    /// glyphs. Emboldened glyphs, and glyphs with outward bevels, are merged where they meet after they have grown.
    bool merge = false;

    /// The treatment of corners at which a letter touches itself. With touching::part or join, the mesh is a manifold:
    /// every edge has two faces, and the surface around every point is a disc. Programs that compute with solids
    /// require this (OpenSCAD, CGAL). Upright sections of bevels then lean by a few cells, and solids without walls may
    /// get low ones; if their `side` is false, they are counted as touching instead. The grid is then so coarse that
    /// floats distinguish neighbouring cells at every letter, up to 16,000 em from the origin, or 2,000 em if the
    /// frame's axes are slanted. For letters that touch each other, also set `merge`. The report counts the treated
    /// corners. All consequences and limits: docs/guarantees.md, "Corners that touch".
    touching corners = touching::keep;

    /// Whether a repeated glyph is built only once. If false, every occurrence is built again, with an identical mesh:
    /// for measurements.
    bool reuse = true;

    /// Whether the font's .notdef (usually a box) is drawn for missing glyphs; they are reported in either case.
    bool draw_missing = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
