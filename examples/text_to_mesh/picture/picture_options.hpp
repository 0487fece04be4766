// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace text_to_mesh {

enum class shading {
    flat,     ///< one colour per triangle, from its own plane
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
    int height = 0;  ///< in pixels; 0 is what suits the text, between 360 and 960
    text_to_mesh::shading shading = shading::phong;
    text_to_mesh::texture texture = texture::none;
    text_to_mesh::background background = background::studio;
    bool wireframe = false;  ///< the edges of the triangles that are in sight
    /// Degrees the eye is moved to the right; by default -26 (less for a long line), 0 if flat.
    std::optional<float> yaw;
    std::optional<float> pitch;  ///< degrees the eye is raised; by default 12 (less for a long line), 0 if flat
    float line_px = 1.25F;       ///< width of the wireframe's lines; the overlay's are half as wide again
    float checks = 8.0F;         ///< squares per unit of the texture coordinates
    float margin = 0.06F;        ///< free border, of the picture's longer side
};

}  // namespace text_to_mesh
