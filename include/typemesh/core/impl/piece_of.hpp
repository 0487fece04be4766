// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The piece of a curve from t0 to t1, as a curve of the same degree; t0 > t1 turns it round.
///
/// From  T. Sederberg, Computer Aided Geometric Design, section 2.4: each control point is a value of the blossom
[[nodiscard]] inline curve piece_of(const curve& c, double t0, double t1) noexcept
{
    const auto blossom = [&c](double r, double s, double t) noexcept {
        if (c.degree == 1) return lerp(c.p[0], c.p[1], r);
        const point ab = lerp(c.p[0], c.p[1], r), bc = lerp(c.p[1], c.p[2], r);
        if (c.degree == 2) return lerp(ab, bc, s);
        const point cd = lerp(c.p[2], c.p[3], r);
        return lerp(lerp(ab, bc, s), lerp(bc, cd, s), t);
    };
    curve piece;
    piece.degree = c.degree;
    for (std::uint32_t i = 0; i <= c.degree; ++i) {
        const auto argument = [&](std::uint32_t k) noexcept { return k < i ? t1 : t0; };
        piece.p[i] = blossom(argument(0), argument(1), argument(2));
    }
    return piece;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
