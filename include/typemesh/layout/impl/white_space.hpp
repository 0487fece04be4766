// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/layout/impl/text_cluster.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/unicode/text_mark.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether text[first, last) is invisible. It begins with white space, or with trailing characters by rule L1 of UAX
/// #9. A space with a mark is not white space.
[[nodiscard]] inline bool is_blank(text_view text, array_view<const text_mark> marks, std::size_t first,
                                   std::size_t last) noexcept
{
    while (first < last) {
        const code_point c = decode(text, first, last);
        if (!has(marks[first], text_mark::space | text_mark::trailing) && !is_default_ignorable(c.value)) return false;
        first = c.next;
    }
    return true;
}

/// The end of the grapheme that contains text[first].
[[nodiscard]] inline std::size_t grapheme_end(array_view<const text_mark> marks, std::size_t first) noexcept
{
    do ++first;
    while (first < marks.size() && !has(marks[first], text_mark::grapheme));
    return first;
}

namespace detail {

/// Clusters of white space or invisible characters that carry a mark neither hang nor stretch.
inline void part_marked_spaces(text_view text, array_view<const text_mark> marks,
                               array_view<text_cluster> clusters) noexcept
{
    for (text_cluster& c : clusters)
        if (has(c.flags, cluster_flags::unshown) && c.last - c.first > 1 && !is_blank(text, marks, c.first, c.last))
            c.flags = without(c.flags, cluster_flags::unshown | cluster_flags::stretches);
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
