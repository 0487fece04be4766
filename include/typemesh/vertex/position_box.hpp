// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/normalised.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A position as three numbers from 0 to 1, relative to a box.
struct box_position {
    unorm16 x;
    unorm16 y;
    unorm16 z;

    friend constexpr bool operator==(const box_position&, const box_position&) noexcept = default;
};

/// Positions as 16-bit numbers relative to a box, and how to decode them:
///
///     position = offset + scale * value     value = bits / 65,535, from 0 to 1: a unorm attribute, and the matrix
///                                           diag(scale), offset before all others
///     position = offset + step * bits       the same for integer attributes; step = scale / 65,535
///
/// Both corners of the box are steps themselves. A position inside the box is decoded with an error of at most half a
/// step per axis, scale / 131,070, plus the rounding of the decoded float. A position outside is clamped to the box.
/// Equal positions stay equal, so caps and walls still meet. Positions that are less than a step apart may coincide.
///
///     position_box quantise = position_box::around(plan.bounds().low, plan.bounds().high);
///     my_vertex operator()(const surface_point<wants>& s) const noexcept { return {quantise(s.position), ...}; }
class position_box {
public:
    vec3 offset;
    vec3 scale;

    constexpr position_box() noexcept = default;

    /// The box between two corners. An axis without extent has scale 0 and is exact.
    [[nodiscard]] static constexpr position_box around(vec3 low, vec3 high) noexcept
    {
        return {low, {high.x - low.x, high.y - low.y, high.z - low.z}};
    }

    /// A cube from the low corner, as large as the box's longest side. Use it where all axes must have one scale
    /// because the matrix also transforms normals (glTF nodes).
    [[nodiscard]] static constexpr position_box cube_around(vec3 low, vec3 high) noexcept
    {
        const position_box b = around(low, high);
        const float xy = b.scale.x > b.scale.y ? b.scale.x : b.scale.y, side = xy > b.scale.z ? xy : b.scale.z;
        return {low, {side, side, side}};
    }

    [[nodiscard]] constexpr box_position operator()(vec3 p) const noexcept
    {
        return {inside(p.x, offset.x, steps_x_), inside(p.y, offset.y, steps_y_), inside(p.z, offset.z, steps_z_)};
    }

    [[nodiscard]] constexpr vec3 decoded(box_position p) const noexcept
    {
        return {outside(p.x, offset.x, scale.x), outside(p.y, offset.y, scale.y), outside(p.z, offset.z, scale.z)};
    }

private:
    constexpr position_box(vec3 from, vec3 lengths) noexcept
        : offset{from},
          scale{lengths},
          steps_x_{steps(lengths.x)},
          steps_y_{steps(lengths.y)},
          steps_z_{steps(lengths.z)}
    {
    }

    /// Steps per unit; 0 along an axis without extent.
    [[nodiscard]] static constexpr double steps(float length) noexcept
    {
        return length > 0.0f ? unorm16::most / static_cast<double>(length) : 0.0;
    }
    [[nodiscard]] static constexpr unorm16 inside(float p, float from, double steps_a_unit) noexcept
    {
        const double place = (as_double(p) - as_double(from)) * steps_a_unit + 0.5;
        const double kept = place > 0.0 ? (place < 65535.0 ? place : 65535.0) : 0.0;
        return unorm16::from_bits(static_cast<std::uint16_t>(static_cast<int>(kept)));
    }
    [[nodiscard]] static constexpr float outside(unorm16 v, float from, float length) noexcept
    {
        return static_cast<float>(as_double(from) + as_double(length) * v.bits / unorm16::most);
    }

    double steps_x_ = 0.0;
    double steps_y_ = 0.0;
    double steps_z_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
