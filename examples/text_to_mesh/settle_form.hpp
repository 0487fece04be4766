// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "raw_options.hpp"

#include <string>

namespace text_to_mesh {

/// Finishes the options for the form of the letters: tubes, bevels, weight, refinement, bends, paths, plates. Gives an
/// empty string, or one sentence of what is wrong. settle_files() must be first.
[[nodiscard]] std::string settle_form(options& out, const raw_options& raw);

}  // namespace text_to_mesh
