// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The treatment of corners in which the boundary of the filled area touches itself. In the mesh, a vertical edge with
/// four faces stands above such a point. Slicers accept it; programs that compute with solids (OpenSCAD, CGAL) refuse
/// it.
///
///         |:::::          / ::::         /::::::
///     ----+------     ---' .------    --'  .------     keep     the region stays as it is drawn
///     ::::|           ::::/           :::::/           part     its corners recede: the pieces stand apart
///      keep            part            join            join     a small bridge fills the gap between them
enum class touching : std::uint8_t { keep, part, join };

}  // namespace typemesh::inline TYPEMESH_ABI
