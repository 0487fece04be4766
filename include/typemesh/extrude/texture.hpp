// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/placement.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Where texture coordinates come from. v grows upwards, or downwards as 1 - v if the frame says uv_origin::top_left.
///
///     box    the text's (or line's, or glyph's) box becomes the square [0, 1], for caps and walls alike: walls show
///            the caps' rim, drawn out into lines. For pictures made for one text, and for formats limited to [0, 1]
///     em     the default: one texture tile is one em wide and high, everywhere, so coordinates go beyond [0, 1]:
///            caps    x and y from the text's origin
///            walls   u = distance along the contour from its seam, in its own direction; v runs from 1 at the front
///                    down to 1 - depth (in em), so that an upright image is upright on a wall whose front edge is its
///                    top
enum class texture_mapping : std::uint8_t { box, em };

/// Texture coordinates of points by their position in the plane.
///
/// The upper edge of a box gives exactly 1 (and 0 flipped): the product is rounded to 32 bits before it is flipped.
class planar_texture {
public:
    planar_texture(texture_mapping mapping, const placement& at) noexcept
        : pen_{mapping == texture_mapping::box ? at.texture_pen : at.em_pen},
          per_cell_{mapping == texture_mapping::box ? at.texture_per_cell : point{at.em_per_cell, at.em_per_cell}},
          base_{at.frame.uv == uv_origin::top_left ? 1.0f : 0.0f},
          sign_{at.frame.uv == uv_origin::top_left ? -1.0f : 1.0f}
    {
    }

    [[nodiscard]] vec2 operator()(grid_point p) const noexcept { return (*this)(placement::exact(p)); }

    /// The same for any point, in cells; a grid point's to the bit.
    [[nodiscard]] vec2 operator()(point p) const noexcept
    {
        return {static_cast<float>((p.x + pen_.x) * per_cell_.x),
                turned(static_cast<float>((p.y + pen_.y) * per_cell_.y))};
    }

    /// v as it is written, from v growing upwards.
    [[nodiscard]] float turned(float v) const noexcept { return base_ + sign_ * v; }

private:
    point pen_;
    point per_cell_;
    float base_;
    float sign_;
};

/// Texture coordinates of walls, and of all that takes their place, in em mapping: by the distance along the contour,
/// in cells, and the distance down from its front edge, in the unit of an extruder's heights.
class wall_texture {
public:
    explicit wall_texture(const placement& at) noexcept
        : planar_{texture_mapping::em, at},
          per_cell_{static_cast<float>(at.em_per_cell)},
          em_per_depth_{at.em_per_depth}
    {
    }

    [[nodiscard]] vec2 operator()(float along, double down) const noexcept { return {u(along), v(down)}; }
    [[nodiscard]] float u(float along) const noexcept { return along * per_cell_; }
    [[nodiscard]] float v(double down) const noexcept
    {
        return planar_.turned(1.0f - static_cast<float>(down * em_per_depth_));
    }

private:
    planar_texture planar_;
    float per_cell_;
    double em_per_depth_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
