// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/text/on_path.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace text_to_mesh {

/// A path that is chosen at run time, and how the text stands on it; none without a curve.
struct chosen_path {
    std::shared_ptr<const typemesh::plane_path> curve;
    typemesh::path_options how{.anchor = typemesh::path_anchor::middle};
};

/// "circle:2", "circle:-2" (inside), "arc:2,120", "wave:0.3,4" or "M0,0 C1,1 2,1 3,0", in em. Gives an empty string, or
/// what is wrong: "must ...".
[[nodiscard]] std::string read_path(std::string_view written, chosen_path& out);

}  // namespace text_to_mesh
