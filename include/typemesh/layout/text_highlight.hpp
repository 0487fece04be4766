// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A range of a text with a background.
struct text_highlight {
    std::uint32_t first = 0;  ///< the range of the text, in its units
    std::uint32_t last = 0;
    style_id style = {};  ///< of the background, for its material and its solid
};

}  // namespace typemesh::inline TYPEMESH_ABI
