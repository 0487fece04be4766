// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>

namespace typemesh {

/// From which side of t a tangent is taken. The two differ only where the curve stops and turns: at a cusp or a reversal.
enum class side_of : std::uint8_t { before, after };

/// The direction in which a curve runs at t, as t grows; not of unit length, and zero only for a curve that is one point.
///
/// Where the derivative vanishes (handles of zero length, cusps, reversals) it is the one-sided limit:
///
///        after                B(t) = B + B'h + B''h²/2 + B'''h³/6: the first term that does not vanish
///     \  ↑  /                 tells the direction; from before, even terms turn their sign.
///      \ | /
///       \|/   <- cusp: before and after are opposite
///
/// "Vanishes" means shorter than 2^-20 of the control polygon's longest leg: t is stored in 32 bits.
[[nodiscard]] inline point tangent(const curve& c, double t, side_of side) noexcept
{
    if (c.degree == 1) return c.p[1] - c.p[0];

    const double even = side == side_of::after ? 1.0 : -1.0;
    if (c.degree == 2) {
        const point a = c.p[1] - c.p[0], b = c.p[2] - c.p[1];
        const double longest = dot(a, a) > dot(b, b) ? dot(a, a) : dot(b, b);
        const point first = lerp(a, b, t);
        if (dot(first, first) > longest * 0x1p-40) return first;
        return even * (b - a);
    }
    const point a = c.p[1] - c.p[0], b = c.p[2] - c.p[1], d = c.p[3] - c.p[2];
    double longest = dot(a, a) > dot(b, b) ? dot(a, a) : dot(b, b);
    longest = dot(d, d) > longest ? dot(d, d) : longest;
    const point ab = lerp(a, b, t), bd = lerp(b, d, t), first = lerp(ab, bd, t);
    if (dot(first, first) > longest * 0x1p-40) return first;
    const point second = bd - ab;
    if (dot(second, second) > longest * 0x1p-40) return even * second;
    return d - 2.0 * b + a;
}

}  // namespace typemesh
