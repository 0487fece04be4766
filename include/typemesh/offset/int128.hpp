// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Integers of 128 bits.
__extension__ using int128 = __int128;
__extension__ using uint128 = unsigned __int128;

/// The largest integer whose square is at most `v`, for v < 2^126. The guess is in floating point, the answer is not:
/// it is the same with every compiler and rounding.
[[nodiscard]] inline std::uint64_t square_root(uint128 v) noexcept
{
    if (v == 0) return 0;
    auto r = static_cast<uint128>(std::sqrt(static_cast<double>(v)));
    if (r == 0) r = 1;
    r = (r + v / r) / 2;  // Newton's step brings 53 bits to 63
    while (r * r > v) --r;
    while ((r + 1) * (r + 1) <= v) ++r;
    return static_cast<std::uint64_t>(r);
}

/// a * b / 2^bits, rounded down.
[[nodiscard]] constexpr std::int64_t shifted_product(std::int64_t a, std::int64_t b, int bits) noexcept
{
    return static_cast<std::int64_t>((static_cast<int128>(a) * b) >> bits);
}

/// a / b to the nearest, halves away from 0. b is not 0.
[[nodiscard]] constexpr std::int64_t nearest_quotient(int128 a, int128 b) noexcept
{
    if (b < 0) {
        a = -a;
        b = -b;
    }
    return static_cast<std::int64_t>(a >= 0 ? (a + b / 2) / b : -((b / 2 - a) / b));
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
