// SPDX-License-Identifier: MIT
#pragma once

// The parts that most programs use, compiled once for each program: link typemesh::compiled. That target adds
// harfbuzz.cpp (beside this file) to your sources, to be compiled with your flags, and defines TYPEMESH_COMPILED, with
// which <typemesh/typemesh.hpp> includes this file. Without CMake, do both yourself; define the macro for all units of
// a target.
//
// Each policy and solid has a table of functions that are called once per glyph. The library's own tables are compiled
// there, in any combination. Code that depends on your vertices, and your own policies, remains in your own units.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/thesis_quality.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/shared_normals.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

namespace typemesh::inline TYPEMESH_ABI {

extern template error text_planner::layout(text_view, const text_options&, const policies&, glyph_team*) noexcept;
extern template error text_planner::plan(const glyph_run&, const text_options&, const policies&, glyph_team*) noexcept;

extern template struct font_ref::table<harfbuzz_font>;
extern template struct shaper_ref::table<harfbuzz_font>;

extern template struct discretiser_ref::table<certified>;
extern template struct discretiser_ref::table<adaptive_subdivision>;
extern template struct discretiser_ref::table<thesis_quality>;
extern template struct discretiser_ref::table<two_lines>;

extern template struct triangulator_ref::table<monotone>;
extern template struct triangulator_ref::table<constrained_delaunay>;

extern template struct region_step_ref::table<embolden>;

// one_of plans with these; the overloads without caps check options.
extern template result<solid_plan> plan_solid(const extruded<>&, const region&, plan_data_of<extruded<>>&,
                                              region_caps&) noexcept;
extern template result<solid_plan> plan_solid(const extruded<>&, const region&, plan_data_of<extruded<>>&,
                                              no_caps&) noexcept;
extern template result<solid_plan> plan_solid(const bevelled&, const region&, plan_data_of<bevelled>&,
                                              region_caps&) noexcept;
extern template result<solid_plan> plan_solid(const bevelled&, const region&, plan_data_of<bevelled>&,
                                              no_caps&) noexcept;
extern template result<solid_plan> plan_solid(const outlined<>&, const region&, plan_data_of<outlined<>>&,
                                              region_caps&) noexcept;
extern template result<solid_plan> plan_solid(const outlined<>&, const region&, plan_data_of<outlined<>>&,
                                              no_caps&) noexcept;

extern template struct solid_ref::table<flat>;
extern template struct solid_ref::table<extruded<>>;
extern template struct solid_ref::table<extruded<averaged_normals>>;
extern template struct solid_ref::table<extruded<creased_normals>>;
extern template struct solid_ref::table<extruded<shared_normals>>;
extern template struct solid_ref::table<bevelled>;
extern template struct solid_ref::table<outlined<>>;

}  // namespace typemesh::inline TYPEMESH_ABI
