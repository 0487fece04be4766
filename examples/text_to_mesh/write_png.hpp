// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace text_to_mesh {

/// Writes a PNG of 8 bits a channel. `rgb` holds width * height * 3 bytes, rows from the top, as draw() gives them.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_png(std::span<const unsigned char> rgb, int width, int height, const std::string& path,
                                    file_set& files);

/// The bytes of a PNG whose pixels have alpha, 4 bytes each; empty if there are none or no memory.
[[nodiscard]] std::vector<unsigned char> png_with_alpha(std::span<const unsigned char> rgba, int width, int height);

}  // namespace text_to_mesh
