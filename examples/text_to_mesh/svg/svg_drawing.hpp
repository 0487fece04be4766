// SPDX-License-Identifier: MIT
#pragma once

#include "../model.hpp"

#include <typemesh/core/box.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/outline.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace text_to_mesh {

/// What a file of SVG draws, in a square of 1000 units, y up: the larger side of its view box is 1000, and the lower
/// left corner is at 0, 0.
struct svg_drawing {
    static constexpr double units_per_em = 1000.0;
    static constexpr std::size_t no_clip = ~std::size_t{0};

    /// A shape of a clip.
    struct clip_shape {
        std::size_t shape;
        std::size_t within = no_clip;  ///< what cuts this shape, beside the clip that the whole clip is inside of
    };
    /// Where something is drawn: within any of some shapes, and within another clip.
    struct clip {
        std::vector<clip_shape> shapes;
        std::size_t inside = no_clip;
    };
    /// A shape in a colour.
    struct item {
        std::size_t shape;
        std::size_t within;  ///< a clip, or no_clip
        rgb_colour colour;
    };

    std::vector<typemesh::outline> shapes;  ///< each with its fill rule
    std::vector<clip> clips;                ///< each after those that it names
    std::vector<item> items;                ///< from the lowest to the uppermost
    typemesh::box view;                     ///< nothing is drawn outside of it; empty: there is no limit
    std::vector<std::string> warnings;      ///< what is not drawn as it should be, each kind once
};

/// How a file is read.
struct svg_options {
    double tolerance = 0.1;                                 ///< of arcs and of strokes, in the drawing's units
    rgb_colour colour{{0, 0, 0}};                           ///< of what is drawn in currentColor
    std::size_t max_curves = typemesh::default_max_pieces;  ///< of all shapes together; more cannot be cut
    std::size_t max_steps = 500'000'000;                    ///< of work, about a byte that is read each
};

/// Parses the text of a file of SVG. Gives an empty string, or the end of a sentence that begins with the file's name.
[[nodiscard]] std::string read_svg_text(const std::string& text, const svg_options& how, svg_drawing& out);

/// Reads a file of SVG; "-" is standard input. Gives an empty string, or one sentence.
[[nodiscard]] std::string read_svg(const std::string& path, const svg_options& how, svg_drawing& out);

}  // namespace text_to_mesh
