// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// A position or a direction in space, in double precision.
struct double3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    friend constexpr double3 operator+(double3 a, double3 b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr double3 operator-(double3 a, double3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr double3 operator*(double s, double3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
};

/// The dot product.
[[nodiscard]] constexpr double dot(double3 a, double3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// The cross product.
[[nodiscard]] constexpr double3 cross(double3 a, double3 b) noexcept
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The Euclidean length.
[[nodiscard]] inline double length(double3 a) noexcept { return std::sqrt(dot(a, a)); }

/// A box in space.
struct box3 {
    double3 low;
    double3 high;
};

}  // namespace typemesh::inline TYPEMESH_ABI
