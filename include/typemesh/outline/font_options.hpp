// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// One axis of a variable font set to a value, such as {"wght", 700}: four letters of the axis, its own unit.
/// Values beyond the axis' range are brought to its end, as OpenType says; axes not named keep their default.
struct variation {
    char tag[5] = {};
    float value = 0.0f;
};

/// Which face of a font file, and where on its axes. Read while the font is opened, not kept.
struct font_options {
    std::uint32_t face = 0;                      ///< in a collection (.ttc, .otc); 0 for every other file
    std::span<const variation> variations = {};  ///< error::unknown_variation where the font has no such axis
};

}  // namespace typemesh::inline TYPEMESH_ABI
