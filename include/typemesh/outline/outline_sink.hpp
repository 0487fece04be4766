// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Receives an outline in five kinds of call, in font units, y up.
///
/// Every contour begins with move(). It ends with close(), with the next move(), or at the outline's end. In each case
/// the contour is closed, by a straight line if its last point is not its first.
template <class S>
concept outline_sink = requires(S& s, point p) {
    { s.move(p) } noexcept;
    { s.line(p) } noexcept;          // to p
    { s.quadratic(p, p) } noexcept;  // control point, end
    { s.cubic(p, p, p) } noexcept;   // two control points, end
    { s.close() } noexcept;
};

/// A sink that discards everything: the concept outline_source is checked with it.
struct ignore_outline {
    constexpr void move(point) noexcept {}
    constexpr void line(point) noexcept {}
    constexpr void quadratic(point, point) noexcept {}
    constexpr void cubic(point, point, point) noexcept {}
    constexpr void close() noexcept {}
};

}  // namespace typemesh::inline TYPEMESH_ABI
