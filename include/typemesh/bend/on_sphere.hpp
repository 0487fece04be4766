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

/// The deformation that wraps text around a sphere: x becomes the longitude, y the latitude. The text's baseline y = 0
/// lies on the equator, and the point x = y = z = 0 stays where it is; the sphere's centre is at z = -radius.
///
///        .-~~~-.       Distances are kept along the equator and along the meridians. Letters become narrower away from
///      .' _---_ '.     the equator, by the cosine of their latitude.
///     | .'text '. |
///     |-----------|    radius > 0    the reader looks at the outside, as on a ball
///      '.       .'     radius < 0    the reader looks at the inside, as in a dome
///        '-___-'
///
/// Fails  error::bad_option: the radius is not finite, or nearer to 0 than 2^-20 ("radius"); error::goes_around: the
///        text is longer than the equator; error::folds_over: letters reach a pole, or are as deep as the radius
struct on_sphere {
    double radius = 3.0;  ///< in em

    /// See deformation.
    [[nodiscard]] error refused_options() const noexcept
    {
        return is_finite(radius) && std::fabs(radius) >= 0x1p-20 ? error{} : error::bad("radius");
    }

    /// See deformation.
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        constexpr double pi = 3.141592653589793;
        const double size = std::fabs(radius), pole = 0.5 * pi * size;
        if (!(text.low.y > -pole && text.high.y < pole)) return error::folds_over;
        return text.high.x - text.low.x <= 2.0 * pi * size ? error{} : error{error::goes_around};
    }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        // By the half angles: from_centre * away.z - radius would lose the depth of text on a sphere of a huge radius.
        const double half_x = 0.5 * p.x / radius, half_y = 0.5 * p.y / radius, sine_x = detail::steady_sine(half_x),
                     sine_y = detail::steady_sine(half_y);
        const double sine = 2.0 * sine_x * detail::steady_cosine(half_x), cosine = 1.0 - 2.0 * sine_x * sine_x,
                     up = 2.0 * sine_y * detail::steady_cosine(half_y), out = 1.0 - 2.0 * sine_y * sine_y;
        const double from_centre = radius + p.z, stretch = from_centre / radius,
                     behind = 2.0 * (out * (radius * sine_x) * sine_x + (radius * sine_y) * sine_y);
        const double3 away{out * sine, up, out * cosine};
        return {{from_centre * away.x, from_centre * away.y, p.z * away.z - behind},
                {stretch * out * cosine, 0.0, -stretch * out * sine},
                {-stretch * up * sine, stretch * out, -stretch * up * cosine},
                away};
    }

    /// See deformation.
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const double curvature = 1.0 / std::fabs(radius);
        const double bent = detail::farthest(b.low.z, b.high.z, -radius) * curvature * curvature;
        const double latitude = detail::farthest(b.low.y, b.high.y, 0.0) * curvature;  // not below its sine
        return {
            .xx = bent, .yy = bent, .xy = bent * (latitude < 1.0 ? latitude : 1.0), .xz = curvature, .yz = curvature};
    }
};
static_assert(deformation<on_sphere>);

}  // namespace typemesh::inline TYPEMESH_ABI
