// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The place of texture coordinate v = 0: at the top (Direct3D, Vulkan, glTF, Unreal) or at the bottom (OpenGL, Unity).
enum class uv_origin : std::uint8_t { top_left, bottom_left };

/// The caller's coordinate system: the directions of the text's own axes in it, and the winding of its triangles.
///
///        up                       Text runs along `right`, stands along `up` and faces `toward` (the front cap's
///         |   the text's front    normal). The three are unit vectors at right angles; they may be left-handed.
///         |
///         +------ right           winding: the sign of dot(cross(b - a, c - a), normal) for every triangle a, b, c
///        /                        of the output, in the caller's coordinates. +1 for OpenGL, glTF, Direct3D and Unity;
///     toward                      -1 for Godot. Unlike "clockwise", the sign means the same in left-handed frames, in
///                                 which corners are swapped to keep it (see turns_triangles()).
struct frame {
    vec3 right{1.0f, 0.0f, 0.0f};
    vec3 up{0.0f, 1.0f, 0.0f};
    vec3 toward{0.0f, 0.0f, 1.0f};
    std::int8_t winding = 1;
    uv_origin uv = uv_origin::top_left;

    /// Whether right, up, toward, in this order, are left-handed: their determinant is negative.
    [[nodiscard]] constexpr bool mirrors() const noexcept
    {
        const float determinant = right.x * (up.y * toward.z - up.z * toward.y) -
                                  right.y * (up.x * toward.z - up.z * toward.x) +
                                  right.z * (up.x * toward.y - up.y * toward.x);
        return determinant < 0.0f;
    }

    /// Whether two corners of each triangle must be swapped: either the frame is left-handed or the winding is
    /// negative, but not both.
    [[nodiscard]] constexpr bool turns_triangles() const noexcept { return mirrors() != (winding < 0); }

    /// Whether the three are unit vectors at right angles, up to rounding.
    [[nodiscard]] constexpr bool is_orthonormal() const noexcept
    {
        const auto product = [](vec3 a, vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; };
        const auto is = [](float value, float wanted) noexcept {
            return value > wanted - 1e-3f && value < wanted + 1e-3f;
        };
        return is(product(right, right), 1.0f) && is(product(up, up), 1.0f) && is(product(toward, toward), 1.0f) &&
               is(product(right, up), 0.0f) && is(product(up, toward), 0.0f) && is(product(toward, right), 0.0f);
    }

    /// Whether each of the three is parallel to a coordinate axis, in either direction.
    [[nodiscard]] constexpr bool is_along_axes() const noexcept
    {
        const auto one = [](vec3 v) noexcept {
            return (is_zero(v.x) ? 0 : 1) + (is_zero(v.y) ? 0 : 1) + (is_zero(v.z) ? 0 : 1) == 1;
        };
        return one(right) && one(up) && one(toward);
    }

    [[nodiscard]] constexpr vec3 operator()(float x, float y, float z) const noexcept
    {
        return {right.x * x + up.x * y + toward.x * z, right.y * x + up.y * y + toward.y * z,
                right.z * x + up.z * y + toward.z * z};
    }
};

/// Right-handed, y up, front towards +z: glTF, OpenGL and three.js with bottom_left, Godot with .winding = -1.
inline constexpr frame right_handed_y_up{};

/// Left-handed, y up, front towards -z, so that a viewer who looks along +z reads it: Direct3D, Unity with bottom_left.
inline constexpr frame left_handed_y_up{.toward = {0.0f, 0.0f, -1.0f}};

/// Right-handed, z up, front towards -y: Blender, CAD.
inline constexpr frame right_handed_z_up{.up = {0.0f, 0.0f, 1.0f}, .toward = {0.0f, -1.0f, 0.0f}};

/// Left-handed, z up, front towards -x, text along +y: Unreal's axes (see Unreal's own documentation for the winding
/// that it expects).
inline constexpr frame left_handed_z_up{
    .right = {0.0f, 1.0f, 0.0f}, .up = {0.0f, 0.0f, 1.0f}, .toward = {-1.0f, 0.0f, 0.0f}};

}  // namespace typemesh::inline TYPEMESH_ABI
