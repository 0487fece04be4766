// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/glyph_style.hpp>
#include <typemesh/layout/impl/item_settings.hpp>
#include <typemesh/layout/shaped_glyph.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The glyph style of a glyph of an item, from the item's setting and the style that paints it.
[[nodiscard]] inline glyph_style glyph_style_of(const text_item& item, const item_setting& set,
                                                const text_style& painted, const shaped_glyph& glyph) noexcept
{
    glyph_style drawn{.face = glyph.face, .style = painted.style};
    const double size = set.scale, leaning = size * painted.slant;
    const double squeeze = has(glyph.flags, glyph_flags::combined) ? item.squeeze : 1.0;
    if (has(glyph.flags, glyph_flags::sideways))
        drawn.map = {.xx = 0.0, .xy = size, .yx = 0.0 - size, .yy = 0.0 - leaning};
    else
        drawn.map = {.xx = squeeze * size, .xy = squeeze * leaning, .yy = size};
    return drawn;
}

}  // namespace typemesh::inline TYPEMESH_ABI
