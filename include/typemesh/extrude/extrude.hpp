// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/planned_sink.hpp>
#include <typemesh/extrude/placed_bounds.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Emits a solid's vertices of one part into a sink. Adds their glyph, cluster, part and style if the sink wants them.
template <extruder Extruder, mesh_sink Sink>
void write_vertices(part p, const solid_of<Extruder>& s, const Extruder& how, const placement& at, Sink& sink) noexcept
{
    constexpr attribute wants = Sink::wants;
    if constexpr (has(wants, attribute::glyph | attribute::cluster | attribute::part | attribute::style)) {
        how.template vertices<wants>(p, s, at, [&](const surface_point<wants>& v) noexcept {
            surface_point<wants> named = v;
            if constexpr (has(wants, attribute::glyph)) named.glyph = at.glyph;
            if constexpr (has(wants, attribute::cluster)) named.cluster = at.cluster;
            if constexpr (has(wants, attribute::part)) named.part = p;
            if constexpr (has(wants, attribute::style)) named.style = at.style;
            sink.vertex(named);
        });
    } else {
        how.template vertices<wants>(p, s, at, [&sink](const surface_point<wants>& v) noexcept { sink.vertex(v); });
    }
}

/// Emits a solid's triangles of one part into a sink, reversed if the frame requires it (frame::turns_triangles()).
template <extruder Extruder, mesh_sink Sink>
void write_triangles(part p, const solid_of<Extruder>& s, const Extruder& how, const first_vertices& first, bool turned,
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

/// Emits these vertices; in debug builds it also checks the extruder against its plan(): surplus output is discarded.
template <extruder Extruder, mesh_sink Sink>
void write_vertices(part p, const planned_solid_of<Extruder>& s, const Extruder& how, const placement& at,
                    Sink& sink) noexcept
{
    detail::planned_vertices<Sink> to{sink, s.plan.sizes.vertices[p]};
    TYPEMESH_ASSERT(
        (to.bounds = detail::promised_bounds(s.plan.around, s.form.points, heights_of(how, s.form), at), true),
        "filled in");
    write_vertices(p, s.form, how, at, to);
    TYPEMESH_ASSERT(to.emitted >= to.planned, "an extruder emitted fewer vertices of a part than its plan() reported");
}
/// Emits the triangles of a part with these checks.
template <extruder Extruder, mesh_sink Sink>
void write_triangles(part p, const planned_solid_of<Extruder>& s, const Extruder& how, const first_vertices& first,
                     bool turned, Sink& sink) noexcept
{
    detail::planned_triangles<Sink> to{sink, s.plan.sizes, first, s.plan.sizes.triangles[p]};
    write_triangles(p, s.form, how, first, turned, to);
    TYPEMESH_ASSERT(to.emitted >= to.planned, "an extruder emitted fewer triangles of a part than its plan() reported");
}

/// Writes one solid: all vertices, then all triangles.
///
/// Fails  error::too_large, or as the sink's begin() does, and then writes nothing; or as the sink's end() does
template <extruder Extruder, mesh_sink Sink>
result<void> write_solid(const planned_solid_of<Extruder>& s, const Extruder& how, const placement& at,
                         Sink& sink) noexcept
{
    const mesh_size exact = s.plan.sizes.total();
    if (!exact.fits_32_bits()) return error::too_large;
    if (error e = sink.begin(exact)) return e;

    for (const part p : parts_of<Extruder>) write_vertices(p, s, how, at, sink);
    const bool turned = at.frame.turns_triangles();
    const first_vertices first = s.plan.sizes.vertices.starts();
    for (const part p : parts_of<Extruder>) write_triangles(p, s, how, first, turned, sink);
    return end_of(sink);
}

/// Turns one region into a solid and writes it: the stage by itself.
///
///     cap      the region's triangles, from any triangulator
///     data     the extruder's plan data; its old content is replaced, and its storage is kept for the next call
///
/// If an extruder needs caps, call plan_solid(), then write_solid().
///
/// Fails  error::bad_option, error::out_of_memory, error::too_large, or any other error of the extruder's plan();
///        nothing is written then. And as write_solid() does
template <extruder Extruder, mesh_sink Sink>
result<void> extrude(const region& filled, array_view<const triangle> cap, const Extruder& how, const placement& at,
                     plan_data_of<Extruder>& data, Sink& sink) noexcept
{
    static_assert(!capping_extruder<Extruder>,
                  "typemesh: this extruder needs caps; call plan_solid() and write_solid()");
    data.clear();
    no_caps nothing;
    const result<solid_plan> plan = plan_solid(how, filled, data, nothing);
    if (!plan) return plan.error();
    const solid_of<Extruder> form{{filled.points(), filled.starts(), cap}, data.read()};
    return write_solid<Extruder>({form, *plan}, how, at, sink);
}

/// Writes the solid without plan data from the caller: for extruders that have none, or for a single call.
template <extruder Extruder, mesh_sink Sink>
result<void> extrude(const region& filled, array_view<const triangle> cap, const Extruder& how, const placement& at,
                     Sink& sink) noexcept
{
    plan_data_of<Extruder> data{heap()};
    return extrude(filled, cap, how, at, data, sink);
}

}  // namespace typemesh::inline TYPEMESH_ABI
