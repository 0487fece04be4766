// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/same.hpp>
#include <typemesh/layout/look.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/paragraph/item_settings.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// How a glyph of an item is drawn that is set so and painted so.
[[nodiscard]] inline look look_of(const item_setting& set, const text_style& painted,
                                  const shaped_glyph& glyph) noexcept
{
    look drawn{.face = glyph.face, .style = painted.style};
    if (!same(set.scale, 1.0) || !is_zero(painted.slant))
        drawn.map = {.xx = set.scale, .xy = set.scale * painted.slant, .yy = set.scale};
    return drawn;
}

}  // namespace typemesh::inline TYPEMESH_ABI
