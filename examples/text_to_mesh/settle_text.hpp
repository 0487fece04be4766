// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "raw_options.hpp"

#include <string>

namespace text_to_mesh {

/// Finishes the options for the text, its fonts and lines. Gives an empty string, or one sentence of what is wrong.
[[nodiscard]] std::string settle_text(options& out, const raw_options& raw);

/// Decides where the text comes from. Gives an empty string, or one sentence of what is wrong.
[[nodiscard]] std::string settle_source(options& out, const raw_options& raw);

}  // namespace text_to_mesh
