// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/scaled_number.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <cstdint>

using namespace typemesh;
using detail::scaled_number;

namespace {

long double real(scaled_number v) { return std::ldexp(static_cast<long double>(v.m), v.power); }
detail::int128 roll(test::dice& d, int bits)
{
    const auto high = static_cast<detail::int128>(static_cast<std::int64_t>(d.bits()) >> 1);
    return ((high << 62) + static_cast<std::int64_t>(d.bits() >> 2)) >> (125 - bits);
}
bool is_within(scaled_number v) { return v.m <= std::int64_t{1} << 62 && v.m >= -(std::int64_t{1} << 62); }

}  // namespace

TEST_CASE("a scaled number keeps the 61 highest bits, rounded down", "[offset][scaled_number]")
{
    test::dice d{1};
    for (int i = 0; i < 100'000; ++i) {
        const detail::int128 v = roll(d, d.roll(126));
        const scaled_number s = scaled_number::of(v, -32);
        const int shift = s.power + 32;
        REQUIRE(is_within(s));
        CHECK_QUICKLY(shift >= 0 && (v >> shift) == s.m);
        CHECK_QUICKLY(shift == 0 || s.m >= std::int64_t{1} << 61 || s.m <= -(std::int64_t{1} << 61));
    }
}

TEST_CASE("a scaled number stays below 2^62 on both sides and drops as few bits as possible", "[offset][scaled_number]")
{
    constexpr detail::int128 one = 1, most = one << 62;
    for (int bits = 0; bits < 125; ++bits) {
        for (int beside = -2; beside <= 2; ++beside) {
            for (const detail::int128 v : {(one << bits) + beside, -(one << bits) + beside}) {
                detail::int128 expected = v;
                int power = 7;
                for (; expected >= most || expected <= -most; ++power) expected >>= 1;
                const scaled_number s = scaled_number::of(v, 7);
                CHECK_QUICKLY(s.m == expected && s.power == power);
                int width = 0;
                while ((expected >> width) != 0 && (expected >> width) != -1) ++width;
                if (s.m > 0) CHECK(s.top() == width + power);
            }
        }
    }
}

TEST_CASE("products of scaled numbers are exact to 2^-59 of their size", "[offset][scaled_number]")
{
    test::dice d{2};
    for (int i = 0; i < 100'000; ++i) {
        const scaled_number a = scaled_number::of(roll(d, 1 + d.roll(125)), d.roll(100) - 50),
                            b = scaled_number::of(roll(d, 1 + d.roll(125)), d.roll(100) - 50), c = a * b;
        REQUIRE(is_within(c));
        const long double exact = real(a) * real(b);
        CHECK_QUICKLY(std::fabs(real(c) - exact) <= std::fabs(exact) * 0x1p-59L);
    }
    CHECK((scaled_number{0, 5} * scaled_number{7, 3}).m == 0);
}

TEST_CASE("top() is the least power of two above a scaled number", "[offset][scaled_number]")
{
    test::dice d{3};
    for (int i = 0; i < 100'000; ++i) {
        const scaled_number a = scaled_number::of(roll(d, 1 + d.roll(125)), d.roll(100) - 50);
        if (a.m == 0) continue;
        const long double size = std::fabs(real(a));
        CHECK_QUICKLY(size < std::ldexp(1.0L, a.top()) && size >= std::ldexp(1.0L, a.top() - 1));
    }
    CHECK(scaled_number{1, 0}.top() == 1);
    CHECK(scaled_number{-4, -10}.top() == -7);
    CHECK(scaled_number{0, 100}.top() < scaled_number{1, -1000}.top());
}

TEST_CASE("in() rounds down to a multiple of the unit", "[offset][scaled_number]")
{
    test::dice d{4};
    for (int i = 0; i < 100'000; ++i) {
        const scaled_number a = scaled_number::of(roll(d, 1 + d.roll(125)), d.roll(300) - 150);
        if (a.m == 0) continue;
        const int unit = a.top() - 59 + d.roll(200);
        CHECK_QUICKLY(a.in(unit) == static_cast<std::int64_t>(std::floor(std::ldexp(real(a), -unit))));
    }
    CHECK(scaled_number{1, 0}.in(-61) == std::int64_t{1} << 61);
    CHECK(scaled_number{-1, -500}.in(0) == -1);
    CHECK(scaled_number{1, -500}.in(0) == 0);
    CHECK(scaled_number{0, 500}.in(0) == 0);
}
