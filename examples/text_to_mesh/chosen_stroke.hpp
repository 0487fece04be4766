// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/stroke_style.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// Letters that are strokes along their outlines, by --stroke. A width of 0 is none.
struct chosen_stroke {
    double width = 0.0;  ///< em
    typemesh::stroke_cap cap = typemesh::stroke_cap::butt;
    typemesh::stroke_join join = typemesh::stroke_join::mitre;
    std::vector<double> dashes;  ///< em

    /// Refers to the dashes.
    [[nodiscard]] typemesh::stroke_style style() const
    {
        return {.width = width, .cap = cap, .join = join, .dashes = dashes};
    }
};

/// "0.03", "0.03,round", "0.02,bevel,square,0.1,0.05": the width, then words in any order (round is of caps and joins) and
/// the lengths of dashes and gaps. Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_stroke(std::string_view written, chosen_stroke& out);

}  // namespace text_to_mesh
