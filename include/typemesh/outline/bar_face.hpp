// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/outline_sink.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of a face that every outline source has besides its own. Whatever the glyph, it draws the square from
/// (0, 0) to (1, 1), in units of the source's first face: the map of a look makes an underline of it.
inline constexpr std::uint32_t bar_face = 0xFFFF'FFFFu;

/// Draws that square.
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
