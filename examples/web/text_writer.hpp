// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_arrays.hpp"

#include <typemesh/text/text_plan.hpp>

namespace typemesh_web {

/// Writes a plan of one of the extruders of any_solid.hpp. Compiled apart, for speed, as this runs for each vertex of each
/// text; what builds letters is compiled for size.
template <typemesh::extruder Extruder>
[[nodiscard]] typemesh::error write_whole(const typemesh::text_plan<Extruder>& plan, mesh_arrays& out) noexcept;

/// The same as different letters and where they stand.
template <typemesh::extruder Extruder>
[[nodiscard]] typemesh::error write_letters(const typemesh::text_plan<Extruder>& plan, mesh_arrays& out) noexcept;

}  // namespace typemesh_web
