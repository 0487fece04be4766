// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The alignment of a line to the origin: its left edge, its middle or its right edge is at x = 0. This does not depend
/// on the other lines, so a text can be placed by its anchor. Similarly, a column's top, middle or bottom is at y = 0.
///
///     left       centre      right
///     |Hello      Hel|lo      Hello|
///     |world!    worl|d!     world!|
///
/// Left and right are absolute: right-to-left text does not swap them.
enum class alignment : std::uint8_t { left, centre, right };

}  // namespace typemesh::inline TYPEMESH_ABI
