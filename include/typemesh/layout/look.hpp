// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstdint>

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
};

}  // namespace typemesh::inline TYPEMESH_ABI
