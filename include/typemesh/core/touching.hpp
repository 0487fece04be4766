// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// What becomes of corners in which the boundary of filled area touches itself. Above such a point stands an upright
/// edge with four faces, which slicers do not mind, and programs that compute with solids refuse (OpenSCAD, CGAL).
///
///         |:::::          / ::::         /::::::
///     ----+------     ---' .------    --'  .------     keep     the region stays as it is drawn
///     ::::|           ::::/           :::::/           part     its corners recede: the pieces stand apart
///      keep            part            join            join     a small bridge fills the gap between them
enum class touching : std::uint8_t { keep, part, join };

}  // namespace typemesh::inline TYPEMESH_ABI
