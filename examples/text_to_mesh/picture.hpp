// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "part_colours.hpp"

#include <optional>
#include <vector>

namespace text_to_mesh {

enum class shading {
    flat,     ///< one colour a triangle, from its own plane
    gouraud,  ///< lit at the vertices, the light spread over the triangle
    phong,    ///< lit at every pixel with the spread normal
};

enum class texture {
    none,
    checker,  ///< squares of the texture coordinates
};

enum class background {
    studio,  ///< a light gradient; a solid stands on a floor and throws a soft shadow
    white,   ///< nothing but white
};

struct picture_options {
    int width = 0;   ///< in pixels; 0 is 1280, or less for a tall text; at most 8192
    int height = 0;  ///< in pixels; 0 is what the text asks for, between 360 and 960
    text_to_mesh::shading shading = shading::phong;
    text_to_mesh::texture texture = texture::none;
    text_to_mesh::background background = background::studio;
    bool wireframe = false;      ///< the edges of the triangles that are in sight
    /// Degrees the eye is moved to the right; by default -26 (less for a long line), 0 if flat.
    std::optional<float> yaw;
    std::optional<float> pitch;  ///< degrees the eye is raised; by default 12 (less for a long line), 0 if flat
    float line_px = 1.25F;       ///< width of the wireframe's lines; the overlay's are half as wide again
    float checks = 8.0F;         ///< squares to one unit of the texture coordinates
    float margin = 0.06F;        ///< free border, of the picture's longer side
};

/// What one unit measures on the model's picture at the place that is nearest to the eye, in pixels; 0 for an empty
/// model. A box around a model answers for it well enough, before it is made.
[[nodiscard]] double pixels_per_unit(const model& mesh, const picture_options& options);

/// Draws the model with a software rasteriser: 16 samples a pixel, exact coverage, a depth for every sample. No GPU, no
/// clock, no threads: the same model gives the same picture (up to the last bit of the compiler's floating point, which
/// golden images should allow for).
///
/// Gives  w * h * 3 bytes of sRGB, rows from the top; fit for write_png. An empty model gives an empty background.
/// Cost   grows with the pixels covered and the triangles; "Hello world!" at 1280 x 720 takes a fraction of a second.
[[nodiscard]] std::vector<unsigned char> draw(const model& mesh, const overlay& over, const picture_options& options,
                                              int& w, int& h);

}  // namespace text_to_mesh
