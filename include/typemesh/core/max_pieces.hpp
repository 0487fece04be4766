// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The default limit for the number of pieces into which crossings divide a glyph's contours. If each edge crosses
/// nearly all others, this number of pieces takes 0.4 s and 130 MB of scratch memory; it never takes more than 210 MB.
/// Some 3,700 font files of Debian have 6.8 million glyphs; at 1/16000 em, none of them has more than 12,642 pieces
/// (Aegean, glyph 3931).
inline constexpr std::uint32_t default_max_pieces = 1'000'000;

}  // namespace typemesh::inline TYPEMESH_ABI
