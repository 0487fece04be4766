// SPDX-License-Identifier: MIT
#pragma once

#include "vec3.hpp"

namespace text_to_mesh {

/// Linear light of an sRGB colour, and back to 0..255 (rounded; values outside are cut).
[[nodiscard]] vec3 to_linear(const unsigned char (&rgb)[3]);
[[nodiscard]] unsigned char to_srgb(double linear);

}  // namespace text_to_mesh
