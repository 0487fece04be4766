// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace text_to_mesh {

/// What --morph requests: a part of an axis; empty: no morph.
struct chosen_morph {
    std::string axis;
    double from = 0.0, to = 0.0;
};

/// "wght=100..900". Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_morph(std::string_view written, chosen_morph& out);

}  // namespace text_to_mesh
