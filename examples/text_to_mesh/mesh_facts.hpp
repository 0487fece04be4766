// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <string>

namespace text_to_mesh {

/// How large a model is, in the unit of its file; instances count where they stand.
struct mesh_facts {
    double low[3] = {}, high[3] = {};  ///< its bounds; all 0 for an empty model
    double volume = 0.0;               ///< that it encloses; solids that overlap count twice
};

[[nodiscard]] mesh_facts facts_of(const model& mesh);

/// "35.8 x 13.3 x 2 mm", without the unit unless it is printed.
[[nodiscard]] std::string size_in_words(const mesh_facts& facts, bool printed);

/// A part of the line of JSON: ,"bounds":{...},"size":[...],"unit":"mm","volume":...
[[nodiscard]] std::string in_json(const mesh_facts& facts, bool printed);

}  // namespace text_to_mesh
