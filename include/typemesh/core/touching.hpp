// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The treatment of corners at which the boundary of the filled area touches itself. In the mesh, a vertical edge with
/// four faces stands above each of these points. Slicers accept this edge; programs that compute with solids (OpenSCAD,
/// CGAL) refuse it.
///
///         |:::::          / ::::         /::::::
///     ----+------     ---' .------    --'  .------     keep     the region stays as it is drawn
///     ::::|           ::::/           :::::/           part     its corners recede, which leaves a gap between them
///      keep            part            join            join     a small bridge connects its corners
enum class touching : std::uint8_t { keep, part, join };

}  // namespace typemesh::inline TYPEMESH_ABI
