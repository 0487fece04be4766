// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <bit>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A signed integer of 128 bits, two's complement, for compilers that have none. Overflow wraps around; shifts are by 0
/// to 127.
struct two_word_integer {
    std::int64_t high = 0;
    std::uint64_t low = 0;

    constexpr two_word_integer() noexcept = default;
    constexpr two_word_integer(std::signed_integral auto v) noexcept
        : high{v < 0 ? -1 : 0}, low{static_cast<std::uint64_t>(v)}
    {
    }
    constexpr explicit operator std::int64_t() const noexcept { return static_cast<std::int64_t>(low); }
    /// Within 2^-51 of the value; below 2^64, the nearest double.
    constexpr explicit operator double() const noexcept
    {
        const two_word_integer size = high < 0 ? -*this : *this;
        const double v = static_cast<double>(size.upper()) * 0x1p64 + static_cast<double>(size.low);
        return high < 0 ? -v : v;
    }

    friend constexpr bool operator==(two_word_integer, two_word_integer) noexcept = default;
    friend constexpr std::strong_ordering operator<=>(two_word_integer, two_word_integer) noexcept = default;

    constexpr two_word_integer operator-() const noexcept { return two_word_integer{0} - *this; }
    friend constexpr two_word_integer operator+(two_word_integer a, two_word_integer b) noexcept
    {
        const std::uint64_t sum = a.low + b.low;
        return of(a.upper() + b.upper() + (sum < a.low ? 1u : 0u), sum);
    }
    friend constexpr two_word_integer operator-(two_word_integer a, two_word_integer b) noexcept
    {
        return of(a.upper() - b.upper() - (a.low < b.low ? 1u : 0u), a.low - b.low);
    }
    friend constexpr two_word_integer operator*(two_word_integer a, two_word_integer b) noexcept
    {
        const std::uint64_t a1 = a.low >> 32, a0 = a.low & half, b1 = b.low >> 32, b0 = b.low & half;
        const std::uint64_t first = a1 * b0 + (a0 * b0 >> 32), second = a0 * b1 + (first & half);
        return of(a1 * b1 + (first >> 32) + (second >> 32) + a.upper() * b.low + a.low * b.upper(), a.low * b.low);
    }
    /// Rounded towards 0. Precondition: b is not 0.
    friend constexpr two_word_integer operator/(two_word_integer a, std::int64_t b) noexcept
    {
        const two_word_integer size = a.high < 0 ? -a : a;
        const std::uint64_t by = b < 0 ? 0 - static_cast<std::uint64_t>(b) : static_cast<std::uint64_t>(b);
        const two_word_integer quotient = of(size.upper() / by, divided(size.upper() % by, size.low, by));
        return (a.high < 0) == (b < 0) ? quotient : -quotient;
    }
    friend constexpr two_word_integer operator<<(two_word_integer a, int bits) noexcept
    {
        if (bits >= 64) return of(a.low << (bits - 64), 0);
        return bits == 0 ? a : of(a.upper() << bits | a.low >> (64 - bits), a.low << bits);
    }
    /// Rounded down.
    friend constexpr two_word_integer operator>>(two_word_integer a, int bits) noexcept
    {
        if (bits >= 64) return a.high >> (bits - 64);
        return bits == 0 ? a : of(static_cast<std::uint64_t>(a.high >> bits), a.upper() << (64 - bits) | a.low >> bits);
    }
    constexpr two_word_integer& operator>>=(int bits) noexcept { return *this = *this >> bits; }

private:
    static constexpr std::uint64_t half = 0xFFFF'FFFFu;

    [[nodiscard]] static constexpr two_word_integer of(std::uint64_t upper, std::uint64_t lower) noexcept
    {
        two_word_integer made;
        made.high = static_cast<std::int64_t>(upper);
        made.low = lower;
        return made;
    }
    [[nodiscard]] constexpr std::uint64_t upper() const noexcept { return static_cast<std::uint64_t>(high); }

    /// (rest * 2^64 + next) / by, where rest < by: long division with two digits of 32 bits.
    /// From  D. Knuth, The Art of Computer Programming, vol. 2, 4.3.1, algorithm D
    [[nodiscard]] static constexpr std::uint64_t divided(std::uint64_t rest, std::uint64_t next,
                                                         std::uint64_t by) noexcept
    {
        if (rest == 0) return next / by;
        const int shift = std::countl_zero(by);
        if (shift != 0) rest = rest << shift | next >> (64 - shift);
        by <<= shift;
        next <<= shift;
        const std::uint64_t first = digit(rest, next >> 32, by);
        return first << 32 | digit(rest, next & half, by);
    }
    /// The digit (rest * 2^32 + next) / by; `rest` becomes the remainder. rest < by, and the highest bit of `by` is
    /// set.
    [[nodiscard]] static constexpr std::uint64_t digit(std::uint64_t& rest, std::uint64_t next,
                                                       std::uint64_t by) noexcept
    {
        std::uint64_t guess = rest / (by >> 32), over = rest % (by >> 32);
        while (guess > half || guess * (by & half) > (over << 32 | next)) {  // at most twice
            --guess;
            over += by >> 32;
            if (over > half) break;
        }
        rest = (rest << 32 | next) - guess * by;
        return guess;
    }
};

/// Integers of 128 bits. Only 64-bit integers divide them. Clang for Microsoft's linker has the type but not the
/// functions that divide and convert it (__divti3, __floattidf), so it gets the class.
#if defined(__SIZEOF_INT128__) && !defined(_MSC_VER)
__extension__ using int128 = __int128;
#else
using int128 = two_word_integer;
#endif

/// The largest integer whose square is at most `v`; 0 <= v < 2^124. The guess is in floating point, but the result is
/// the same with every compiler and rounding mode.
[[nodiscard]] inline std::int64_t square_root(int128 v) noexcept
{
    if (v == 0) return 0;
    auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(v)));
    r = static_cast<std::int64_t>((v / r + r) / 2);  // Newton's step brings 50 bits to 62
    while (static_cast<int128>(r) * r > v) --r;
    while (static_cast<int128>(r + 1) * (r + 1) <= v) ++r;
    return r;
}

/// a * b / 2^bits, rounded down.
[[nodiscard]] constexpr std::int64_t shifted_product(std::int64_t a, std::int64_t b, int bits) noexcept
{
    return static_cast<std::int64_t>((static_cast<int128>(a) * b) >> bits);
}

/// a / b to the nearest, halves away from 0. Precondition: b is not 0.
[[nodiscard]] constexpr std::int64_t nearest_quotient(int128 a, std::int64_t b) noexcept
{
    if (b < 0) {
        a = -a;
        b = -b;
    }
    constexpr std::int64_t one_word = std::int64_t{1} << 62;
    if (b < one_word && -one_word < a && a < one_word) {  // nearly all unit vectors take this path
        const auto all = static_cast<std::int64_t>(a);
        return all >= 0 ? (all + b / 2) / b : -((b / 2 - all) / b);
    }
    return static_cast<std::int64_t>(a >= 0 ? (a + b / 2) / b : -((b / 2 - a) / b));
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
