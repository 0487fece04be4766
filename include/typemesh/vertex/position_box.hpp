// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/normalised.hpp>

namespace typemesh {

/// A position as three numbers from 0 to 1, relative to a box.
struct box_position {
    unorm16 x;
    unorm16 y;
    unorm16 z;

    friend constexpr bool operator==(const box_position&, const box_position&) noexcept = default;
};

/// Positions as 16-bit numbers relative to a box, and how they are read again:
///
///     position = offset + scale * value     value = bits / 65,535, from 0 to 1: a unorm attribute, and the matrix
///                                           diag(scale), offset before all others
///     position = offset + step * bits       the same for whole-number attributes; step = scale / 65,535
///
/// Both corners of the box are steps themselves. Inside it a position comes back within half a step, an axis: scale /
/// 131,070, and the rounding of the float that it is read into; outside it is moved to the box. Equal positions stay
/// equal, so caps and walls still meet; positions less than a step apart may fall together.
///
///     position_box quantise = position_box::around(plan.bounds().low, plan.bounds().high);
///     my_vertex operator()(const surface_point<wants>& s) const noexcept { return {quantise(s.position), ...}; }
struct position_box {
    vec3 offset;
    vec3 scale;

    /// The box between two corners. An axis without extent has scale 0 and comes back exactly.
    [[nodiscard]] static constexpr position_box around(vec3 low, vec3 high) noexcept
    {
        return {low, {high.x - low.x, high.y - low.y, high.z - low.z}};
    }

    /// A cube instead, from the low corner on, as large as the box' longest side: where one scale must do for all axes,
    /// since the matrix turns normals as well (glTF nodes).
    [[nodiscard]] static constexpr position_box cube_around(vec3 low, vec3 high) noexcept
    {
        const position_box b = around(low, high);
        const float xy = b.scale.x > b.scale.y ? b.scale.x : b.scale.y, side = xy > b.scale.z ? xy : b.scale.z;
        return {low, {side, side, side}};
    }

    [[nodiscard]] constexpr box_position operator()(vec3 p) const noexcept
    {
        return {inside(p.x, offset.x, scale.x), inside(p.y, offset.y, scale.y), inside(p.z, offset.z, scale.z)};
    }

    [[nodiscard]] constexpr vec3 decoded(box_position p) const noexcept
    {
        return {outside(p.x, offset.x, scale.x), outside(p.y, offset.y, scale.y), outside(p.z, offset.z, scale.z)};
    }

private:
    /// Rounded once, from the exact quotient's double: float alone would lose steps.
    [[nodiscard]] static constexpr unorm16 inside(float p, float from, float length) noexcept
    {
        if (!(length > 0.0f)) return unorm16::from_bits(0);
        const double steps = (static_cast<double>(p) - from) * unorm16::most / length + 0.5;
        const double kept = steps > 0.0 ? (steps < 65535.0 ? steps : 65535.0) : 0.0;
        return unorm16::from_bits(static_cast<std::uint16_t>(kept));
    }
    [[nodiscard]] static constexpr float outside(unorm16 v, float from, float length) noexcept
    {
        return static_cast<float>(from + static_cast<double>(length) * v.bits / unorm16::most);
    }
};

}  // namespace typemesh
