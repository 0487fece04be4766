// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/text/text_plan.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// Takes polylines: move() begins one, line() goes on to the next point. Both get positions as vertices have them.
template <class S>
concept ridge_sink = requires(S& sink, const vec3& at) {
    { sink.move(at) } noexcept;
    { sink.line(at) } noexcept;
};

/// Gives the ridges of one glyph of a carved text to a sink: the lines in which its slopes meet, and the outlines of
/// its floor. These are the paths of the tip of a V-bit that carves the text.
///
///     text_mesher mesher{*font, carved{.as = carving::groove, .ridges = true}};
///     each_ridge(plan, i, sink)         for one of plan.glyphs()
///     each_ridge(plan, sink)            for all of them, in their order
///
///     \               /     The tip runs along ridges at their depth, and rises into the corners of the outline up to
///      \     tip     /      z = 0. Each ridge is written once, from one end or junction to the next (find_ridges.hpp).
///       \     |     /       A ridge around a hole, and an outline of the floor, end with their first point. A polyline
///        \    v    /        of one point is the middle of a disc.
///         '-------'
///
/// The points lie on the surface of the mesh. Nothing is written for a text without carved::ridges.
///
/// Cost   O(points written); nothing is allocated
template <ridge_sink Sink>
void each_ridge(const text_plan<carved>& plan, std::size_t glyph, Sink&& sink) noexcept
{
    const auto own = plan.glyphs()[glyph].built->template planned<carved>().form.data.own;
    const placement at = plan.place(glyph);
    for (const ridge_point& p : own.template of<ridge_point>()) {
        const double height = own.template of<carved_depth>()[0].height_at(p.distance);
        const vec3 here = at.position(solid_point{static_cast<double>(p.at.x), static_cast<double>(p.at.y), height});
        if (p.step == ridge_step::on)
            sink.line(here);
        else
            sink.move(here);
    }
}
template <ridge_sink Sink>
void each_ridge(const text_plan<carved>& plan, Sink&& sink) noexcept
{
    for (std::size_t i = 0; i < plan.glyphs().size(); ++i) each_ridge(plan, i, sink);
}

}  // namespace typemesh::inline TYPEMESH_ABI
