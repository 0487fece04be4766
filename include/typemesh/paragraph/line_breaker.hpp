// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/layout/line_room.hpp>
#include <typemesh/paragraph/break_piece.hpp>

#include <concepts>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Decides where the lines of a text end.
///
///     b.break_lines(pieces, room, ends)   appends for each line the index after its last piece. Each line has at least
///                                         one piece. The last line ends with the last piece, or is line number
///                                         room.max_lines. No line ends after a piece whose end is `never`. A line with
///                                         a piece of `line` or `paragraph` ends with that piece.
///
/// Fails  error::out_of_memory
template <class B>
concept line_breaker =
    requires(B& b, std::span<const break_piece> pieces, const line_room& room, buffer<std::uint32_t>& ends) {
        { b.break_lines(pieces, room, ends) } noexcept -> std::same_as<error>;
    };

}  // namespace typemesh::inline TYPEMESH_ABI
