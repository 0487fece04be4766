// SPDX-License-Identifier: MIT
#pragma once

#include "camera.hpp"
#include "model.hpp"
#include "picture_options.hpp"

#include <cmath>

namespace text_to_mesh {

/// From where a picture shows a model, and how many pixels it has.
struct view {
    camera from;
    int width = 0, height = 0;
};

/// The view that takes in all of the model and of what is drawn over it, as near as the options allow.
[[nodiscard]] view view_of(const model& mesh, const overlay& over, const picture_options& options);

/// True where all of the model lies in one plane z.
[[nodiscard]] bool is_flat(const model& mesh);

/// visit(vec3) for every finite point: the triangles' corners, then the ends of lines, then dots.
template <class Visit>
void each_point(const model& mesh, const overlay& over, Visit&& visit)
{
    const auto visit_finite = [&](const float(&p)[3]) {
        if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) visit(to_vec3(p));
    };
    for (const std::uint32_t i : mesh.indices) visit_finite(mesh.vertices[i].position);
    for (const overlay::segment& s : over.segments) {
        visit_finite(s.a);
        visit_finite(s.b);
    }
    for (const overlay::dot& d : over.dots) visit_finite(d.p);
}

}  // namespace text_to_mesh
