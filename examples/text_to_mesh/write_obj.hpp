// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// Writes a Wavefront OBJ: v, vt, vn and one group per part. Decimal texts read back as the same floats. A model with
/// parts gets a file of materials beside it, "x.mtl" beside "x.obj", with one of each part's name; both files are
/// written or none. On standard output there are groups without materials.
///
/// Gives  an empty string, or one sentence for the user; see write_atomically.
[[nodiscard]] std::string write_obj(const model& mesh, const std::string& path, file_set& files);

}  // namespace text_to_mesh
