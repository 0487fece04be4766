// SPDX-License-Identifier: MIT
#pragma once

#include "atomic_file.hpp"
#include "options.hpp"

#include <typemesh/adapt/harfbuzz.hpp>

#include <string>

namespace text_to_mesh {

/// Writes the text as a GLB file with morph targets along an axis of its font, by --morph, and adds a line of numbers
/// to `said`. The file has a mesh for each section of the morph, a target for each of its keys but the first, and an
/// animation that runs through the axis and back in four seconds. If there are several sections, all but one have the
/// scale 0 at any time.
///
/// Gives an empty string, or one sentence.
[[nodiscard]] std::string write_morph(const options& o, const typemesh::harfbuzz_font& font, file_set& files,
                                      std::string& said);

}  // namespace text_to_mesh
