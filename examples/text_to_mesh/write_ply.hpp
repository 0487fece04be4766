// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// Writes a binary little-endian PLY: vertices with x y z nx ny nz s t, faces with three indices and,
/// if the model has parts, the number of theirs; comments name them: "part 0 front".
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_ply(const model& mesh, const std::string& path, file_set& files);

}  // namespace text_to_mesh
