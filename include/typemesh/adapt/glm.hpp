// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace typemesh {

/// The library's vectors as GLM's: for vertex writers (`v.position = to_glm(s.position)`), and for drawing outlines
/// from GLM's.
[[nodiscard]] inline glm::vec2 to_glm(vec2 v) noexcept { return {v.x, v.y}; }
[[nodiscard]] inline glm::vec3 to_glm(vec3 v) noexcept { return {v.x, v.y, v.z}; }
[[nodiscard]] inline glm::dvec2 to_glm(point p) noexcept { return {p.x, p.y}; }

/// And back.
[[nodiscard]] inline vec2 from_glm(const glm::vec2& v) noexcept { return {v.x, v.y}; }
[[nodiscard]] inline vec3 from_glm(const glm::vec3& v) noexcept { return {v.x, v.y, v.z}; }
[[nodiscard]] inline point from_glm(const glm::dvec2& v) noexcept { return {v.x, v.y}; }

}  // namespace typemesh
