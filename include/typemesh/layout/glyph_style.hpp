// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/mixed_key.hpp>

#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// The way a glyph of a run is drawn: its face, its map and its style.
///
///     {}                                 the source's first face, unchanged
///     {.face = 1}                        another face, with the same em size as the first one
///     {.map = {.xx = 0.6, .yy = 0.6}}    small letters, as deep as the others
///     {.map = {.xy = 0.2}}               slanted
///     {.style = style_id{3}}             with its own material or colour
///
/// Glyph styles that differ only in their style share their meshes.
struct glyph_style {
    std::uint32_t face = 0;  ///< the face of the outline source: see outline/face_source.hpp. Bars have bar_face,
                             ///< 0xFFFFFFFF
    affine map = {};         ///< the map of the outline, around the glyph's own (0, 0), in the run's units
    style_id style = {};     ///< the caller's number

    friend constexpr bool operator==(const glyph_style& a, const glyph_style& b) noexcept
    {
        return a.face == b.face && a.map == b.map && a.style == b.style;
    }

    /// Equal glyph styles have equal hashes.
    friend std::uint64_t hash_of(const glyph_style& l) noexcept
    {
        std::uint64_t hash = mixed_key(l.face, static_cast<std::uint64_t>(l.style));
        for (double number : {l.map.xx, l.map.xy, l.map.dx, l.map.yx, l.map.yy, l.map.dy}) {
            number += 0.0;  // turns -0 into +0
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            hash = mixed_key(hash, bits);
        }
        return hash;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
