// SPDX-License-Identifier: MIT
#pragma once

#include "camera.hpp"
#include "flat_triangle.hpp"
#include "model.hpp"
#include "picture_options.hpp"
#include "studio.hpp"
#include "vec3.hpp"

#include <cstddef>
#include <vector>

namespace text_to_mesh {

/// What the model's triangles look like: their colours, their texture, and the studio's light on them.
class surface {
public:
    surface(const model& mesh, const picture_options& options, const camera& from);

    /// The colour of a triangle at a place in the picture (x, y in steps), which stands for the samples `mask` of the
    /// pixel (px, py).
    [[nodiscard]] vec3 shade(const flat_triangle& t, double x, double y, int px, int py, unsigned mask) const;

private:
    [[nodiscard]] const model_vertex& corner(const flat_triangle& t, std::size_t i) const
    {
        return mesh_.vertices[mesh_.indices[t.first + i]];
    }
    [[nodiscard]] light light_on(vec3 normal) const { return studio_light(normal, from_.in_camera_axes(normal)); }
    /// How much of these samples lies in dark squares.
    [[nodiscard]] double checker(const flat_triangle& t, int px, int py, unsigned mask) const;

    const model& mesh_;
    const picture_options& options_;
    const camera& from_;
    std::vector<vec3> colours_;  ///< of the parts
};

}  // namespace text_to_mesh
