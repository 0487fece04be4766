// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/frame.hpp>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The library's vectors as GLM's types, for vertex writers: `v.position = to_glm(s.position)`.
[[nodiscard]] inline glm::vec2 to_glm(vec2 v) noexcept { return {v.x, v.y}; }
[[nodiscard]] inline glm::vec3 to_glm(vec3 v) noexcept { return {v.x, v.y, v.z}; }
[[nodiscard]] inline glm::vec4 to_glm(vec4 v) noexcept { return {v.x, v.y, v.z, v.w}; }
[[nodiscard]] inline glm::dvec2 to_glm(point p) noexcept { return {p.x, p.y}; }

/// The reverse of to_glm(), for drawing outlines from GLM's types.
[[nodiscard]] inline vec2 from_glm(const glm::vec2& v) noexcept { return {v.x, v.y}; }
/// GLM's vector as the library's own type.
[[nodiscard]] inline vec3 from_glm(const glm::vec3& v) noexcept { return {v.x, v.y, v.z}; }
[[nodiscard]] inline vec4 from_glm(const glm::vec4& v) noexcept { return {v.x, v.y, v.z, v.w}; }
[[nodiscard]] inline point from_glm(const glm::dvec2& v) noexcept { return {v.x, v.y}; }

/// The matrix that translates by `by`: the model matrix of a glyph_instance is translation_matrix(i.translation). If a
/// path turns letters, its first three columns are i.x, i.y and i.z instead.
[[nodiscard]] inline glm::mat4 translation_matrix(vec3 by) noexcept
{
    glm::mat4 m{1.0f};
    m[3] = {by.x, by.y, by.z, 1.0f};
    return m;
}

/// The frame of a matrix whose columns are `right`, `up` and `toward`. They are unit vectors at right angles, as in
/// every rotation (glm::mat3_cast of a quaternion); they may be left-handed. Winding and uv are frame's defaults.
[[nodiscard]] inline frame frame_from_glm(const glm::mat3& axes) noexcept
{
    frame f;
    f.right = from_glm(axes[0]);
    f.up = from_glm(axes[1]);
    f.toward = from_glm(axes[2]);
    return f;
}

}  // namespace typemesh::inline TYPEMESH_ABI
