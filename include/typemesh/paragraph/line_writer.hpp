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
        const text_item& item = shaped_.items()[shaped_.cluster(slice.first).item];
        const text_cluster& low = shaped_.cluster(back ? slice.last - 1 : slice.first);
        const text_cluster& high = shaped_.cluster(back ? slice.first : slice.last - 1);
        const bool whole =
            back == item.to_the_left() && low.glyph <= high.glyph;  // else a hyphen ends what is read back
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
    error append(const text_item& item, std::uint32_t first, std::uint32_t last, point origin, double pen) noexcept
    {
        if (first == last) return {};
        placed_glyph* out = run_.glyphs.append(last - first);
        if (out == nullptr) return error::out_of_memory;
        const shaped_glyph* glyphs = shaped_.glyphs();
        for (std::uint32_t i = first; i < last; ++i, ++out) {
            const shaped_glyph& g = glyphs[i];
            const bool missing = has(g.flags, glyph_flags::missing);
            const point at = down_ ? point{origin.x, origin.y - pen} : point{origin.x + pen, origin.y};
            *out = {g.id, g.cluster, at + g.offset, missing, 0};
            pen += g.advance;
            if (missing) run_.note_missing(g.cluster);
            const look drawn = look_of(item, g);
            if (run_.looks.empty() && drawn == look{}) continue;
            const auto number = run_.number_of(drawn);
            if (!number) return number.error();
            out->look = *number;
        }
        return {};
    }

    const shaped_text& shaped_;
    glyph_run& run_;
    bool down_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
