// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A line of a paragraph that has been laid out. Lengths are in font units, along the line.
struct laid_line {
    std::uint32_t first = 0;  ///< in the text
    std::uint32_t last = 0;
    std::uint32_t first_slice = 0;
    std::uint32_t slices = 0;
    std::uint8_t level = 0;  ///< of its paragraph: odd ones are read to the left
    double left = 0.0;       ///< where what is visible begins
    double width = 0.0;      ///< of what is visible: white space at its end hangs
    line_metrics metrics = {};
    point origin = {};  ///< the pen where all lines begin

    /// Where what is visible ends.
    [[nodiscard]] constexpr double right() const noexcept { return left + width; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
