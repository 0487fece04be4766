// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "vec3.hpp"

#include <vector>

namespace text_to_mesh {

/// The soft shadow that a solid throws on the floor it stands on, under a wide lamp above.
///
/// The solid's outline from above is drawn on a map of the floor, fainter where it is higher, and blurred twice: little
/// for the contact, much for the room. Softness follows the solid's depth.
class floor_shadow {
public:
    floor_shadow() = default;
    explicit floor_shadow(const model& mesh);

    /// 1 in full light, less in the shadow, where the ray from `eye` meets the floor.
    [[nodiscard]] double light_along(vec3 eye, vec3 ray) const;

private:
    int columns_ = 0, rows_ = 0;
    double cell_ = 1.0, left_ = 0.0, back_ = 0.0, floor_ = 0.0;
    std::vector<float> shade_;
};

}  // namespace text_to_mesh
