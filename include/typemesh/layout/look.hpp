// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/mixed_key.hpp>

#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// How a glyph of a run is drawn: from which face, through which map, in which style.
///
///     {}                                 the source's first face as it is
///     {.face = 1}                        another face, its em as large as the first one's
///     {.map = {.xx = 0.6, .yy = 0.6}}    small letters, as deep as the others
///     {.map = {.xy = 0.2}}               slanted
///     {.style = style_id{3}}             with a material or colour of its own
///
/// Looks that differ only in style share what is built.
struct look {
    std::uint32_t face = 0;  ///< of the outline source; see outline/face_source.hpp, and bar_face.hpp for bars
    affine map = {};         ///< of the outline, about the glyph's own (0, 0), in the run's units
    style_id style = {};     ///< the caller's number

    friend constexpr bool operator==(const look& a, const look& b) noexcept
    {
        return a.face == b.face && a.map == b.map && a.style == b.style;
    }

    /// Equal for equal looks.
    friend std::uint64_t hash_of(const look& l) noexcept
    {
        std::uint64_t hash = mixed_key(l.face, static_cast<std::uint64_t>(l.style));
        for (double number : {l.map.xx, l.map.xy, l.map.dx, l.map.yx, l.map.yy, l.map.dy}) {
            number += 0.0;  // of both zeros one
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            hash = mixed_key(hash, bits);
        }
        return hash;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
