// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// One axis of a variable font set to a value, such as {"wght", 700}: the axis's tag of four letters, and a value in
/// its own unit. Values beyond the axis's range are clamped, as OpenType says; axes that are not named keep their
/// default.
struct variation {
    char tag[5] = {};
    float value = 0.0f;
};

/// Which face of a font file, and its position on the variation axes. Read while the font is opened, not kept.
struct font_options {
    std::uint32_t face = 0;                      ///< in a collection (.ttc, .otc); 0 for other files
    std::span<const variation> variations = {};  ///< error::unknown_variation where the font has no such axis
};

}  // namespace typemesh::inline TYPEMESH_ABI
