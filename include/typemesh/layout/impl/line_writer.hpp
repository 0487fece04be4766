// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/item_glyph_style.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/unicode/script.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Writes the glyphs of a shaped text's slices into a run.
class line_writer {
public:
    line_writer(const shaped_text& shaped, glyph_run& run) noexcept
        : shaped_{shaped}, run_{run}, down_{shaped.in_columns()}, alike_{!down_ && shaped.styles.empty()}
    {
    }

    /// Appends the glyphs of a slice whose place is `pen` along the line that begins at `origin`.
    ///
    /// Fails  error::out_of_memory
    error write(const line_slice& slice, point origin, double pen) noexcept
    {
        pen += slice.lead;
        if (slice.together) return append(slice.item, slice.glyph, slice.glyph_end, origin, pen);
        const bool back = slice.level % 2 != 0;
        const std::uint32_t item = shaped_.cluster(slice.first).item;
        for (std::uint32_t k = slice.first; k < slice.last; ++k) {
            const text_cluster& c = shaped_.cluster(back ? slice.last - 1 - (k - slice.first) : k);
            const double spread = !is_zero(slice.spread) && has_gap(shaped_, slice, c) ? slice.spread : 0.0;
            if (back) pen += spread;
            if (error e = append(item, c.glyph, c.glyph + c.glyph_count, origin, pen)) return e;
            pen += c.advance + (back ? 0.0 : spread);
            if (has(c.flags, cluster_flags::stretches)) pen += slice.stretch;
        }
        return {};
    }

private:
    /// The drawing state of consecutive glyphs. It holds for an item, a face and a range of the text.
    struct drawn_with {
        std::uint32_t item = 0, glyph_style = 0;
        std::uint16_t face = 0;
        text_range text = {};  // empty: not known yet
        double rise = 0.0;
        glyph_flags stands = glyph_flags::none;

        [[nodiscard]] bool holds(const shaped_glyph& g) const noexcept
        {
            return g.face == face && text.holds(g.cluster) && stand_of(g) == stands;
        }
        /// The orientation of a glyph in a column.
        [[nodiscard]] static glyph_flags stand_of(const shaped_glyph& g) noexcept
        {
            return g.flags & (glyph_flags::sideways | glyph_flags::combined | glyph_flags::box);
        }
    };

    error append(std::uint32_t item, std::uint32_t first, std::uint32_t last, point origin, double pen) noexcept
    {
        if (first == last) return {};
        placed_glyph* out = run_.glyphs.append(last - first);
        if (out == nullptr) return error::out_of_memory;
        const double start = pen;
        for (std::uint32_t i = first; i < last;) {
            if (error e = find_glyph_style(item, shaped_.glyph(i))) return e;
            const point base = origin + (down_ ? point{now_.rise, 0.0} : point{0.0, now_.rise});
            const array_view<const shaped_glyph> rest{shaped_.glyphs() + i, last - i};
            i += down_ ? write_alike<true>(rest, base, pen, out + (i - first))
                       : write_alike<false>(rest, base, pen, out + (i - first));
        }
        find_middles({shaped_.glyphs() + first, last - first}, along(origin) + start, out);
        if (joins(item))
            for (std::uint32_t i = 0; i < last - first; ++i) out[i].joined = true;
        return {};
    }

    [[nodiscard]] double along(point p) const noexcept { return down_ ? 0.0 - p.y : p.x; }

    /// Finds the middles of the clusters of glyphs that have been written.
    void find_middles(array_view<const shaped_glyph> glyphs, double pen, placed_glyph* out) const noexcept
    {
        for (std::size_t i = 0; i < glyphs.size();) {
            const std::size_t first = i++;
            double advance = 0.0 + glyphs[first].advance;  // the sum of a cluster without width is +0
            while (i < glyphs.size() && glyphs[i].cluster == glyphs[first].cluster) advance += glyphs[i++].advance;
            const double middle = pen + 0.5 * advance;
            std::size_t k = first;
            do out[k].to_middle = static_cast<float>(middle - along(out[k].origin));
            while (++k < i);  // usually once
            pen += advance;
        }
    }

    /// Whether an item's script joins letters.
    [[nodiscard]] bool joins(std::uint32_t item) noexcept
    {
        if (item != looked_up_) joined_ = joins_letters(shaped_.items()[item].script);
        looked_up_ = item;
        return joined_;
    }

    /// Writes glyphs up to the first one with another drawing state, and moves the pen. Returns their number.
    template <bool down>
    std::uint32_t write_alike(array_view<const shaped_glyph> glyphs, point base, double& pen,
                              placed_glyph* out) noexcept
    {
        constexpr glyph_flags noted = glyph_flags::missing | glyph_flags::parted;
        const drawn_with now = now_;
        double along = pen;
        std::uint32_t n = 0;
        for (; n < glyphs.size() && now.holds(glyphs[n]); ++n) {
            const shaped_glyph& g = glyphs[n];
            const point at = down ? point{base.x, base.y - along} : point{base.x + along, base.y};
            out[n] = {g.id, g.cluster, at + g.offset, has(g.flags, glyph_flags::missing), now.glyph_style, 0.0f, false};
            along += g.advance;
            if (has(g.flags, noted)) note(g);
        }
        pen = along;
        return n;
    }
    void note(const shaped_glyph& g) noexcept
    {
        if (has(g.flags, glyph_flags::missing)) run_.note_missing(g.cluster);
        if (has(g.flags, glyph_flags::parted)) run_.note_parted(g.cluster);
    }

    /// Finds the drawing state of a glyph. Usually it is the same as before.
    error find_glyph_style(std::uint32_t item, const shaped_glyph& g) noexcept
    {
        if ((now_.item == item || alike_) && now_.holds(g)) return {};
        const item_setting set = shaped_.setting_of(item);
        const text_style& painted = shaped_.styles[shaped_.styles.number_at(g.cluster)];
        const double rise = set.lift + painted.rise * shaped_.units_per_em();
        const auto* const box = has(g.flags, glyph_flags::box) ? shaped_.insets.box_at(g.cluster) : nullptr;
        const glyph_style drawn = box != nullptr
                                      ? text_insets::style_of(box->box, down_, shaped_.units_per_em(), painted.style)
                                      : glyph_style_of(shaped_.items()[item], set, painted, g);
        std::uint32_t number = 0;
        if (!run_.glyph_styles.empty() || !(drawn == glyph_style{})) {
            const auto found = run_.number_of(drawn);
            if (!found) return found.error();
            number = *found;
        }
        now_ = {item, number, g.face, shaped_.styles.range_at(g.cluster), rise, drawn_with::stand_of(g)};
        if (box != nullptr) now_.text = {g.cluster, g.cluster + 1};
        return {};
    }

    const shaped_text& shaped_;
    glyph_run& run_;
    bool down_;
    bool alike_;  // all items are drawn in the same way
    drawn_with now_;
    std::uint32_t looked_up_ = 0xFFFF'FFFFu;  // an item, and whether its script joins letters
    bool joined_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
