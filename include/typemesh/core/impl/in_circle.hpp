// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A signed number of 128 bits in two words, as two's complement.
struct two_words {
    std::uint64_t high;
    std::uint64_t low;
};

/// p * q in two words. It multiplies halves, for compilers without a 128-bit type. Precondition: |each| < 2^62.
[[nodiscard]] constexpr two_words product_in_halves(std::int64_t p, std::int64_t q) noexcept
{
    const std::uint64_t u = static_cast<std::uint64_t>(p < 0 ? -p : p);
    const std::uint64_t v = static_cast<std::uint64_t>(q < 0 ? -q : q);
    const std::uint64_t u1 = u >> 32, u0 = u & 0xFFFF'FFFFu, v1 = v >> 32, v0 = v & 0xFFFF'FFFFu;
    const std::uint64_t low = u0 * v0, middle = u1 * v0 + (low >> 32), other = u0 * v1 + (middle & 0xFFFF'FFFFu);
    const two_words size{u1 * v1 + (middle >> 32) + (other >> 32), other << 32 | (low & 0xFFFF'FFFFu)};
    if ((p < 0) == (q < 0)) return size;
    return {~size.high + (size.low == 0 ? 1u : 0u), ~size.low + 1u};
}

/// a * b + c * d in two words. It multiplies halves. Precondition: |each| < 2^62.
[[nodiscard]] constexpr two_words sum_of_products_in_halves(std::int64_t a, std::int64_t b, std::int64_t c,
                                                            std::int64_t d) noexcept
{
    const two_words first = product_in_halves(a, b), second = product_in_halves(c, d);
    const std::uint64_t low = first.low + second.low;
    return {first.high + second.high + (low < first.low ? 1u : 0u), low};
}

/// a * b + c * d in two words. Precondition: |each| < 2^62.
[[nodiscard]] constexpr two_words sum_of_products(std::int64_t a, std::int64_t b, std::int64_t c,
                                                  std::int64_t d) noexcept
{
#if defined(__SIZEOF_INT128__) && !defined(_MSC_VER)
    __extension__ using wide = __int128;
    const wide sum = static_cast<wide>(a) * b + static_cast<wide>(c) * d;
    return {static_cast<std::uint64_t>(sum >> 64), static_cast<std::uint64_t>(sum)};
#else
    return sum_of_products_in_halves(a, b, c, d);
#endif
}

/// a * b + c * d - e * f in two words. It multiplies halves. Precondition: |each| < 2^61.
[[nodiscard]] constexpr two_words sum_of_products_in_halves(std::int64_t a, std::int64_t b, std::int64_t c,
                                                            std::int64_t d, std::int64_t e, std::int64_t f) noexcept
{
    const two_words first = sum_of_products_in_halves(a, b, c, d), second = product_in_halves(-e, f);
    const std::uint64_t low = first.low + second.low;
    return {first.high + second.high + (low < first.low ? 1u : 0u), low};
}

/// a * b + c * d - e * f in two words. Precondition: |each| < 2^61.
[[nodiscard]] constexpr two_words sum_of_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d,
                                                  std::int64_t e, std::int64_t f) noexcept
{
#if defined(__SIZEOF_INT128__) && !defined(_MSC_VER)
    __extension__ using wide = __int128;
    const wide sum = static_cast<wide>(a) * b + static_cast<wide>(c) * d - static_cast<wide>(e) * f;
    return {static_cast<std::uint64_t>(sum >> 64), static_cast<std::uint64_t>(sum)};
#else
    return sum_of_products_in_halves(a, b, c, d, e, f);
#endif
}

}  // namespace detail

/// The position of d relative to the circle through a, b, c (counter-clockwise): 1 inside, 0 on it, -1 outside.
///
///       c             The chord ab is seen from c and from d under two angles: d lies on the circle when they sum to
///     /   \           180 degrees, that is when sin(c + d) = 0. With cross and dot for sine and cosine, that is two
///    a-----b          products and a sum instead of a determinant of degree four.
///     \   /
///       d
///
/// Exact. Budget: |coordinate| <= 2^28, differences <= 2^29, cross and dot <= 2^59, products <= 2^118, their sum <=
/// 2^119: two words of 64 bits.
/// From  C. Lawson, Software for C1 surface interpolation (1977); A. Cline & R. Renka, A storage-efficient method
///       (1984)
[[nodiscard]] constexpr int in_circle(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const std::int64_t acx = std::int64_t{a.x} - c.x, acy = std::int64_t{a.y} - c.y, bcx = std::int64_t{b.x} - c.x,
                       bcy = std::int64_t{b.y} - c.y;
    const std::int64_t adx = std::int64_t{a.x} - d.x, ady = std::int64_t{a.y} - d.y, bdx = std::int64_t{b.x} - d.x,
                       bdy = std::int64_t{b.y} - d.y;
    const std::int64_t sine_c = acx * bcy - acy * bcx, cosine_c = acx * bcx + acy * bcy;
    const std::int64_t sine_d = bdx * ady - bdy * adx, cosine_d = adx * bdx + ady * bdy;
    const detail::two_words sum = detail::sum_of_products(sine_c, cosine_d, cosine_c, sine_d);
    return static_cast<std::int64_t>(sum.high) < 0 ? 1 : (sum.high | sum.low) != 0 ? -1 : 0;
}

/// Whether the diagonal dc of four cocircular points a, d, b, c is preferred to ab: see prefers_other_diagonal().
[[nodiscard]] constexpr bool breaks_tie(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    return lexicographic_less(lexicographic_less(c, d) ? c : d, lexicographic_less(a, b) ? a : b);
}

/// The diagonal ab cuts the quadrilateral a, d, b, c (counter-clockwise) into two triangles. Returns whether the other
/// diagonal dc is the Delaunay diagonal. If the four points are cocircular, the Delaunay diagonal is the one that ends
/// at the lexicographically smallest point.
///
/// If so, the quadrilateral is strictly convex and the edge can be flipped. Applied edge by edge, the rule for ties
/// makes all free diagonals of a cell of cocircular points fan out from its smallest point. It is a symbolic
/// perturbation. The triangulation is the lower hull of points on a paraboloid; each point is lowered by infinitely
/// more than every greater one.
[[nodiscard]] constexpr bool prefers_other_diagonal(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const std::int64_t acx = std::int64_t{a.x} - c.x, acy = std::int64_t{a.y} - c.y, bcx = std::int64_t{b.x} - c.x,
                       bcy = std::int64_t{b.y} - c.y;
    const std::int64_t adx = std::int64_t{a.x} - d.x, ady = std::int64_t{a.y} - d.y, bdx = std::int64_t{b.x} - d.x,
                       bdy = std::int64_t{b.y} - d.y;
    const detail::two_words sum = detail::sum_of_products(acx * bcy - acy * bcx, adx * bdx + ady * bdy,
                                                          acx * bcx + acy * bcy, bdx * ady - bdy * adx);
    if ((sum.high | sum.low) != 0) [[likely]]
        return static_cast<std::int64_t>(sum.high) < 0;
    return breaks_tie(a, b, c, d);
}

/// A point relative to another one, for many circle tests through the other one.
struct seen_point {
    std::int64_t x, y;
    std::int64_t square;  ///< of its distance

    [[nodiscard]] static constexpr seen_point of(grid_point p, grid_point from) noexcept
    {
        const std::int64_t x = std::int64_t{p.x} - from.x, y = std::int64_t{p.y} - from.y;
        return {x, y, x * x + y * y};
    }
    [[nodiscard]] constexpr std::int64_t cross(const seen_point& other) const noexcept
    {
        return x * other.y - y * other.x;
    }
};

/// The position of d relative to the circle through a, b (counter-clockwise) and the origin of these points: 1 inside,
/// 0 on it, -1 outside. `ab`, `ad` and `db` are the cross products of a and b, a and d, d and b. This is the textbook
/// determinant. If its parts serve more than one test, it takes two thirds of the instructions of in_circle().
///
/// Exact. Budget: as in in_circle(), and the sum is <= 3 * 2^118.
[[nodiscard]] constexpr int circle_side(const seen_point& a, const seen_point& b, const seen_point& d, std::int64_t ab,
                                        std::int64_t ad, std::int64_t db) noexcept
{
    const detail::two_words sum = detail::sum_of_products(a.square, db, b.square, ad, d.square, ab);
    return static_cast<std::int64_t>(sum.high) < 0 ? -1 : (sum.high | sum.low) != 0 ? 1 : 0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
