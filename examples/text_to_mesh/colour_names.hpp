// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace text_to_mesh {

/// "red", "#2060c0". Nothing where it is neither.
[[nodiscard]] std::optional<rgb_colour> read_colour(std::string_view written);

/// A name for each colour, and the same for equal ones: "red", "2060c0". It has letters and digits only.
[[nodiscard]] std::string name_of(const rgb_colour& colour);

/// "#2060c0, or black, white, ..."
[[nodiscard]] std::string colours_in_words();

}  // namespace text_to_mesh
