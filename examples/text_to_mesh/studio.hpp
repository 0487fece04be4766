// SPDX-License-Identifier: MIT
#pragma once

#include "camera.hpp"
#include "model.hpp"
#include "vec3.hpp"

#include <vector>

namespace text_to_mesh {

/// What the lamps of the studio do to a surface of one orientation: diffuse light to multiply a colour with, gloss to
/// add.
struct light {
    vec3 diffuse;
    vec3 gloss;
};

/// The light on a surface whose unit normal is `n` in the model's axes and `seen` in the camera's.
///
/// A large key lamp above the front, a weaker one on each side, sky above and floor below stand around the model; gloss
/// mirrors soft boxes that go with the camera. Lamps and eye are taken as infinitely far away, so that a flat wall has
/// one colour.
[[nodiscard]] light studio_light(vec3 n, vec3 seen);

/// The colour behind everything, for a height of 0 (top) to 1 (bottom).
[[nodiscard]] vec3 studio_backdrop(double height);

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

/// Linear light of an sRGB colour, and back to 0..255 (rounded; values outside are cut).
[[nodiscard]] vec3 to_linear(const unsigned char (&rgb)[3]);
[[nodiscard]] unsigned char to_srgb(double linear);

}  // namespace text_to_mesh
