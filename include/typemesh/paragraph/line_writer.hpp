// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/same.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/paragraph/item_look.hpp>
#include <typemesh/paragraph/line_slices.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Writes the glyphs of a shaped text's slices into a run.
class line_writer {
public:
    line_writer(const shaped_text& shaped, glyph_run& run) noexcept
        : shaped_{shaped}, run_{run}, down_{shaped.upright()}
    {
    }

    /// Appends the glyphs of a slice whose place is `pen` along the line that begins at `origin`.
    ///
    /// Fails  error::out_of_memory
    error write(const line_slice& slice, point origin, double pen) noexcept
    {
        pen += slice.lead;
        const bool back = slice.level % 2 != 0;
        const std::uint32_t item = shaped_.cluster(slice.first).item;
        const text_cluster& low = shaped_.cluster(back ? slice.last - 1 : slice.first);
        const text_cluster& high = shaped_.cluster(back ? slice.first : slice.last - 1);
        const bool whole = back == shaped_.items()[item].to_the_left() &&
                           low.glyph <= high.glyph;  // else a hyphen ends what is read back
        if (whole && is_zero(slice.stretch) && is_zero(slice.spread))
            return append(item, low.glyph, high.glyph + high.glyph_count, origin, pen);
        for (std::uint32_t k = slice.first; k < slice.last; ++k) {
            const text_cluster& c = shaped_.cluster(back ? slice.last - 1 - (k - slice.first) : k);
            const double spread = !is_zero(slice.spread) && shaped_.may_be_spaced(c) ? slice.spread : 0.0;
            if (back) pen += spread;
            if (error e = append(item, c.glyph, c.glyph + c.glyph_count, origin, pen)) return e;
            pen += c.advance + (back ? 0.0 : spread);
            if (has(c.flags, cluster_flags::stretches)) pen += slice.stretch;
        }
        return {};
    }

private:
    /// What glyphs are drawn with that stand one after the other.
    struct drawn_with {
        std::uint32_t item = 0, style = 0, look = 0;
        std::uint16_t face = 0;
        double rise = 0.0;
        glyph_flags stands = glyph_flags::none;
        bool known = false;
    };

    error append(std::uint32_t item, std::uint32_t first, std::uint32_t last, point origin, double pen) noexcept
    {
        if (first == last) return {};
        placed_glyph* out = run_.glyphs.append(last - first);
        if (out == nullptr) return error::out_of_memory;
        const shaped_glyph* glyphs = shaped_.glyphs();
        for (std::uint32_t i = first; i < last; ++i, ++out) {
            const shaped_glyph& g = glyphs[i];
            const bool missing = has(g.flags, glyph_flags::missing);
            if (error e = find_look(item, g)) return e;
            const point at =
                down_ ? point{origin.x + now_.rise, origin.y - pen} : point{origin.x + pen, origin.y + now_.rise};
            *out = {g.id, g.cluster, at + g.offset, missing, now_.look};
            pen += g.advance;
            if (missing) run_.note_missing(g.cluster);
        }
        return {};
    }

    /// Finds what a glyph is drawn with: mostly the same as the one before.
    error find_look(std::uint32_t item, const shaped_glyph& g) noexcept
    {
        const std::uint32_t style = shaped_.styles.number_at(g.cluster);
        const glyph_flags stands = has(g.flags, glyph_flags::sideways)   ? glyph_flags::sideways
                                   : has(g.flags, glyph_flags::combined) ? glyph_flags::combined
                                                                         : glyph_flags::none;
        if (now_.known && now_.item == item && now_.style == style && now_.face == g.face && now_.stands == stands)
            return {};
        const item_setting set = shaped_.setting_of(item);
        const text_style& painted = shaped_.styles[style];
        now_ = {.item = item,
                .style = style,
                .face = g.face,
                .rise = set.lift + painted.rise * shaped_.units_per_em(),
                .stands = stands};
        const look drawn = look_of(shaped_.items()[item], set, painted, g);
        if (!run_.looks.empty() || !(drawn == look{})) {
            const auto number = run_.number_of(drawn);
            if (!number) return number.error();
            now_.look = *number;
        }
        now_.known = true;
        return {};
    }

    const shaped_text& shaped_;
    glyph_run& run_;
    bool down_;
    drawn_with now_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
