// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The parts of a layered solid, in the order of the output. As numbers of typemesh::part the first three are front,
/// back and side, and two are the bevels.
enum class plate_part : std::uint8_t {
    front,        ///< the faces towards the reader at the highest level: letters that stand, or the face of a cut plate
    back,         ///< the faces away from the reader
    rim,          ///< the walls on the edges of the sources below `rim_sources`
    front_bevel,  ///< the bevel around the front
    back_bevel,   ///< the bevel around the back
    floor,        ///< the faces towards the reader at lower levels
    wall,         ///< all other walls
    floor_bevel,  ///< the bevels and fillets around floors
};
/// All parts of a layered solid.
inline constexpr plate_part all_plate_parts[] = {plate_part::front,       plate_part::back,       plate_part::rim,
                                                 plate_part::front_bevel, plate_part::back_bevel, plate_part::floor,
                                                 plate_part::wall,        plate_part::floor_bevel};

}  // namespace typemesh::inline TYPEMESH_ABI
