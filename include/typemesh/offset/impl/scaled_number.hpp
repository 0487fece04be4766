// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/offset/impl/int128.hpp>

#include <bit>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A real number m * 2^power with 62 bits, made from integers below 2^125.
struct scaled_number {
    std::int64_t m = 0;
    int power = 0;

    [[nodiscard]] static scaled_number of(int128 v, int power) noexcept
    {
        constexpr std::int64_t most = std::int64_t{1} << 62;
        const auto upper = static_cast<std::int64_t>(v >> 62);
        if (upper != 0 && upper != -1) {
            const int above = width(upper < 0 ? ~upper : upper);
            v >>= above;
            power += above;
        }
        if (v > -most) return {static_cast<std::int64_t>(v), power};
        return {static_cast<std::int64_t>(v >> 1), power + 1};
    }
    friend scaled_number operator*(scaled_number a, scaled_number b) noexcept
    {
        return of(static_cast<int128>(a.m) * b.m, a.power + b.power);
    }
    /// The exponent of the power of two above the number.
    [[nodiscard]] int top() const noexcept { return m == 0 ? -1'000'000 : width(m < 0 ? -m : m) + power; }
    /// Rounded down to a multiple of 2^unit; it is below 2^(unit + 62).
    [[nodiscard]] std::int64_t in(int unit) const noexcept
    {
        const int shift = power - unit;
        if (m == 0 || shift < -62) return m < 0 ? -1 : 0;
        return shift >= 0 ? m * (std::int64_t{1} << shift) : m >> -shift;
    }

private:
    /// The number of bits of v.
    [[nodiscard]] static int width(std::int64_t v) noexcept
    {
        return 64 - std::countl_zero(static_cast<std::uint64_t>(v));
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
