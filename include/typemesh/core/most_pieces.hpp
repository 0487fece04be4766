// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace typemesh {

/// How many pieces a glyph's contours may fall into where they cross, unless the caller says else: 200 MB of scratch
/// memory, and about a second. The glyphs of Debian's fonts stay far below.
inline constexpr std::uint32_t default_most_pieces = 1'000'000;

}  // namespace typemesh
