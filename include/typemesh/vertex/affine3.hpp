// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// An affine map of space, in the output's unit and frame: x, y and z are the images of the unit vectors, and origin is
/// the image of the origin. By default it is the identity.
///
///     affine3 a = shifted({0, 1, 0});                         up by one unit
///     affine3 a = turned({0, 0, 1}, angle).about(pivot);      around a place that stays
///     affine3 a = then_this * first_this;                     the right one comes first: (b * a)(p) = b(a(p))
struct affine3 {
    vec3 x{1.0f, 0.0f, 0.0f};
    vec3 y{0.0f, 1.0f, 0.0f};
    vec3 z{0.0f, 0.0f, 1.0f};
    vec3 origin{};

    /// The image of a point. Each product is exact, so that the sum is the same whether or not a compiler fuses them.
    [[nodiscard]] constexpr vec3 operator()(vec3 p) const noexcept
    {
        return direction(p, as_double(origin.x), as_double(origin.y), as_double(origin.z));
    }

    /// The image of a direction: the map without its origin.
    [[nodiscard]] constexpr vec3 direction(vec3 d) const noexcept { return direction(d, 0.0, 0.0, 0.0); }

    /// The map whose images of directions are the same, and which leaves `pivot` where it is, moved by this origin.
    [[nodiscard]] constexpr affine3 about(vec3 pivot) const noexcept
    {
        affine3 map = *this;
        const vec3 image =
            direction({-pivot.x, -pivot.y, -pivot.z}, as_double(pivot.x) + as_double(origin.x),
                      as_double(pivot.y) + as_double(origin.y), as_double(pivot.z) + as_double(origin.z));
        map.origin = image;
        return map;
    }

    /// First `before`, then `after`.
    friend constexpr affine3 operator*(const affine3& after, const affine3& before) noexcept
    {
        return {after.direction(before.x), after.direction(before.y), after.direction(before.z), after(before.origin)};
    }
    friend constexpr bool operator==(const affine3& a, const affine3& b) noexcept
    {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.origin == b.origin;
    }

private:
    [[nodiscard]] constexpr vec3 direction(vec3 d, double dx, double dy, double dz) const noexcept
    {
        const double u = as_double(d.x), v = as_double(d.y), w = as_double(d.z);
        return {static_cast<float>(as_double(x.x) * u + as_double(y.x) * v + (as_double(z.x) * w + dx)),
                static_cast<float>(as_double(x.y) * u + as_double(y.y) * v + (as_double(z.y) * w + dy)),
                static_cast<float>(as_double(x.z) * u + as_double(y.z) * v + (as_double(z.z) * w + dz))};
    }
};

/// Moves everything by one vector.
[[nodiscard]] constexpr affine3 shifted(vec3 by) noexcept
{
    affine3 map;
    map.origin = by;
    return map;
}

/// Scales everything from the origin; see affine3::about().
[[nodiscard]] constexpr affine3 scaled(float by) noexcept
{
    return {{by, 0.0f, 0.0f}, {0.0f, by, 0.0f}, {0.0f, 0.0f, by}, {}};
}

/// Turns everything around an axis through the origin, counter-clockwise for a viewer towards whom the axis points, in
/// a right-handed frame. From O. Rodrigues (1840).
///
///     axis     of unit length
///     angle    in radians
[[nodiscard]] inline affine3 turned(vec3 axis, double angle) noexcept
{
    const double s = std::sin(angle), c = std::cos(angle), t = 1.0 - c;
    const double u = as_double(axis.x), v = as_double(axis.y), w = as_double(axis.z);
    const auto column = [](double a, double b, double d) noexcept {
        return vec3{static_cast<float>(a), static_cast<float>(b), static_cast<float>(d)};
    };
    return {column(t * u * u + c, t * u * v + s * w, t * u * w - s * v),
            column(t * u * v - s * w, t * v * v + c, t * v * w + s * u),
            column(t * u * w + s * v, t * v * w - s * u, t * w * w + c),
            {}};
}

}  // namespace typemesh::inline TYPEMESH_ABI
