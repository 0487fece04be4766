// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/planned_sink.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Emits a solid's vertices of one part into a sink, and tells them their glyph, cluster and part where the sink wants
/// these.
template <extruder Extruder, mesh_sink Sink>
void write_vertices(part p, const solid& s, const Extruder& how, const placement& at, Sink& sink) noexcept
{
    constexpr attribute wants = Sink::wants;
    if constexpr (has(wants, attribute::glyph | attribute::cluster | attribute::part)) {
        how.template vertices<wants>(p, s, at, [&](const surface_point<wants>& v) noexcept {
            surface_point<wants> named = v;
            if constexpr (has(wants, attribute::glyph)) named.glyph = at.glyph;
            if constexpr (has(wants, attribute::cluster)) named.cluster = at.cluster;
            if constexpr (has(wants, attribute::part)) named.part = p;
            sink.vertex(named);
        });
    } else {
        how.template vertices<wants>(p, s, at, [&sink](const surface_point<wants>& v) noexcept { sink.vertex(v); });
    }
}

/// Emits a solid's triangles of one part into a sink, turned as the frame asks (see frame::turns_triangles()).
template <extruder Extruder, mesh_sink Sink>
void write_triangles(part p, const solid& s, const Extruder& how, const first_vertices& first, bool turned,
                     Sink& sink) noexcept
{
    if (turned) {
        how.triangles(p, s, first,
                      [&sink](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { sink.triangle(a, c, b); });
    } else {
        how.triangles(p, s, first,
                      [&sink](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { sink.triangle(a, b, c); });
    }
}

/// The same, with the extruder held to its plan() in debug builds: what it emits too much is not passed on.
template <extruder Extruder, mesh_sink Sink>
void write_vertices(part p, const planned_solid& s, const Extruder& how, const placement& at, Sink& sink) noexcept
{
    detail::planned_vertices<Sink> to{sink, s.sizes.vertices[p]};
    write_vertices(p, s.form, how, at, to);
    TYPEMESH_ASSERT(to.emitted >= to.planned, "an extruder emitted fewer vertices of a part than its plan() said");
}
template <extruder Extruder, mesh_sink Sink>
void write_triangles(part p, const planned_solid& s, const Extruder& how, const first_vertices& first, bool turned,
                     Sink& sink) noexcept
{
    detail::planned_triangles<Sink> to{sink, s.sizes, first, s.sizes.triangles[p]};
    write_triangles(p, s.form, how, first, turned, to);
    TYPEMESH_ASSERT(to.emitted >= to.planned, "an extruder emitted fewer triangles of a part than its plan() said");
}

/// The stage by itself: puts one region up into space and writes it.
///
///     cap      the region's triangles, from any triangulator
///     sides    scratch; what it held before is forgotten, its storage stays for the next call
///
/// Fails  error::bad_option, error::out_of_memory, error::too_large, or what else the extruder's plan() or the sink's
///        begin() say; nothing is written then.
template <extruder Extruder, mesh_sink Sink>
error extrude(const region& shape, std::span<const triangle> cap, const Extruder& how, const placement& at,
              buffer<side_point>& sides, Sink& sink) noexcept
{
    sides.clear();
    const result<part_sizes> sizes = how.plan(shape, sides);
    if (!sizes) return sizes.error();

    const mesh_size exact = sizes->total();
    if (!exact.fits_32_bits()) return error::too_large;
    if (error e = sink.begin(exact)) return e;

    const solid s{shape.points(), shape.starts(), cap, sides.view()};
    const planned_solid planned{s, *sizes};
    for (const part p : parts_of<Extruder>) write_vertices(p, planned, how, at, sink);
    const bool turned = at.frame.turns_triangles();
    for (const part p : parts_of<Extruder>) write_triangles(p, planned, how, sizes->vertices.starts(), turned, sink);
    sink.end();
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
