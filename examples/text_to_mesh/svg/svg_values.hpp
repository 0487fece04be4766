// SPDX-License-Identifier: MIT
#pragma once

#include "../model.hpp"

#include <typemesh/core/affine.hpp>
#include <typemesh/core/box.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

// The values of attributes of SVG. What is malformed gives nothing.

/// Takes a number from the front of a text, with the white space and the comma behind it.
[[nodiscard]] std::optional<double> take_number(std::string_view& text);

/// Numbers to the end of a text, separated by white space or commas.
[[nodiscard]] std::optional<std::vector<double>> read_numbers(std::string_view text);

/// A length in user units: "12", "3mm", "50%" of `whole`. An em is 16.
[[nodiscard]] std::optional<double> read_length(std::string_view text, double whole);

/// "translate(3) rotate(45 12 12)", and the other functions of SVG 1.1.
[[nodiscard]] std::optional<typemesh::affine> read_transform(std::string_view text);

/// First `inner`, then `outer`.
[[nodiscard]] typemesh::affine after(const typemesh::affine& outer, const typemesh::affine& inner);

/// Whether a map maps the plane to a line or a point.
[[nodiscard]] bool is_flat(const typemesh::affine& map);

/// By how much a map enlarges lengths in the direction in which it does so most.
[[nodiscard]] double stretch_of(const typemesh::affine& map);

/// "0 0 24 24", with a positive width and height.
[[nodiscard]] std::optional<typemesh::box> read_view_box(std::string_view text);

/// The map of a view box into a viewport, by preserveAspectRatio: "xMidYMid meet", "none".
[[nodiscard]] typemesh::affine view_map(const typemesh::box& view, const typemesh::box& port, std::string_view how);

/// "#c33", "#cc3333", with alpha, "rgb(204 51 51 / 50%)", "rgba(204, 51, 51, .5)", "hsl(0, 60%, 50%)", "crimson",
/// "transparent".
[[nodiscard]] std::optional<rgb_colour> read_svg_colour(std::string_view text);

/// The name in "url(#name)" or "#name", with whatever follows left out; empty if it is none.
[[nodiscard]] std::string name_of_reference(std::string_view text);

[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string lower(std::string_view text);

}  // namespace text_to_mesh
