// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The half_turn_tangent() of a path that goes back the way it came; of all others it is less.
inline constexpr double turned_back = 0x1p60;

/// The tangent of half the angle in which a path turns at b, positive to the left.
///
///                 c           tan(angle / 2) = cross / (lengths + dot) = (lengths - dot) / cross
///                /
///     a --------b . .         of the edges' cross product, dot product and lengths. Both products are exact, and the
///                 angle       quotient whose sum does not cancel is taken: so a turn by nearly half a circle has
///                             nearly all its bits, and differs from that by exactly half a circle.
[[nodiscard]] inline double half_turn_tangent(grid_point a, grid_point b, grid_point c) noexcept
{
    const std::int64_t across = orientation(a, b, c), along = (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) +
                                                              (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - b.y);
    const double lengths = length(delta(a, b)) * length(delta(b, c));
    if (along >= 0) return static_cast<double>(across) / (lengths + static_cast<double>(along));
    return across != 0 ? (lengths - static_cast<double>(along)) / static_cast<double>(across) : turned_back;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
