// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/impl/text_cluster.hpp>
#include <typemesh/layout/impl/white_space.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/text_mark.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The part of an item that was shaped, the number of the item, and the number of the part's first glyph.
struct shaped_part {
    const text_item& part;
    std::uint32_t item = 0;
    std::size_t first_glyph = 0;
};

/// The flags of the cluster of a glyph with this advance.
[[nodiscard]] inline cluster_flags flags_of(text_view text, array_view<const text_mark> all, const shaped_glyph& g,
                                            double advance) noexcept
{
    const text_mark marks = all[g.cluster];
    constexpr auto plain = glyph_flags::unsafe_to_break | glyph_flags::tatweel;
    if (!has(marks, text_mark::space | text_mark::trailing) && !has(g.flags, plain) && !is_zero(advance))
        return cluster_flags::none;  // nearly all
    const bool space = has(marks, text_mark::space), hangs = space || has(marks, text_mark::trailing);
    const bool unseen = !hangs && is_zero(advance) && is_default_ignorable(decode(text, g.cluster).value);
    return (hangs ? cluster_flags::hangs : cluster_flags::none) |
           (unseen ? cluster_flags::unseen : cluster_flags::none) |
           (space ? cluster_flags::stretches : cluster_flags::none) |
           (has(g.flags, glyph_flags::unsafe_to_break) ? cluster_flags::unsafe : cluster_flags::none) |
           (has(g.flags, glyph_flags::tatweel) ? cluster_flags::tatweel : cluster_flags::none);
}

/// Gathers glyphs, in drawing order, into clusters in the order of the text. There is at least one if there is text,
/// and none ends inside a grapheme.
///
///     marks       of the text's analysis
///     clusters    the clusters are appended, with the sums of the advances before them
///
/// Fails  error::out_of_memory
/// Cost   O(glyphs), in one pass
inline error gather_clusters(text_view text, array_view<const text_mark> marks, array_view<const shaped_glyph> glyphs,
                             const shaped_part& of, buffer<text_cluster>& clusters) noexcept
{
    const std::size_t count = glyphs.size(), first_cluster = clusters.size();
    const text_item& part = of.part;
    if (count == 0 && part.first == part.last) return {};
    text_cluster* const made = clusters.append(count != 0 ? count : 1);
    if (made == nullptr) return error::out_of_memory;
    const bool back = part.to_the_left();
    double pen = first_cluster == 0 ? 0.0 : (made - 1)->before + (made - 1)->advance;
    std::size_t n = 0;
    bool marked = false;  // whether a space may carry a mark
    const auto end_at = [&](std::uint32_t end) noexcept {
        text_cluster& c = made[n - 1];
        c.last = end;
        pen += c.advance;
        marked = marked || (has(c.flags, cluster_flags::unshown) && c.last - c.first > 1);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = back ? count - 1 - i : i;
        const shaped_glyph& g = glyphs[k];
        const bool goes_on = n != 0 && (g.cluster == glyphs[back ? k + 1 : k - 1].cluster ||
                                        !has(marks[g.cluster], text_mark::grapheme));
        if (goes_on) {
            text_cluster& c = made[n - 1];
            if (back) c.glyph = static_cast<std::uint32_t>(of.first_glyph + k);
            ++c.glyph_count;
            c.advance += g.advance;
            if (!is_zero(g.advance)) c.flags = without(c.flags, cluster_flags::unseen);
            continue;
        }
        if (n != 0) end_at(g.cluster);
        made[n] = {.first = n == 0 ? part.first : g.cluster,
                   .glyph = static_cast<std::uint32_t>(of.first_glyph + k),
                   .glyph_count = 1,
                   .advance = g.advance,
                   .item = of.item,
                   .flags = flags_of(text, marks, g, g.advance),
                   .before = pen};
        ++n;
    }
    if (count == 0)
        made[n++] = {.first = part.first,
                     .glyph = static_cast<std::uint32_t>(of.first_glyph),
                     .item = of.item,
                     .flags = flags_of(text, marks, {.cluster = part.first}, 0.0),
                     .before = pen};
    end_at(part.last);
    clusters.truncate(first_cluster + n);
    if (marked) detail::part_marked_spaces(text, marks, clusters.view().subspan(first_cluster));
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
