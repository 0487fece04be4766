// SPDX-License-Identifier: MIT
#pragma once

#include "svg_drawing.hpp"
#include "svg_style.hpp"

#include <typemesh/core/affine.hpp>
#include <typemesh/core/error.hpp>

#include <string_view>

namespace text_to_mesh {

/// Draws path data into a drawing.
class svg_pen {
public:
    svg_pen(svg_drawing& out, double tolerance) : out_{out}, tolerance_{tolerance} {}

    /// Adds the shape that path data fill, mapped. Of malformed data what comes before the mistake is drawn, and
    /// has_mistake() holds afterwards.
    [[nodiscard]] typemesh::error fill(std::string_view data, const typemesh::affine& map, typemesh::fill_rule rule);

    /// Adds the shape of the stroke of path data.
    [[nodiscard]] typemesh::error stroke(std::string_view data, const typemesh::affine& map, const svg_look& look);

    [[nodiscard]] bool has_mistake() const { return has_mistake_; }
    [[nodiscard]] bool has_too_many_dashes() const { return has_too_many_dashes_; }

private:
    svg_drawing& out_;
    double tolerance_;
    bool has_mistake_ = false, has_too_many_dashes_ = false;
};

}  // namespace text_to_mesh
