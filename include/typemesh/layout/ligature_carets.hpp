// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A shaper that knows the caret positions in its ligatures.
///
///     s.ligature_carets(face, id, down, carets)   appends the positions between the letters of a glyph along the line,
///                                                 from the glyph's own (0, 0), in font units of the shaper: to the
///                                                 right, in columns down. It appends none if it knows none.
///
/// Fails  error::out_of_memory
template <class S>
concept has_ligature_carets = requires(const S& s, std::uint32_t face, glyph_id id, bool down, buffer<double>& to) {
    { s.ligature_carets(face, id, down, to) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
