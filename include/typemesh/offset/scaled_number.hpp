// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/offset/int128.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A real number m * 2^power with 62 bits.
struct scaled_number {
    std::int64_t m = 0;
    int power = 0;

    [[nodiscard]] static scaled_number of(int128 v, int power) noexcept
    {
        constexpr int128 most = static_cast<int128>(1) << 62;
        for (; v >= most || v <= -most; ++power) v >>= 1;
        return {static_cast<std::int64_t>(v), power};
    }
    friend scaled_number operator*(scaled_number a, scaled_number b) noexcept
    {
        return of(static_cast<int128>(a.m) * b.m, a.power + b.power);
    }
    /// The power of two above it.
    [[nodiscard]] int top() const noexcept
    {
        int bits = 0;
        for (auto v = static_cast<std::uint64_t>(m < 0 ? -m : m); v != 0; v >>= 1) ++bits;
        return m == 0 ? -1'000'000 : bits + power;
    }
    /// Rounded down to a multiple of 2^unit; it is below 2^(unit + 62).
    [[nodiscard]] std::int64_t in(int unit) const noexcept
    {
        const int shift = power - unit;
        if (m == 0 || shift < -62) return m < 0 ? -1 : 0;
        return shift >= 0 ? m * (std::int64_t{1} << shift) : m >> -shift;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
