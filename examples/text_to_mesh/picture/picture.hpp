// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "picture_options.hpp"

#include <vector>

namespace text_to_mesh {

/// What one unit measures on the model's picture at the place that is nearest to the eye, in pixels; 0 for an empty
/// model. A box around a model answers for it well enough, before it is made.
[[nodiscard]] double pixels_per_unit(const model& mesh, const picture_options& options);

/// Draws the model with a software rasteriser: 16 samples per pixel, exact coverage, a depth per sample. No GPU, no
/// clock, no threads: the same model gives the same picture (up to the last bit of the compiler's floating point, which
/// golden images should allow for).
///
/// Gives  w * h * 3 bytes of sRGB, rows from the top; fit for write_png. An empty model gives an empty background.
/// Cost   grows with the pixels covered and the triangles; "Hello world!" at 1280 x 720 takes a fraction of a second.
[[nodiscard]] std::vector<unsigned char> draw(const model& mesh, const overlay& over, const picture_options& options,
                                              int& w, int& h);

}  // namespace text_to_mesh
