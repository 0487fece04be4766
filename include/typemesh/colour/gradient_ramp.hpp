// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>
#include <optional>

namespace typemesh::inline TYPEMESH_ABI {

/// The texture coordinate of a point of a glyph (in font units) in the ramp of a gradient: 0 at its first stop, 1 at
/// its last one, beyond them less than 0 or more than 1. A sampler that clamps, repeats or mirrors (by paint.extend:
/// pad, repeat, reflect) then finds the colour in a texture of one row, which ramp_colour() fills. Empty: the gradient
/// does not paint the point (see gradient_place()), or there are no stops.
///
///     if (auto u = ramp_coordinate(own->paint, colours.stops_of(*own), place)) vertex.u = *u;
///
/// For a linear gradient the coordinate is linear in the point, so triangles of any size show it exactly. For radial
/// and sweep gradients it is not: it is right at vertices only, and triangles must be small (delaunay_refined with
/// max_edge). A sweep also jumps where its turn begins, and triangles across that line run through all colours.
[[nodiscard]] inline std::optional<double> ramp_coordinate(const glyph_paint& paint,
                                                           array_view<const gradient_stop> stops, point at) noexcept
{
    if (stops.empty()) return {};
    const auto place = gradient_place(paint, at);
    if (!place) return {};
    const double first = stops.front().at, length = stops.back().at - first;
    if (!(length > 0.0)) return *place < first ? 0.0 : 1.0;
    return (*place - first) / length;
}

/// The colour of a texel of a ramp's texture, which lies at (texel + 0.5) / width. Black without stops. Between two
/// texels a sampler mixes, so a hard change between two stops at one place becomes as wide as a texel.
[[nodiscard]] inline palette_colour ramp_colour(array_view<const gradient_stop> stops, std::uint32_t texel,
                                                std::uint32_t width) noexcept
{
    if (stops.empty()) return {};
    const double first = stops.front().at, length = stops.back().at - first;
    const double share = (static_cast<double>(texel) + 0.5) / static_cast<double>(width);
    if (!(length > 0.0)) return share < 0.5 ? stops.front().colour : stops.back().colour;
    return gradient_colour(stops, gradient_extend::pad, first + share * length);
}

}  // namespace typemesh::inline TYPEMESH_ABI
