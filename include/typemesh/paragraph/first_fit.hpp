// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/paragraph/line_breaker.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Fills line after line: each line ends at the last place where it still fits the width. A word that is longer than a
/// line begins a new line. It is broken at in_need places if there are any, and otherwise sticks out.
///
/// Cost  O(n): no piece is read in more than two lines
struct first_fit {
    error break_lines(std::span<const break_piece> pieces, const line_room& room,
                      buffer<std::uint32_t>& ends) const noexcept
    {
        bool fresh = true;
        std::uint32_t lines = 0;
        for (std::size_t begin = 0; begin < pieces.size() && lines < room.max_lines; ++lines) {
            begin = end_of(pieces, begin, room.start(fresh), room);
            fresh = pieces[begin - 1].end == piece_end::paragraph;
            if (!ends.push_back(static_cast<std::uint32_t>(begin))) return error::out_of_memory;
        }
        return {};
    }

    /// The index after the last piece of the line that begins with piece `begin` and with the pen at `pen`.
    [[nodiscard]] static std::size_t end_of(std::span<const break_piece> pieces, std::size_t begin, double pen,
                                            const line_room& room) noexcept
    {
        std::size_t best = 0, in_need = 0, first = 0;  // 0: none yet
        pen += pieces[begin].begin_change;
        for (std::size_t k = begin; k < pieces.size(); ++k) {
            const break_piece& p = pieces[k];
            const double at_end = pen + p.width + p.end_change;
            const bool blank = !p.is_visible();
            const double least = p.ends_line() || p.end_change < 0.0 ? at_end : pen + p.width;
            const bool overflows = !blank && least > room.width;
            if (overflows && best != 0) return best;
            if (overflows && in_need != 0) return in_need;
            if (overflows && first != 0) return first;  // none fits
            if (p.ends_line() || (overflows && p.end != piece_end::never)) return k + 1;
            if (first == 0 && p.end != piece_end::never) first = k + 1;
            if (blank || at_end <= room.width) {
                if (p.end == piece_end::allowed) best = k + 1;
                if (p.end == piece_end::in_need) in_need = k + 1;
            }
            pen += p.width + p.space;
            if (p.tab) pen = room.after_tab(pen);
        }
        return pieces.size();
    }
};

static_assert(line_breaker<first_fit>);

}  // namespace typemesh::inline TYPEMESH_ABI
