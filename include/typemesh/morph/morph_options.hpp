// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/discretise/quality.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/vertex/frame.hpp>

#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// The options of axis_morph.
///
///     {.from = 100, .to = 900, .depth = 0.1f}     that part of the axis; letters a tenth of an em deep
struct morph_options {
    double from = -std::numeric_limits<double>::infinity();  ///< where the morph begins, in the axis's own unit; values
                                                             ///< beyond the axis mean its end
    double to = std::numeric_limits<double>::infinity();     ///< where it ends, above `from`

    double tolerance =
        quality::high;             ///< the largest distance between curve and mesh at every place of the axis, in em
    double size = 1.0;             ///< the size of an em in your world
    float depth = 0.2f;            ///< in em, not negative; 0: flat letters, only the front
    float crease_degrees = 15.0f;  ///< as in curve_normals: where curves meet at a larger angle, at any place, the
                                   ///< edge of the wall is hard
    typemesh::frame frame = right_handed_y_up;

    shape_options shape = {};    ///< how the text is shaped
    layout_options layout = {};  ///< how its lines are placed
};

/// What has become of the letters of a morph: how many of its drawn glyphs, repeated glyphs each time. Where the font
/// replaces glyphs along the axis, each number comes from the stretch with the most.
struct morph_report {
    std::uint32_t letters = 0;  ///< all glyphs that are not blank
    std::uint32_t split = 0;    ///< glyphs that need different triangles in different parts of the axis
    std::uint32_t overlapping =
        0;                      ///< glyphs whose contours cross: a closed solid for each outer contour or each piece
                                ///< of one that crosses itself; the solids overlap
    std::uint32_t refused = 0;  ///< glyphs that are not drawn, in a part of the axis or everywhere, because no
                                ///< triangles were found
    std::uint32_t pinched = 0;  ///< glyphs that have a triangle without area at a key, where points of the outline
                                ///< meet
    std::uint32_t missing = 0;  ///< characters that the font lacks
    double normal_error = 0.0;  ///< the greatest angle, in radians, by which the normal of a wall between two keys
                                ///< may differ from its curve's, over all glyphs; it occurs at single points
};

}  // namespace typemesh::inline TYPEMESH_ABI
