// SPDX-License-Identifier: MIT
#pragma once

// OpenGL 3.3 and later, OpenGL ES 3, WebGL 2: one interleaved vertex of 24 bytes. Right-handed, y up, front faces
// counter-clockwise (glFrontFace(GL_CCW), the default); v upwards, as glTexImage2D takes the lowest row first.
//
// Include your loader's header (glad, GLEW, <GLES3/gl3.h>) first.
//
//     glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(engines::opengl::vertex) * plan->size().vertices), nullptr, GL_STATIC_DRAW);
//     void* at = glMapBufferRange(GL_ARRAY_BUFFER, 0, ..., GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
//     ... plan->write(typemesh::into(std::span{static_cast<engines::opengl::vertex*>(at), n}, indices))
//     engines::opengl::describe(glVertexAttribPointer);       // and glEnableVertexAttribArray(0 to 3)

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/ten_bit.hpp>

#include <cstddef>

namespace engines::opengl {

struct vertex {
    float position[3];          // location 0
    typemesh::snorm10 normal;   // location 1
    typemesh::snorm10 tangent;  // location 2; bitangent = tangent.w * cross(normal, tangent.xyz)
    typemesh::half uv[2];       // location 3
};
static_assert(sizeof(vertex) == 24);

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    o.frame.uv = typemesh::uv_origin::bottom_left;
    return o;
}

/// Calls glVertexAttribPointer, or your wrapper of it, for each attribute.
template <class Pointer>
void describe(Pointer&& gl_vertex_attrib_pointer, std::size_t first_byte = 0)
{
    const auto say = [&](GLuint location, GLint size, GLenum type, GLboolean normalised, std::size_t offset) {
        gl_vertex_attrib_pointer(location, size, type, normalised, static_cast<GLsizei>(sizeof(vertex)),
                                 reinterpret_cast<const void*>(first_byte + offset));
    };
    say(0, 3, GL_FLOAT, GL_FALSE, offsetof(vertex, position));
    say(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, offsetof(vertex, normal));
    say(2, 4, GL_INT_2_10_10_10_REV, GL_TRUE, offsetof(vertex, tangent));
    say(3, 2, GL_HALF_FLOAT, GL_FALSE, offsetof(vertex, uv));
}

}  // namespace engines::opengl

template <>
struct typemesh::vertex_traits<engines::opengl::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    engines::opengl::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z},
                {s.normal.x, s.normal.y, s.normal.z},
                {s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w},
                {s.uv.x, s.uv.y}};
    }
};
