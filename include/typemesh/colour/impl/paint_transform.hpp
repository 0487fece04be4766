// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The map that first applies `inner` and then `outer`.
[[nodiscard]] constexpr affine after(const affine& outer, const affine& inner) noexcept
{
    return {outer.xx * inner.xx + outer.xy * inner.yx,
            outer.xx * inner.xy + outer.xy * inner.yy,
            outer.xx * inner.dx + outer.xy * inner.dy + outer.dx,
            outer.yx * inner.xx + outer.yy * inner.yx,
            outer.yx * inner.xy + outer.yy * inner.yy,
            outer.yx * inner.dx + outer.yy * inner.dy + outer.dy};
}

/// The map of the square from (0, 0) to (1, 1) onto a box.
[[nodiscard]] constexpr affine onto(const box& b) noexcept
{
    return {b.width(), 0.0, b.low.x, 0.0, b.height(), b.low.y};
}

/// The numbers of a transform paint, in the order of the table.
struct transform_numbers {
    double v[6] = {};
};

/// How many numbers of two bytes a transform paint has, and how many of the first are fractions (2.14).
struct transform_fields {
    std::uint32_t count, fractions;
};

/// For the formats 14 to 31 of COLR version 1; odd ones are the variable forms.
[[nodiscard]] constexpr transform_fields fields_of(std::uint32_t format) noexcept
{
    switch (format & ~1u) {
    case 14: return {2, 0};  // dx, dy
    case 16: return {2, 2};  // scale in x and y
    case 18: return {4, 2};  // and the centre
    case 20: return {1, 1};  // scale
    case 22: return {3, 1};
    case 24: return {1, 1};  // half turns
    case 26: return {3, 1};
    case 28: return {2, 2};  // skew in x and y, in half turns
    default: return {4, 2};
    }
}

/// The map of such a paint.
[[nodiscard]] inline affine transform_of(std::uint32_t format, const transform_numbers& n) noexcept
{
    constexpr double half_circle = 3.14159265358979323846;
    const auto around = [](const affine& m, double x, double y) noexcept {
        return after(after(affine{.dx = x, .dy = y}, m), affine{.dx = -x, .dy = -y});
    };
    const auto turned = [](double half_turns) noexcept {
        const double c = steady_cosine(half_circle * half_turns), s = steady_sine(half_circle * half_turns);
        return affine{c, -s, 0.0, s, c, 0.0};
    };
    const auto skewed = [](double x, double y) noexcept {
        const auto slope = [](double half_turns) noexcept { return steady(std::tan(half_circle * half_turns)); };
        return affine{1.0, -slope(x), 0.0, slope(y), 1.0, 0.0};
    };
    const auto& v = n.v;
    switch (format & ~1u) {
    case 14: return {.dx = v[0], .dy = v[1]};
    case 16: return {.xx = v[0], .yy = v[1]};
    case 18: return around({.xx = v[0], .yy = v[1]}, v[2], v[3]);
    case 20: return {.xx = v[0], .yy = v[0]};
    case 22: return around({.xx = v[0], .yy = v[0]}, v[1], v[2]);
    case 24: return turned(v[0]);
    case 26: return around(turned(v[0]), v[1], v[2]);
    case 28: return skewed(v[0], v[1]);
    default: return around(skewed(v[0], v[1]), v[2], v[3]);
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
