// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A position or a direction in the plane, in font units unless stated otherwise. x points to the right, y up.
struct point {
    double x = 0.0;
    double y = 0.0;

    friend constexpr point operator+(point a, point b) noexcept { return {a.x + b.x, a.y + b.y}; }
    friend constexpr point operator-(point a, point b) noexcept { return {a.x - b.x, a.y - b.y}; }
    friend constexpr point operator*(double s, point a) noexcept { return {s * a.x, s * a.y}; }
    friend constexpr point operator*(point a, double s) noexcept { return s * a; }
    friend constexpr bool operator==(point a, point b) noexcept { return same(a.x, b.x) && same(a.y, b.y); }
};

/// The dot product.
[[nodiscard]] constexpr double dot(point a, point b) noexcept { return a.x * b.x + a.y * b.y; }
/// The z coordinate of the cross product: positive if b lies to the left of a.
[[nodiscard]] constexpr double cross(point a, point b) noexcept { return a.x * b.y - a.y * b.x; }
/// The Euclidean length.
[[nodiscard]] inline double length(point a) noexcept { return std::sqrt(dot(a, a)); }

/// Linear interpolation: a at s = 0, b at s = 1.
[[nodiscard]] constexpr point lerp(point a, point b, double s) noexcept { return (1.0 - s) * a + s * b; }

/// A position on the integer grid on which all decisions are made (see grid.hpp); |coordinate| <= 2^28.
struct grid_point {
    std::int32_t x = 0;
    std::int32_t y = 0;

    /// Both coordinates in one word.
    [[nodiscard]] constexpr std::uint64_t word() const noexcept
    {
        return std::uint64_t{static_cast<std::uint32_t>(y)} << 32 | static_cast<std::uint32_t>(x);
    }
    /// The comparison has no branch, because sweeps compare equal points about as often as distinct points.
    friend constexpr bool operator==(grid_point a, grid_point b) noexcept { return a.word() == b.word(); }
};

/// Converts a float to a double, exactly. The conversion has a name, so that compilers may warn about every other
/// conversion from float to double (-Wdouble-promotion).
[[nodiscard]] constexpr double as_double(float value) noexcept { return static_cast<double>(value); }

/// Two 32-bit floats. The output consists of vec2, vec3 and vec4.
struct vec2 {
    float x = 0.0f;
    float y = 0.0f;

    friend constexpr bool operator==(vec2 a, vec2 b) noexcept { return same(a.x, b.x) && same(a.y, b.y); }
};

/// A position, direction or colour in space: x, y, z.
struct vec3 {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;

    friend constexpr bool operator==(vec3 a, vec3 b) noexcept
    {
        return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
    }
};

/// Four floats: a tangent with its sign, a colour with its opacity.
struct vec4 {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float w = 0.0f;

    friend constexpr bool operator==(const vec4& a, const vec4& b) noexcept
    {
        return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.w, b.w);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
