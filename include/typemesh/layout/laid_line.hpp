// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A line of a paragraph after layout. Lengths are in font units, along the line.
struct laid_line {
    std::uint32_t first = 0;  ///< the start of the line in the text
    std::uint32_t last = 0;
    std::uint32_t first_slice = 0;
    std::uint32_t slices = 0;
    std::uint8_t level = 0;  ///< the level of its paragraph: odd levels are read to the left
    double left = 0.0;       ///< the start of the visible part
    double width = 0.0;      ///< the width of the visible part: white space at the line's end hangs
    double hanging = 0.0;    ///< the width of the white space at its end
    line_metrics metrics = {};
    point origin = {};  ///< the position of the pen at position 0 along the line

    /// The end of the visible part.
    [[nodiscard]] constexpr double right() const noexcept { return left + width; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
