// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// One edge of a region as a curve between its grid points. A chord of a curve becomes a cubic with very short handles
/// along the curve's tangents: it deviates from the chord much less than the curve did, so every discretiser that keeps
/// the tolerance makes it the same chord again, while normals still follow the curve.
///
///     p ------------------- q        handles: 1/64 of the chord
///     \_ handle     handle _/
[[nodiscard]] inline curve piece_of(const region& r, contour_edge e, grid_point from, grid_point to) noexcept
{
    const point p = r.grid().place(from), q = r.grid().place(to);
    const curve& source = r.curves()[e.curve];
    if (source.degree == 1) return curve::from(p, q);
    const bool along = e.t0 < e.t1;
    const hodograph slope{source};
    const tangents first = slope.at(as_double(e.t0)), last = slope.at(as_double(e.t1));
    const point leaves = along ? first.after : -1.0 * first.before, arrives = along ? last.before : -1.0 * last.after;
    const point chord = q - p;
    const double size = length(chord), a = length(leaves), b = length(arrives);
    // Rounding may have turned a very short edge away from its curve.
    if (!(dot(leaves, chord) > 0.5 * a * size) || !(dot(arrives, chord) > 0.5 * b * size)) return curve::from(p, q);
    const double handle = size / 64.0;
    return curve::from(cubic{p, p + (handle / a) * leaves, q - (handle / b) * arrives, q});
}

/// Draws a region.
template <outline_sink Sink>
void draw_region(const region& r, Sink& sink) noexcept
{
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
        sink.move(r.grid().place(r.points()[begin]));
        for (std::uint32_t i = begin; i < end; ++i) {
            const grid_point next = r.points()[i + 1 < end ? i + 1 : begin];
            draw_curve(piece_of(r, r.edges()[i], r.points()[i], next), sink);
        }
        sink.close();
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
