// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

inline constexpr std::uint32_t no_cut = 0xFFFF'FFFFu;

/// The changes if a line ends in the middle of an item: clusters of the text, and the clusters that replace them.
///
///     text      |  |  |before_from ... place ... |behind_to  |  |
///     instead         |     before     |  behind |
struct line_cut {
    std::uint32_t before_from = 0;  ///< clusters from this one up to the place are replaced
    std::uint32_t before_first = 0;
    std::uint32_t before_count = 0;
    std::uint32_t behind_to = 0;  ///< clusters from the place up to this one are replaced
    std::uint32_t behind_first = 0;
    std::uint32_t behind_count = 0;
    double end_change = 0.0;    ///< the increase of the width of the line before
    double begin_change = 0.0;  ///< the increase of the width of the line after
};

namespace detail {

/// The letter spacing after the last visible cluster of a range.
[[nodiscard]] inline double last_spacing(const shaped_text& shaped, std::uint32_t first, std::uint32_t last) noexcept
{
    while (last > first && has(shaped.cluster(last - 1).flags, cluster_flags::unshown)) --last;
    return last > first ? shaped.spacing_of(shaped.cluster(last - 1)) : 0.0;
}

/// The advance of clusters without the hanging ones at their end, and without letter spacing there.
[[nodiscard]] inline double visible_advance(const shaped_text& shaped, std::uint32_t first, std::uint32_t last) noexcept
{
    while (last > first && has(shaped.cluster(last - 1).flags, cluster_flags::unshown)) --last;
    return shaped.advance(first, last) - last_spacing(shaped, first, last);
}

/// Whether n clusters from a on and from b on are the same glyphs with the same advances.
[[nodiscard]] inline bool same_clusters(const shaped_text& shaped, std::uint32_t a, std::uint32_t b,
                                        std::uint32_t n) noexcept
{
    for (std::uint32_t i = 0; i < n; ++i) {
        const text_cluster &c = shaped.cluster(a + i), &d = shaped.cluster(b + i);
        if (c.first != d.first || c.glyph_count != d.glyph_count) return false;
        for (std::uint32_t k = 0; k < c.glyph_count; ++k) {
            const shaped_glyph &g = shaped.glyph(c.glyph + k), &h = shaped.glyph(d.glyph + k);
            if (g.id != h.id || g.face != h.face || !same(g.advance, h.advance) || !(g.offset == h.offset))
                return false;
        }
    }
    return true;
}

/// Appends a hyphen, as a cluster of the grapheme before text[place]: the font's hyphen, otherwise hyphen-minus.
template <shaper Shaper>
error append_hyphen(shaped_text& shaped, Shaper& shaper, std::uint32_t item, std::uint32_t place) noexcept
{
    std::uint32_t at = place - 1;
    while (at > 0 && !has(shaped.analysis.marks[at], text_mark::grapheme)) --at;
    return shaped.append_foreign(shaper, item, at, std::u16string_view{u"\u2010"}, std::u16string_view{u"-"});
}

}  // namespace detail

/// Finds the changes if a line ends before text[place], in cluster c or after it. Both sides are shaped again from the
/// nearest safe places, at most 64 clusters away. Their clusters are appended only if something changes.
///
///     cut      gets the result
///     share    the part of cluster c before the place, 1 if all of c is before it
///
/// Returns whether anything changes.
///
/// Fails  error::out_of_memory, and as the shaper does
template <shaper Shaper>
result<bool> make_cut(shaped_text& shaped, Shaper& shaper, std::uint32_t c, std::uint32_t place, double share,
                      line_cut& cut) noexcept
{
    const std::uint32_t item = shaped.cluster(c).item, begin = shaped.first_cluster(item),
                        end = shaped.end_cluster(item);
    const bool inside = place < shaped.cluster(c).last, hyphen = shaped.hyphenates(place);
    const auto unsafe = [&shaped](std::uint32_t i) noexcept {
        return has(shaped.cluster(i).flags, cluster_flags::unsafe);
    };
    const bool both = inside || (c + 1 < end && unsafe(c + 1));
    if (!both && !hyphen) return false;

    const std::size_t clusters = shaped.all_clusters(), glyphs = shaped.all_glyphs();
    constexpr std::uint32_t most = 64;  // clusters on each side: the time stays linear for fonts without safe places
    std::uint32_t from = c, to = c + 1;
    while (from > begin && c - from < most &&
           (unsafe(from) || (hyphen && has(shaped.cluster(from).flags, cluster_flags::unshown))))
        --from;
    while (both && to < end && to - c <= most && unsafe(to)) ++to;

    cut.before_from = from;
    cut.before_first = static_cast<std::uint32_t>(clusters);
    if (error e = shaped.shape_range(shaper, item, shaped.cluster(from).first, place)) return e;
    if (hyphen)
        if (error e = detail::append_hyphen(shaped, shaper, item, place)) return e;
    cut.before_count = static_cast<std::uint32_t>(shaped.all_clusters() - clusters);
    cut.behind_to = to;
    cut.behind_first = static_cast<std::uint32_t>(shaped.all_clusters());
    if (both)
        if (error e = shaped.shape_range(shaper, item, place, shaped.cluster(to - 1).last)) return e;
    cut.behind_count = static_cast<std::uint32_t>(shaped.all_clusters()) - cut.behind_first;

    if (!inside && !hyphen && cut.before_count == c + 1 - from && cut.behind_count == to - c - 1 &&
        detail::same_clusters(shaped, from, cut.before_first, cut.before_count) &&
        detail::same_clusters(shaped, c + 1, cut.behind_first, cut.behind_count)) {
        shaped.truncate(clusters, glyphs);
        return false;
    }
    const double own = shaped.cluster(c).advance;
    const double was = inside ? shaped.advance(from, c) + share * own - detail::last_spacing(shaped, from, c + 1)
                              : detail::visible_advance(shaped, from, c + 1);
    cut.end_change = detail::visible_advance(shaped, cut.before_first, cut.before_first + cut.before_count) - was;
    cut.begin_change = 0.0;
    if (both)
        cut.begin_change = shaped.advance(cut.behind_first, cut.behind_first + cut.behind_count) -
                           shaped.advance(c + 1, to) - (inside ? own - share * own : 0.0);
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
