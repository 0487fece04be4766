// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/impl/line_slices.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Adds an inline box that is a cluster, and the room above a cluster, to its extent.
inline void add_inset(const shaped_text& shaped, const text_cluster& c, double rise, bool rooms,
                      line_metrics& here) noexcept
{
    const double em = shaped.units_per_em();
    if (const auto* found = shaped.insets.box_at(c.first); found != nullptr) {
        const inline_box& b = found->box;
        const bool down = shaped.in_columns();
        const double high = rise + em * (down ? 0.5 * b.width : b.ascent);
        const double low = rise - em * (down ? 0.5 * b.width : b.descent);
        if (high > here.ascender) here.ascender = high;
        if (low < here.descender) here.descender = low;
    }
    if (const text_room* room = shaped.insets.room_at(c.first); rooms && room != nullptr && room->above > 0.0)
        here.ascender += room->above * em;
}

}  // namespace detail

/// The extent of a line upwards and downwards: the greatest ascender, the lowest descender and the greatest gap of its
/// glyphs' faces (line_reach_of()), each with the size and rise of its cluster, and what boxes and rooms need. Text of
/// one face in one style, and an empty line, have `plain`, the metrics of the shaper's first face.
///
///     base    null, or the only text that counts, without the rooms above it
///
/// Cost: O(clusters), and O(glyphs) with several faces; constant for a text without styles in one face
template <shaper Font>
[[nodiscard]] line_metrics extent_of(Font& font, const shaped_text& shaped, array_view<const line_slice> slices,
                                     const line_metrics& plain, const text_range* base = nullptr) noexcept
{
    const bool has_faces = shaper_faces(font) > 1;
    if (base == nullptr && shaped.styles.empty() && !has_faces && shaped.insets.empty()) return plain;
    line_metrics found, own = plain;
    std::uint32_t face = 0;
    bool any = false;
    const auto add = [&](const text_cluster& c, std::uint32_t of) noexcept {
        if (of != face) own = of == 0 ? plain : line_reach_of(font, shaped.options().direction, of);
        face = of;
        const item_setting set = shaped.setting_of(c.item);
        const double rise = set.lift + shaped.style_of(c).rise * shaped.units_per_em();
        line_metrics here{own.ascender * set.scale + rise, own.descender * set.scale + rise, own.gap * set.scale};
        if (has(c.flags, cluster_flags::inset)) detail::add_inset(shaped, c, rise, base == nullptr, here);
        if (!any || here.ascender > found.ascender) found.ascender = here.ascender;
        if (!any || here.descender < found.descender) found.descender = here.descender;
        if (!any || here.gap > found.gap) found.gap = here.gap;
        any = true;
    };
    for (const line_slice& s : slices)
        for (std::uint32_t k = s.first; k < s.last; ++k) {
            const text_cluster& c = shaped.cluster(k);
            if (base != nullptr && !base->holds(c.first)) continue;
            if (c.glyph_count == 0) add(c, shaped.items()[c.item].face);
            for (std::uint32_t g = c.glyph; has_faces && g < c.glyph + c.glyph_count; ++g) add(c, shaped.glyph(g).face);
            if (!has_faces && c.glyph_count != 0) add(c, 0);
        }
    return any ? found : plain;
}

}  // namespace typemesh::inline TYPEMESH_ABI
