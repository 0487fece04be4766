// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// size * share / whole in integers: size * share = floor * whole + rest, 0 <= rest < whole.
struct quotient {
    std::int64_t floor;
    std::int64_t rest;
    std::int64_t whole;
    [[nodiscard]] bool is_exact() const noexcept { return rest == 0; }
    /// Halves are rounded up.
    [[nodiscard]] std::int64_t nearest() const noexcept { return rest >= whole - rest ? floor + 1 : floor; }
};

/// Precondition: 0 <= share <= whole, whole > 0.
///
/// Exact. Budget: |size| < 2^30, whole < 2^61, so the product has up to 91 bits and exceeds a word. The quotient is
/// guessed in floating point. The remainder is below 2^63 although its two terms are not; computed modulo 2^64, it
/// shows the error of the guess. The guess may be off by a few units, so every rounding mode and compiler flag will do.
[[nodiscard]] inline quotient scaled(std::int64_t size, std::int64_t share, std::int64_t whole) noexcept
{
    auto guess = static_cast<std::int64_t>(static_cast<double>(size) *
                                           (static_cast<double>(share) / static_cast<double>(whole)));
    auto rest = static_cast<std::int64_t>(static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(share) -
                                          static_cast<std::uint64_t>(guess) * static_cast<std::uint64_t>(whole));
    for (; rest < 0; rest += whole) --guess;
    for (; rest >= whole; rest -= whole) ++guess;
    return {guess, rest, whole};
}

/// The crossing of the interiors of ab and cd: a + (b - a) * share / whole; whole = 0 if they do not cross. O(1)
struct crossing_share {
    std::int64_t share;
    std::int64_t whole;
};
[[nodiscard]] inline crossing_share share_of(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const std::int64_t abc = orientation(a, b, c), abd = orientation(a, b, d);
    const std::int64_t cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if ((abc >= 0) == (abd >= 0) || (cda >= 0) == (cdb >= 0) || abc == 0 || abd == 0 || cda == 0 || cdb == 0)
        return {0, 0};
    const std::int64_t share = cda < 0 ? -cda : cda;
    return {share, share + (cdb < 0 ? -cdb : cdb)};
}

}  // namespace detail

/// The grid point nearest to the crossing of the segments ab and cd. False, with `nearest` unchanged, if their
/// interiors do not cross in a point (they miss each other, only touch with an end, or are parallel).
///
///     a ---.__            The exact crossing lies in the boxes of both segments, whose corners are grid points, and
///     c ____  '--.__ d    rounding keeps the order of coordinates: the nearest grid point lies in both boxes as well.
///           '-----x--- b
///
/// Exact. Budget: |coordinate| <= 2^28; cross products below 2^61; scaled() documents the rest. O(1)
[[nodiscard]] inline bool crossing_of(grid_point a, grid_point b, grid_point c, grid_point d,
                                      grid_point& nearest) noexcept
{
    const auto [share, whole] = detail::share_of(a, b, c, d);
    if (whole == 0) return false;
    nearest = {static_cast<std::int32_t>(a.x + detail::scaled(std::int64_t{b.x} - a.x, share, whole).nearest()),
               static_cast<std::int32_t>(a.y + detail::scaled(std::int64_t{b.y} - a.y, share, whole).nearest())};
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI
