// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/bend/impl/farthest.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The deformation that wraps text around a cylinder.
///
///             .--T--.            seen from above, with the axis up: the text's front (z = 0) lies on the cylinder, and
///          .-'   |   '-.         the point x = 0, z = 0 stays where it is. The cylinder's axis is at z = -radius.
///         /      |R     \        Distances along the text are kept on the cylinder itself; they shrink behind it.
///        |       +       |
///                                radius > 0    the reader looks at the outside, as on a cup
///                                radius < 0    the reader looks at the inside, as in a round room
///
/// Fails  error::bad_option: the radius is not finite, or nearer to 0 than 2^-20 ("radius"); error::goes_around: the
///        text is longer than the circumference; error::folds_over: the letters are as deep as the radius
struct on_cylinder {
    double radius = 2.0;             ///< in em
    text_axis axis = text_axis::up;  ///< the direction of the cylinder's axis

    /// See deformation.
    [[nodiscard]] error refused_options() const noexcept
    {
        return is_finite(radius) && std::fabs(radius) >= 0x1p-20 ? error{} : error::bad("radius");
    }

    /// See deformation.
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        const double3 size = text.high - text.low;
        const double around = 6.283185307179586 * std::fabs(radius);
        return (axis == text_axis::up ? size.x : size.y) <= around ? error{} : error{error::goes_around};
    }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const bool up = axis == text_axis::up;
        // By the half angle: from_axis * cosine - radius would lose the depth of text on a cylinder of a huge radius.
        const double half = 0.5 * (up ? p.x : p.y) / radius, half_sine = detail::steady_sine(half);
        const double sine = 2.0 * half_sine * detail::steady_cosine(half), cosine = 1.0 - 2.0 * half_sine * half_sine;
        const double from_axis = radius + p.z, stretch = from_axis / radius,
                     out = p.z * cosine - 2.0 * (radius * half_sine) * half_sine;
        if (up)
            return {{from_axis * sine, p.y, out},
                    {stretch * cosine, 0.0, -stretch * sine},
                    {0.0, 1.0, 0.0},
                    {sine, 0.0, cosine}};
        return {{p.x, from_axis * sine, out},
                {1.0, 0.0, 0.0},
                {0.0, stretch * cosine, -stretch * sine},
                {0.0, sine, cosine}};
    }

    /// See deformation.
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const double curvature = 1.0 / std::fabs(radius),
                     bent = detail::farthest(b.low.z, b.high.z, -radius) * curvature * curvature;
        if (axis == text_axis::up) return {.xx = bent, .xz = curvature};
        return {.yy = bent, .yz = curvature};
    }
};
static_assert(deformation<on_cylinder>);

}  // namespace typemesh::inline TYPEMESH_ABI
