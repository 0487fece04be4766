// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>

#include <string>
#include <vector>

namespace text_to_mesh {

/// Where a font lies.
struct font_file {
    std::string path;
    unsigned face = 0;                            ///< in a collection
    std::vector<typemesh::variation> variations;  ///< that give a variable font the requested style
};

/// Whether a name looks like a file's, or there is such a file.
[[nodiscard]] bool is_a_file(const std::string& name);

/// Finds what --font names: a file, or an installed family with a style, as fontconfig writes it ("DejaVu Sans",
/// "DejaVu Sans:bold", "DejaVu Sans:Bold Oblique"). For one that is not installed only those stand in that the system's
/// configuration sets beside it, as Liberation Sans for Arial, and what it has for "sans-serif" and the like.
///
/// Gives  an empty string, or one sentence for the user
[[nodiscard]] std::string find_font(const std::string& name, font_file& out);

}  // namespace text_to_mesh
