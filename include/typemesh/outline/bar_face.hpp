// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of an extra face that every outline source has. Its glyphs draw in the square from (0, 0) to (1, 1), in
/// units of the source's first face. The map of a glyph style turns this square into an underline or a background.
///
///     0 and others          the whole square
///     rounded_bar(...)      the square with round corners
///     blank_bar + index     nothing: the place of an inline box
inline constexpr std::uint32_t bar_face = 0xFFFF'FFFFu;

/// The first glyph of bar_face that draws nothing.
inline constexpr glyph_id blank_bar = 0x8000'0000u;
/// Whether a glyph of bar_face draws nothing.
[[nodiscard]] constexpr bool is_blank_bar(glyph_id id) noexcept { return id >= blank_bar; }

/// The glyph of bar_face whose corners are quarters of ellipses. The radii are given as parts of the square's width and
/// height, 0 to 0.5; others are clamped. They are rounded down to multiples of 2^-15; a radius that is then 0 in one
/// direction gives sharp corners.
[[nodiscard]] constexpr glyph_id rounded_bar(double across, double along) noexcept
{
    const auto part = [](double r) noexcept {
        return r > 0.0 ? static_cast<std::uint32_t>((r < 0.5 ? r : 0.5) * 0x1p15) : 0u;  // up to 2^14
    };
    const std::uint32_t x = part(across), y = part(along);
    return x == 0 || y == 0 ? 0u : x << 15 | y;
}

/// Draws a glyph of bar_face. A round corner is one cubic curve, within 0.03 % of its radius.
template <outline_sink Sink>
void draw_bar(Sink& sink, glyph_id id) noexcept
{
    if (is_blank_bar(id)) return;
    const double x = static_cast<double>(id >> 15) * 0x1p-15, y = static_cast<double>(id & 0x7FFFu) * 0x1p-15;
    if (!(x > 0.0) || !(y > 0.0)) {
        sink.move({0.0, 0.0});
        sink.line({1.0, 0.0});
        sink.line({1.0, 1.0});
        sink.line({0.0, 1.0});
        return sink.close();
    }
    constexpr double flat = 1.0 - 0.5522847498307936;  // of a control point from the corner, in radii
    sink.move({x, 0.0});
    if (x < 0.5) sink.line({1.0 - x, 0.0});
    sink.cubic({1.0 - flat * x, 0.0}, {1.0, flat * y}, {1.0, y});
    if (y < 0.5) sink.line({1.0, 1.0 - y});
    sink.cubic({1.0, 1.0 - flat * y}, {1.0 - flat * x, 1.0}, {1.0 - x, 1.0});
    if (x < 0.5) sink.line({x, 1.0});
    sink.cubic({flat * x, 1.0}, {0.0, 1.0 - flat * y}, {0.0, 1.0 - y});
    if (y < 0.5) sink.line({0.0, y});
    sink.cubic({0.0, flat * y}, {flat * x, 0.0}, {x, 0.0});
    sink.close();
}

}  // namespace typemesh::inline TYPEMESH_ABI
