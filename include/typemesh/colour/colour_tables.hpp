// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The bytes of a font's colour tables, which any font library can give. All of them may be empty. The caller keeps
/// them alive.
struct colour_tables {
    array_view<const std::byte> colr;  ///< 'COLR', of version 0 or 1
    array_view<const std::byte> cpal;  ///< 'CPAL', of version 0 or 1

    /// The place on the font's axes, normalised, as 2.14 fixed-point numbers in the order of 'fvar'. Empty: the
    /// default.
    array_view<const std::int32_t> axes;

    bool has_bitmaps = false;   ///< whether the font has 'CBDT', 'sbix' or 'EBDT': pictures, which are never traced
    bool has_drawings = false;  ///< whether the font has 'SVG ', which is not read

    /// Whether colour glyphs can be read.
    [[nodiscard]] bool has_layers() const noexcept { return !colr.empty() && !cpal.empty(); }
};

}  // namespace typemesh::inline TYPEMESH_ABI
