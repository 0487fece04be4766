// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace text_to_mesh {

/// The value of an attribute of an element; empty if it is not there.
using svg_attributes = std::function<std::string_view(const char*)>;

/// Whether elements of that name are drawn by data_of().
[[nodiscard]] bool is_shape(std::string_view name);

/// The path data of a path, rect, circle, ellipse, line, polyline or polygon, in user units. Empty if it draws nothing:
/// a radius of 0, say. Percentages are of `port`.
[[nodiscard]] std::string data_of(std::string_view name, const svg_attributes& of, const typemesh::box& port);

}  // namespace text_to_mesh
