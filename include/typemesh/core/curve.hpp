// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A quadratic Bezier curve: p0, one control point, p2.
struct quadratic {
    point p0, p1, p2;

    [[nodiscard]] constexpr point at(double t) const noexcept { return lerp(lerp(p0, p1, t), lerp(p1, p2, t), t); }
};

/// A cubic Bezier curve: p0, two control points, p3.
struct cubic {
    point p0, p1, p2, p3;

    [[nodiscard]] constexpr point at(double t) const noexcept
    {
        const point a = lerp(p0, p1, t), b = lerp(p1, p2, t), c = lerp(p2, p3, t);
        return lerp(lerp(a, b, t), lerp(b, c, t), t);
    }
};

/// The quadratic as a cubic, by degree elevation; the curve stays the same.
[[nodiscard]] constexpr cubic raised(const quadratic& q) noexcept
{
    return {q.p0, lerp(q.p0, q.p1, 2.0 / 3.0), lerp(q.p2, q.p1, 2.0 / 3.0), q.p2};
}

/// One segment of an outline: a line (degree 1: p[0], p[1]), a quadratic (p[0] to p[2]) or a cubic (p[0] to p[3]).
struct curve {
    std::uint32_t degree = 1;
    point p[4] = {};

    /// Makes a segment of an outline from a line, a quadratic or a cubic.
    [[nodiscard]] static constexpr curve from(point a, point b) noexcept { return {1, {a, b}}; }
    [[nodiscard]] static constexpr curve from(const quadratic& q) noexcept { return {2, {q.p0, q.p1, q.p2}}; }
    [[nodiscard]] static constexpr curve from(const cubic& c) noexcept { return {3, {c.p0, c.p1, c.p2, c.p3}}; }

    [[nodiscard]] constexpr quadratic as_quadratic() const noexcept { return {p[0], p[1], p[2]}; }
    [[nodiscard]] constexpr cubic as_cubic() const noexcept { return {p[0], p[1], p[2], p[3]}; }
    [[nodiscard]] constexpr point start() const noexcept { return p[0]; }
    [[nodiscard]] constexpr point end() const noexcept { return p[degree]; }
    [[nodiscard]] constexpr point at(double t) const noexcept
    {
        return degree == 1 ? lerp(p[0], p[1], t) : degree == 2 ? as_quadratic().at(t) : as_cubic().at(t);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
