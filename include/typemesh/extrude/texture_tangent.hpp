// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/placement.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// Tangents of the texture mappings, in closed form: computed without triangles or averaging.
///
///     x, y, z   unit length, perpendicular to the vertex's normal: the direction in which u grows
///     w         +1 or -1: w * cross(normal, tangent), computed in the caller's own coordinates, is the direction in
///               which v grows, as v is written. It therefore changes with uv_origin, and with a left-handed frame
///
///          caps       u grows along the text, in all mappings; also on the back, where the text is seen from behind.
///                     With shared_normals they lean: the tangent is the text's direction without its component along
///                     the normal
///          walls      u grows along the contour, in its own direction (the interior on the left): a quarter turn from
///                     the normal, exact wherever the normal is. In box mapping, u and v are equal at both ends of a
///                     wall's height and define no tangent; the tangent of em mapping is used instead
///
/// The convention is MikkTSpace's (M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008):
/// bitangent = sign * cross(normal, tangent). Engines whose normal maps have "green up" while v grows downwards (glTF,
/// Godot) need -w.
class texture_tangent {
public:
    texture_tangent() noexcept = default;
    explicit texture_tangent(const frame& f) noexcept
        : sign_{f.mirrors() == (f.uv == uv_origin::top_left) ? 1.0f : -1.0f}
    {
    }

    /// On any surface, from the direction in which u grows there: a unit vector perpendicular to the normal, in the
    /// text's own axes. facing is 1 if upward v grows along cross(normal, u), and -1 if against it.
    template <class Axes>
    [[nodiscard]] vec4 along(const Axes& axes, vec3 u, float facing) const noexcept
    {
        return joined(axes.direction(u.x, u.y, u.z), facing);
    }

    /// On a cap with a straight normal; facing is 1 for the front and -1 for the back.
    template <class Axes>
    [[nodiscard]] vec4 on_cap(const Axes& axes, float facing) const noexcept
    {
        return joined(axes.direction(1.0f, 0.0f, 0.0f), facing);
    }

    /// On a cap's rim whose unit normal n, in the text's own axes, leans outwards.
    template <class Axes>
    [[nodiscard]] vec4 on_rim(const Axes& axes, vec3 n, float facing) const noexcept
    {
        const double x = as_double(n.x), y = as_double(n.y), z = as_double(n.z), rest = y * y + z * z;
        if (!(rest > 0x1p-40)) return joined(axes.direction(-n.y, n.x, 0.0f), facing);
        const double scale = 1.0 / std::sqrt(rest * (rest + x * x)), share = scale * x;
        return joined(axes.direction(static_cast<float>(scale * rest), static_cast<float>(-share * y),
                                     static_cast<float>(-share * z)),
                      facing);
    }

    /// On a wall, from its unit normal in the plane.
    template <class Axes>
    [[nodiscard]] vec4 on_wall(const Axes& axes, vec2 n) const noexcept
    {
        return joined(axes.direction(-n.y, n.x, 0.0f), 1.0f);
    }

private:
    [[nodiscard]] vec4 joined(vec3 t, float facing) const noexcept { return {t.x, t.y, t.z, sign_ * facing}; }

    float sign_ = 1.0f;
};

}  // namespace typemesh::inline TYPEMESH_ABI
