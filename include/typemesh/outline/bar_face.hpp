// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/outline_sink.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of an extra face that every outline source has. For any glyph, it draws the square from (0, 0) to (1, 1),
/// in units of the source's first face. The map of a glyph style turns this square into an underline.
inline constexpr std::uint32_t bar_face = 0xFFFF'FFFFu;

/// Draws the square of bar_face.
template <outline_sink Sink>
void draw_bar(Sink& sink) noexcept
{
    sink.move({0.0, 0.0});
    sink.line({1.0, 0.0});
    sink.line({1.0, 1.0});
    sink.line({0.0, 1.0});
    sink.close();
}

}  // namespace typemesh::inline TYPEMESH_ABI
