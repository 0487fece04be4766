// SPDX-License-Identifier: MIT
#pragma once

#include "vec3.hpp"

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

}  // namespace text_to_mesh
