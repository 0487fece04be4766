// SPDX-License-Identifier: MIT
#include <typemesh/compiled/harfbuzz.hpp>

namespace typemesh::inline TYPEMESH_ABI {

template error text_planner::layout(text_view, const text_options&, const policies&, glyph_team*) noexcept;
template error text_planner::plan(const glyph_run&, const text_options&, const policies&, glyph_team*) noexcept;

template struct font_ref::table<harfbuzz_font>;
template struct shaper_ref::table<harfbuzz_font>;

template struct discretiser_ref::table<certified>;
template struct discretiser_ref::table<adaptive_subdivision>;
template struct discretiser_ref::table<thesis_quality>;
template struct discretiser_ref::table<two_lines>;

template struct triangulator_ref::table<monotone>;
template struct triangulator_ref::table<constrained_delaunay>;

template struct region_step_ref::table<embolden>;

template result<solid_plan> plan_solid(const extruded<>&, const region&, plan_data_of<extruded<>>&,
                                       region_caps&) noexcept;
template result<solid_plan> plan_solid(const extruded<>&, const region&, plan_data_of<extruded<>>&, no_caps&) noexcept;
template result<solid_plan> plan_solid(const bevelled&, const region&, plan_data_of<bevelled>&, region_caps&) noexcept;
template result<solid_plan> plan_solid(const bevelled&, const region&, plan_data_of<bevelled>&, no_caps&) noexcept;
template result<solid_plan> plan_solid(const outlined<>&, const region&, plan_data_of<outlined<>>&,
                                       region_caps&) noexcept;
template result<solid_plan> plan_solid(const outlined<>&, const region&, plan_data_of<outlined<>>&, no_caps&) noexcept;

template struct solid_ref::table<flat>;
template struct solid_ref::table<extruded<>>;
template struct solid_ref::table<extruded<averaged_normals>>;
template struct solid_ref::table<extruded<creased_normals>>;
template struct solid_ref::table<extruded<shared_normals>>;
template struct solid_ref::table<bevelled>;
template struct solid_ref::table<outlined<>>;

}  // namespace typemesh::inline TYPEMESH_ABI
