// SPDX-License-Identifier: MIT
#pragma once

// A vertex of GLM's vectors, for renderers that use them: right-handed, y up, v upwards, as in OpenGL.
//
//     std::vector<engines::glm_vertex> vertices;
//     std::vector<std::uint32_t> indices;
//     auto made = mesher.build("Hello world!", typemesh::into(vertices, indices), engines::glm_options());

#include <typemesh/adapt/glm.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace engines {

struct glm_vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 tangent;  ///< bitangent = tangent.w * glm::cross(normal, glm::vec3(tangent))
    glm::vec2 uv;
};
static_assert(sizeof(glm_vertex) == 48);

[[nodiscard]] inline typemesh::text_options glm_options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    o.frame.uv = typemesh::uv_origin::bottom_left;
    return o;
}

}  // namespace engines

template <>
struct typemesh::vertex_traits<engines::glm_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    engines::glm_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {to_glm(s.position), to_glm(s.normal), to_glm(s.tangent), to_glm(s.uv)};
    }
};
