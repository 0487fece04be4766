// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Draws a curve into a sink, whose pen must be where the curve begins.
template <outline_sink Sink>
void draw_curve(const curve& c, Sink& sink) noexcept
{
    if (c.degree == 1)
        sink.line(c.p[1]);
    else if (c.degree == 2)
        sink.quadratic(c.p[1], c.p[2]);
    else
        sink.cubic(c.p[1], c.p[2], c.p[3]);
}

/// Draws contours that are stored as curves into a sink: the reverse of outline_recorder. Recording them again gives
/// the same contours.
///
///     curves    of all contours, one after the other
///     starts    the number of the first curve of each contour, and at last the number behind the last one; it may be
///               empty. No contour is empty
template <outline_sink Sink>
void draw_outline(array_view<const curve> curves, array_view<const std::uint32_t> starts, Sink& sink) noexcept
{
    for (std::size_t k = 1; k < starts.size(); ++k) {
        sink.move(curves[starts[k - 1]].start());
        for (const curve& c : curves.subspan(starts[k - 1], starts[k] - starts[k - 1])) draw_curve(c, sink);
        sink.close();
    }
}
template <outline_sink Sink>
void draw_outline(const outline& drawn, Sink& sink) noexcept
{
    draw_outline(array_view<const curve>{drawn.curves}, array_view<const std::uint32_t>{drawn.starts}, sink);
}

}  // namespace typemesh::inline TYPEMESH_ABI
