// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/line_room.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>

#include <cstddef>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A line after breaking: pieces [first, last) of a list, at least one. Lengths are in font units.
struct broken_line {
    const text_pieces::list& all;  ///< the pieces of the text
    std::size_t first = 0;
    std::size_t last = 0;
    double pen = 0.0;    ///< the start of the line
    bool drops = false;  ///< whether this is the last line, and the text after it is dropped

    /// The end of the line if the spaces after its last tab shrink as far as possible. Cost: O(pieces)
    [[nodiscard]] double least_end(const line_room& room) const noexcept
    {
        const std::span<const break_piece> p = all.pieces.view();
        double at = pen + p[first].begin_change, end = 0.0, stretch = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const bool ends = k + 1 == last;
            if (p[k].width > 0.0 || (ends && p[k].is_visible()))
                end = at + p[k].width + (ends ? p[k].end_change : 0.0) - room.shrink * stretch;
            at += p[k].width + p[k].space;
            stretch += p[k].stretch;
            if (!p[k].tab) continue;
            at = room.after_tab(at);
            stretch = 0.0;
        }
        return end;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
