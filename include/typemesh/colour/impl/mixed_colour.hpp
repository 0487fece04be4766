// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/core/impl/same.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// One channel of a colour over one of a backdrop, both opaque and from 0 to 1, in a separable blend mode of COLR.
/// Other modes give the colour itself.
///
/// From  W3C, Compositing and Blending Level 1
[[nodiscard]] inline double blended_channel(std::uint32_t mode, double backdrop, double source) noexcept
{
    const double b = backdrop, s = source;
    const auto hard = [](double under, double over) noexcept {
        if (over <= 0.5) return under * 2.0 * over;
        return under + (2.0 * over - 1.0) * (1.0 - under);
    };
    switch (mode) {
    case 12: return b + s < 1.0 ? b + s : 1.0;                                  // plus
    case 13: return b + s - b * s;                                              // screen
    case 14: return hard(s, b);                                                 // overlay
    case 15: return b < s ? b : s;                                              // darken
    case 16: return b > s ? b : s;                                              // lighten
    case 17: return b <= 0.0 ? 0.0 : b >= 1.0 - s ? 1.0 : b / (1.0 - s);        // colour dodge
    case 18: return b >= 1.0 ? 1.0 : 1.0 - b >= s ? 0.0 : 1.0 - (1.0 - b) / s;  // colour burn
    case 19: return hard(b, s);                                                 // hard light
    case 20: {                                                                  // soft light
        if (s <= 0.5) return b - (1.0 - 2.0 * s) * b * (1.0 - b);
        const double lifted = b <= 0.25 ? ((16.0 * b - 12.0) * b + 4.0) * b : std::sqrt(b);
        return b + (2.0 * s - 1.0) * (lifted - b);
    }
    case 21: return b > s ? b - s : s - b;  // difference
    case 22: return b + s - 2.0 * b * s;    // exclusion
    case 23: return b * s;                  // multiply
    default: return s;
    }
}

/// A colour painted over a backdrop, in sRGB as browsers do it.
///
///     mode   colour_layer::blend
[[nodiscard]] inline palette_colour mixed_colour(const palette_colour& backdrop, const palette_colour& source,
                                                 std::uint32_t mode) noexcept
{
    const double under = as_double(backdrop.alpha), over = as_double(source.alpha), alpha = over + under * (1.0 - over);
    if (!(alpha > 0.0)) return {source.red, source.green, source.blue, 0.0f};
    const auto channel = [&](std::uint8_t b, std::uint8_t s) noexcept {
        const double back = b / 255.0, own = s / 255.0;
        const double seen = own * (1.0 - under) + blended_channel(mode, back, own) * under;
        const double mixed = (seen * over + back * under * (1.0 - over)) / alpha * 255.0 + 0.5;
        return static_cast<std::uint8_t>(mixed < 0.0 ? 0.0 : mixed > 255.0 ? 255.0 : mixed);
    };
    return {channel(backdrop.red, source.red), channel(backdrop.green, source.green),
            channel(backdrop.blue, source.blue), static_cast<float>(alpha)};
}

/// Whether nothing below a layer shines through it.
[[nodiscard]] inline bool hides(const colour_layer& layer) noexcept
{
    return layer.blend == 0 && !(layer.paint.colour.alpha < 1.0f);
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
