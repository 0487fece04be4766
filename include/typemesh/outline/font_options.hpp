// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// One axis of a variable font set to a value, such as {"wght", 700}: the axis's tag of four letters, and a value in
/// the axis's unit. Values beyond the axis's range are clamped, as OpenType requires. Axes that are not named keep
/// their default.
struct variation {
    char tag[5] = {};
    float value = 0.0f;
};

/// A face of a font file, and its position on the variation axes. These options are read while the font is opened, and
/// not kept.
struct font_options {
    std::uint32_t face = 0;                      ///< the number of the face in a collection (.ttc, .otc); 0 for other
                                                 ///< files
    std::span<const variation> variations = {};  ///< the axes to set; error::unknown_variation if the font has no such
                                                 ///< axis
};

}  // namespace typemesh::inline TYPEMESH_ABI
