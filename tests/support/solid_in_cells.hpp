// SPDX-License-Identifier: MIT
#pragma once

// Regions of outlines, and solids of regions, by the stages' own functions.

#include <typemesh/extrude/extrude.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/typemesh.hpp>

namespace test {

/// The region of an outline, whose points `caps` keeps; without points if the outline has no region.
template <class Triangulator = typemesh::monotone>
typemesh::region region_of(typemesh::cap_builder& caps, const typemesh::outline& drawn, double units_per_em,
                           double tolerance_em, const Triangulator& cut = {})
{
    using namespace typemesh;
    const auto cells = grid::fitting(units_per_em, drawn.bounds);
    if (!cells) return {};
    no_observer nobody;
    const auto made = caps.build(drawn, tolerance_em * units_per_em, *cells, {drawn.rule},
                                 policies{certified{}, cut, flat{}, nobody});
    return made ? *made : region{};
}

/// The size of a region's em, in cells.
inline double em_of(const typemesh::region& r) { return r.grid().units_per_em * r.grid().cells; }

/// Plans a solid of a region whose triangles `caps` has, and writes it with all coordinates in cells.
template <class Extruder, class Mesh, class Triangulator = typemesh::monotone>
typemesh::result<typemesh::solid_plan> write_in_cells(const Extruder& how, const typemesh::region& r,
                                                      typemesh::cap_builder& caps, double em,
                                                      typemesh::plan_data_of<Extruder>& data, Mesh& mesh,
                                                      const Triangulator& cut = {})
{
    using namespace typemesh;
    data.clear();
    cap_builder further;
    region_caps maker{caps, further, cut};
    const auto plan = plan_solid(how, r, data, maker);
    if (!plan) return plan;
    placement at;
    at.unit_per_depth = em;
    at.em_per_cell = 1.0 / em;
    if constexpr (requires { mesh.sizes; }) mesh.sizes = plan->sizes;
    const solid_of<Extruder> form{{r.points(), r.starts(), caps.triangles().view()}, data.read()};
    if (const auto done = write_solid<Extruder>({form, *plan}, how, at, mesh); !done) return done.error();
    return plan;
}

}  // namespace test
