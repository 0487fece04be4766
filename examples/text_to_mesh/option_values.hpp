// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/profile_points.hpp>
#include <typemesh/typemesh.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// A finite number as people write it, "-0.5" or "1e-3", and nothing round it: no blank, no plus, no 0x10, no inf.
[[nodiscard]] std::optional<double> decimal(std::string_view written);

/// "wght=700" and "liga", "liga=0", "-liga", "+liga". Nothing where it is not of that form.
[[nodiscard]] std::optional<typemesh::variation> read_variation(std::string_view written);
[[nodiscard]] std::optional<typemesh::feature> read_feature(std::string_view written);

/// A bevel's points, "0,0;0.2,0.8;1,1". Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_profile(std::string_view written, typemesh::profile_points& out);

/// A box, "30x10": two positive numbers up to 1000000. False if it is not of that form.
[[nodiscard]] bool read_box(std::string_view written, double& width, double& height);

/// The tolerances of levels of detail, "0.01,0.04": at most 6, each larger than the one before it. Gives an empty string,
/// or what is wrong: "must ...".
[[nodiscard]] std::string read_levels(std::string_view written, std::vector<double>& out);

/// A backslash and an n, as a shell passes them on, become a line break.
[[nodiscard]] std::string with_line_breaks(std::string text);

/// "left, center or right"
[[nodiscard]] std::string joined(const std::vector<std::string>& names);

}  // namespace text_to_mesh
