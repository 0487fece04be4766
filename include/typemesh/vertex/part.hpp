// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The parts of a mesh; each may have a material of its own. In the output, the vertices of a part are contiguous, and
/// so are its indices. Parts come in this order.
///
/// bevelled.hpp uses the bevels. Extruders may have any other parts after the first three, up to eight in all: part{3}
/// and so on (see extruder.hpp).
enum class part : std::uint8_t { front, back, side, front_bevel, back_bevel };

inline constexpr std::size_t max_parts = 8;  ///< the greatest number of parts that an extruder may have

/// Every part that a mesh may have. Parts that its extruder does not have are empty; text_plan::parts() omits them.
inline constexpr part all_parts[max_parts] = {part::front,      part::back, part::side, part::front_bevel,
                                              part::back_bevel, part{5},    part{6},    part{7}};

}  // namespace typemesh::inline TYPEMESH_ABI
