// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "raw_options.hpp"

#include <string>

namespace text_to_mesh {

/// Finds out what is to be written. Gives an empty string, or one sentence of what is wrong.
[[nodiscard]] std::string settle_files(options& out, const raw_options& raw);

/// Finishes the options for what the files contain. Gives an empty string, or one sentence of what is wrong.
/// settle_form() must be first.
[[nodiscard]] std::string settle_contents(options& out, const raw_options& raw);

}  // namespace text_to_mesh
