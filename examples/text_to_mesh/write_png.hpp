// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"

#include <span>
#include <string>

namespace text_to_mesh {

/// Writes a PNG of 8 bits a channel. `rgb` holds width * height * 3 bytes, rows from the top, as draw() gives them.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_png(std::span<const unsigned char> rgb, int width, int height, const std::string& path,
                                    file_set& files);

}  // namespace text_to_mesh
