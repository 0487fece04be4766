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
    std::vector<typemesh::variation> variations;  ///< that make a variable font the style asked for
};

/// Finds what --font names: a file, or an installed family with a style, as fontconfig writes it ("DejaVu Sans",
/// "DejaVu Sans:bold"). What looks like a path, or is a file, is one. No other family stands in for one that is not
/// installed.
///
/// Gives  an empty string, or one sentence for the user
[[nodiscard]] std::string find_font(const std::string& name, font_file& out);

}  // namespace text_to_mesh
