// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Pieces [first, last) of a list.
struct piece_range {
    const text_pieces::list& list;
    std::size_t first = 0;
    std::size_t last = 0;
};

namespace detail {

/// Handles a line so short that the changes at its two ends meet: the whole line is shaped again.
template <shaper Shaper>
error append_anew(line_slices& line, const piece_range& pieces, shaped_text& shaped, Shaper& shaper) noexcept
{
    const auto& [list, first, last] = pieces;
    const std::uint32_t item = shaped.cluster(list.sources[first].cluster).item, end = list.pieces[last - 1].last;
    const auto before = static_cast<std::uint32_t>(shaped.all_clusters());
    if (error e = shaped.shape_range(shaper, item, list.pieces[first].first, end)) return e;
    if (list.sources[last - 1].cut != no_cut && shaped.hyphenates(end))
        if (error e = append_hyphen(shaped, shaper, item, end)) return e;
    return line.append(shaped, before, static_cast<std::uint32_t>(shaped.all_clusters()) - before);
}

/// The cluster after the one that ends at a unit; the search starts at `from`.
[[nodiscard]] inline std::uint32_t end_of(const shaped_text& shaped, std::uint32_t unit, std::uint32_t from) noexcept
{
    return static_cast<std::uint32_t>(first_where(
        from, shaped.cluster_count(), [&](std::size_t c) noexcept { return shaped.cluster(c).first >= unit; }));
}

}  // namespace detail

/// Appends pieces to a line, with the changes at the start and the end of a line. `all` has their cuts.
///
/// Fails  error::out_of_memory, and as the shaper does
template <shaper Shaper>
error append_pieces(line_slices& line, const text_pieces& all, const piece_range& pieces, shaped_text& shaped,
                    Shaper& shaper) noexcept
{
    const auto& [list, first, last] = pieces;
    if (first >= last) return {};
    const text_pieces::list& of = list;  // clang 14 captures no structured binding
    const auto cut_after = [&of](std::size_t piece) noexcept { return of.sources[piece].cut; };
    const std::uint32_t head = first > 0 ? cut_after(first - 1) : list.begin_cut, tail = cut_after(last - 1);
    std::uint32_t from = list.sources[first].cluster;
    std::uint32_t to = last < list.sources.size() ? list.sources[last].cluster : shaped.cluster_count();
    if (tail == no_cut && last == list.sources.size()) to = detail::end_of(shaped, list.pieces[last - 1].last, from);
    if (head != no_cut) from = all.cut(head).behind_to;
    if (tail != no_cut) to = all.cut(tail).before_from;
    if (from > to) return detail::append_anew(line, pieces, shaped, shaper);
    if (head != no_cut)
        if (error e = line.append(shaped, all.cut(head).behind_first, all.cut(head).behind_count)) return e;
    if (error e = line.append_text(shaped, from, to)) return e;
    if (tail == no_cut) return {};
    return line.append(shaped, all.cut(tail).before_first, all.cut(tail).before_count);
}

}  // namespace typemesh::inline TYPEMESH_ABI
