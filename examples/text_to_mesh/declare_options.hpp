// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "raw_options.hpp"

namespace CLI {
class App;
}

namespace text_to_mesh {

/// Gives the command line all options, which write to `out`, or to `raw` what has to be settled later.
void declare_options(CLI::App& app, options& out, raw_options& raw);

}  // namespace text_to_mesh
