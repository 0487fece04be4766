// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/paragraph/shaped_text.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

inline constexpr std::uint32_t no_cut = 0xFFFF'FFFFu;

/// What changes where a line ends in the midst of an item: clusters of the text, and those that replace them.
///
///     text       |  |  |left_from ...  place  ... right_to|  |  |
///     replaced               |left|              |right|
struct line_cut {
    std::uint32_t left_from = 0;
    std::uint32_t left_first = 0;
    std::uint32_t left_count = 0;
    std::uint32_t right_to = 0;
    std::uint32_t right_first = 0;
    std::uint32_t right_count = 0;
    double end_change = 0.0;    ///< by how much the line before is wider
    double begin_change = 0.0;  ///< and the line behind
};

namespace detail {

/// The advance of clusters without what hangs at their end.
[[nodiscard]] inline double visible_advance(const shaped_text& shaped, std::uint32_t first, std::uint32_t last) noexcept
{
    while (last > first && has(shaped.cluster(last - 1).flags, cluster_flags::hangs)) --last;
    return shaped.advance(first, last) - (last > first ? shaped.spacing_of(shaped.cluster(last - 1)) : 0.0);
}

/// Appends a hyphen, as a cluster of the grapheme before text[place]: the font's own, else hyphen-minus.
template <item_shaper Shaper>
error append_hyphen(shaped_text& shaped, Shaper& shaper, std::uint32_t item, std::uint32_t place) noexcept
{
    std::uint32_t at = place - 1;
    while (at > 0 && !has(shaped.analysis.marks[at], text_mark::grapheme)) --at;
    return shaped.append_foreign(shaper, item, at, std::u16string_view{u"\u2010"}, std::u16string_view{u"-"});
}

}  // namespace detail

/// Finds out what changes where a line ends before text[place], in cluster c or behind it, by shaping both sides anew
/// from the nearest places where that is safe, at most 64 clusters away. Their clusters are appended; where nothing
/// changes none are.
///
///     cut      gets the result
///     share    the part of cluster c that stands before the place, 1 if all of it does
///
/// Returns whether anything changes.
///
/// Fails  error::out_of_memory, and as the shaper does
template <item_shaper Shaper>
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
    constexpr std::uint32_t most = 64;  // clusters a side: in a font where nothing is safe time stays linear
    std::uint32_t left = c, right = c + 1;
    while (left > begin && c - left < most &&
           (unsafe(left) || (hyphen && has(shaped.cluster(left).flags, cluster_flags::hangs))))
        --left;
    while (both && right < end && right - c <= most && unsafe(right)) ++right;

    cut.left_from = left;
    cut.left_first = static_cast<std::uint32_t>(clusters);
    if (error e = shaped.shape_range(shaper, item, shaped.cluster(left).first, place)) return e;
    if (hyphen)
        if (error e = detail::append_hyphen(shaped, shaper, item, place)) return e;
    cut.left_count = static_cast<std::uint32_t>(shaped.all_clusters() - clusters);
    cut.right_to = right;
    cut.right_first = static_cast<std::uint32_t>(shaped.all_clusters());
    if (both)
        if (error e = shaped.shape_range(shaper, item, place, shaped.cluster(right - 1).last)) return e;
    cut.right_count = static_cast<std::uint32_t>(shaped.all_clusters()) - cut.right_first;

    if (!inside && !hyphen && cut.left_count == c + 1 - left && cut.right_count == right - c - 1 &&
        shaped.same_clusters(left, cut.left_first, cut.left_count) &&
        shaped.same_clusters(c + 1, cut.right_first, cut.right_count)) {
        shaped.truncate(clusters, glyphs);
        return false;
    }
    const double own = shaped.cluster(c).advance;
    const double was = inside ? shaped.advance(left, c) + share * own : detail::visible_advance(shaped, left, c + 1);
    cut.end_change = detail::visible_advance(shaped, cut.left_first, cut.left_first + cut.left_count) - was;
    cut.begin_change = 0.0;
    if (both)
        cut.begin_change = shaped.advance(cut.right_first, cut.right_first + cut.right_count) -
                           shaped.advance(c + 1, right) - (inside ? own - share * own : 0.0);
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
