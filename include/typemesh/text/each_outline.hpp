// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/flat_outline.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_sink.hpp>
#include <typemesh/text/text_plan.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Gives the outlines of a planned text to an outline sink: the boundary of the filled letters, as curves, in output
/// units, at their places in the text.
///
///     text_mesher mesher{font, flat_outline{}};
///     each_outline(plan, i, sink)         for one of plan.glyphs()
///     each_outline(plan, sink)            for all of them, in their order
///
/// Outer loops run counter-clockwise and holes clockwise. Each loop begins with move() and ends with close(). If the
/// text's frame turns it out of the plane, z is left out. Letters that overlap do so in their outlines too, unless
/// text_options::merge joins them.
///
/// Cost   O(curves); nothing is allocated
template <outline_sink Sink>
void each_outline(const text_plan<flat_outline>& plan, std::size_t glyph, Sink&& sink) noexcept
{
    const auto pieces =
        plan.glyphs()[glyph].built->template planned<flat_outline>().form.data.template of<boundary_piece>();
    const placement at = plan.place(glyph);
    const auto placed = [&at](point p) noexcept {
        const double x = (p.x + at.pen.x) * at.unit_per_cell, y = (p.y + at.pen.y) * at.unit_per_cell;
        const vec3 right = at.frame.right, up = at.frame.up;
        return point{as_double(right.x) * x + as_double(up.x) * y, as_double(right.y) * x + as_double(up.y) * y};
    };
    bool open = false;
    for (const boundary_piece& piece : pieces) {
        curve c = piece.shape;
        for (std::uint32_t i = 0; i <= c.degree; ++i) c.p[i] = placed(c.p[i]);
        if (piece.begins != 0) {
            if (open) sink.close();
            sink.move(c.start());
            open = true;
        }
        draw_curve(c, sink);
    }
    if (open) sink.close();
}
template <outline_sink Sink>
void each_outline(const text_plan<flat_outline>& plan, Sink&& sink) noexcept
{
    for (std::size_t i = 0; i < plan.glyphs().size(); ++i) each_outline(plan, i, sink);
}

}  // namespace typemesh::inline TYPEMESH_ABI
