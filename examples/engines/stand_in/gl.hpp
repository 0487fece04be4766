// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from OpenGL's headers, by the names and values of the specification.

using GLenum = unsigned;
using GLuint = unsigned;
using GLint = int;
using GLsizei = int;
using GLboolean = unsigned char;

inline constexpr GLboolean GL_FALSE = 0, GL_TRUE = 1;
inline constexpr GLenum GL_FLOAT = 0x1406, GL_HALF_FLOAT = 0x140B, GL_INT_2_10_10_10_REV = 0x8D9F;
