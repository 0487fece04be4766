// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/frame.hpp>

#include <string>
#include <string_view>

namespace text_to_mesh {

/// Which place of a text comes to which place of the file.
///
///     top       +-----------+        x   left, centre or right of what is seen; else where the text is aligned to
///     middle    | Typemesh  |        y   top, middle or bottom of what is seen; else the first line's baseline
///     baseline  |   text    |        z   front, halfway or base: how deep
///     bottom    +-----------+
///             left centre right
struct placing {
    enum class across { own, left, centre, right } x = across::own;
    enum class upwards { baseline, bottom, middle, top } y = upwards::baseline;
    enum class depth { automatic, front, halfway, base } z = depth::automatic;
    double at[3] = {};  ///< where that comes to, in the file's unit
};

/// "centre,bottom,base": some of them in any order. Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_anchor(std::string_view written, placing& out);

/// "10,20" or "10,20,0". Gives an empty string, or what is wrong.
[[nodiscard]] std::string read_origin(std::string_view written, placing& out);

/// By how much a mesh with such bounds has to be moved.
struct shift {
    double x = 0.0, y = 0.0, z = 0.0;
};
[[nodiscard]] shift shift_of(const placing& p, const typemesh::bounds3& bounds);

/// Moves a mesh, or the places of its letters, along z. False if two corners of a mesh are one now, for 32-bit numbers
/// are too coarse there.
[[nodiscard]] bool lift(model& mesh, double by);

}  // namespace text_to_mesh
