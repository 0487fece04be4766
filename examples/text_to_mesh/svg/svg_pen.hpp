// SPDX-License-Identifier: MIT
#pragma once

#include "svg_drawing.hpp"
#include "svg_style.hpp"

#include <typemesh/core/affine.hpp>
#include <typemesh/core/error.hpp>

#include <cstddef>
#include <string_view>

namespace text_to_mesh {

/// How much may still be drawn.
struct svg_allowance {
    std::size_t pieces;
    bool is_over = false;

    bool take() noexcept
    {
        if (pieces == 0) is_over = true;
        if (!is_over) --pieces;
        return !is_over;
    }
};

/// Draws path data into a drawing.
class svg_pen {
public:
    /// Of all shapes together, at most `max_pieces` curves and beginnings of contours are drawn.
    svg_pen(svg_drawing& out, double tolerance, std::size_t max_pieces)
        : out_{out}, tolerance_{tolerance}, max_pieces_{max_pieces}, left_{max_pieces}
    {
    }

    /// Starts again with an empty drawing.
    void clear() { left_ = {max_pieces_}; }

    /// Adds the shape that path data fill, mapped. Of malformed data what comes before the mistake is drawn, and
    /// has_mistake() holds afterwards. Fails with error::too_many_points beyond max_pieces.
    [[nodiscard]] typemesh::error fill(std::string_view data, const typemesh::affine& map, typemesh::fill_rule rule);

    /// Adds the shape of the stroke of path data.
    [[nodiscard]] typemesh::error stroke(std::string_view data, const typemesh::affine& map, const svg_look& look);

    [[nodiscard]] bool has_mistake() const { return has_mistake_; }
    [[nodiscard]] bool has_too_many_dashes() const { return has_too_many_dashes_; }

private:
    [[nodiscard]] typemesh::error keep(typemesh::outline& made, typemesh::fill_rule rule);

    svg_drawing& out_;
    double tolerance_;
    std::size_t max_pieces_;
    svg_allowance left_;
    bool has_mistake_ = false, has_too_many_dashes_ = false;
};

}  // namespace text_to_mesh
