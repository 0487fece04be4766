// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace text_to_mesh {

/// Tubes along the outline, as tubed.hpp has them.
struct chosen_tube {
    float radius = 0.0f;  ///< em; 0: none
    unsigned sides = 16;
};

/// "0.02" or "0.02,24". Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_tube(std::string_view written, chosen_tube& out);

}  // namespace text_to_mesh
