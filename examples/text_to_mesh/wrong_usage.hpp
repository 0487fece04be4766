// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace text_to_mesh {

/// One sentence of what is wrong with the command line, after app.parse(argc, argv) has thrown `wrong`.
[[nodiscard]] std::string in_words(const CLI::ParseError& wrong, CLI::App& app, int argc, char** argv);

}  // namespace text_to_mesh
