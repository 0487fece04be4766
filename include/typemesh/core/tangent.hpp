// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>

#include <cstdint>

namespace typemesh {

/// The directions in which a curve arrives at t and leaves it, as t grows. Neither is of unit length; they are zero
/// only for a curve that is one point.
///
/// The two differ only where the curve stops and turns, at a cusp or a reversal. Where the derivative vanishes (there,
/// and at handles of zero length) they are its one-sided limits:
///
///        after                B(t) = B + B'h + B''h²/2 + B'''h³/6: the first term that does not vanish
///     \  ↑  /                 tells the direction; from before, even terms turn their sign.
///      \ | /
///       \|/   <- cusp: before and after are opposite
///
/// "Vanishes" means shorter than 2^-20 of the control polygon's longest leg: t is stored in 32 bits.
struct tangents {
    point before;
    point after;
    bool stops = false;  ///< the derivative vanishes here
};

[[nodiscard]] inline tangents tangents_at(const curve& c, double t) noexcept
{
    const point a = c.p[1] - c.p[0];
    if (c.degree == 1) return {a, a};

    const point b = c.p[2] - c.p[1];
    double longest = dot(a, a) > dot(b, b) ? dot(a, a) : dot(b, b);
    if (c.degree == 2) {
        const point first = lerp(a, b, t), second = b - a;
        if (dot(first, first) > longest * 0x1p-40) return {first, first};
        return {-1.0 * second, second, true};
    }
    const point d = c.p[3] - c.p[2];
    longest = dot(d, d) > longest ? dot(d, d) : longest;
    const point ab = lerp(a, b, t), bd = lerp(b, d, t), first = lerp(ab, bd, t);
    if (dot(first, first) > longest * 0x1p-40) return {first, first};
    const point second = bd - ab;
    if (dot(second, second) > longest * 0x1p-40) return {-1.0 * second, second, true};
    const point third = d - 2.0 * b + a;
    return {third, third, true};
}

/// From which side of t a tangent is taken.
enum class side_of : std::uint8_t { before, after };

/// One of tangents_at()'s two.
[[nodiscard]] inline point tangent(const curve& c, double t, side_of side) noexcept
{
    const tangents both = tangents_at(c, t);
    return side == side_of::before ? both.before : both.after;
}

}  // namespace typemesh
