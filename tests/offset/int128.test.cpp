// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/int128.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <limits>

using namespace typemesh;
using detail::two_word_integer;

namespace {

constexpr std::int64_t least = (std::numeric_limits<std::int64_t>::min)(),
                       most = (std::numeric_limits<std::int64_t>::max)();
constexpr std::int64_t bit = 1;
constexpr std::int64_t edges[] = {least, least + 1, -(bit << 32), -3,        -2,        -1,       0,   1,
                                  2,     3,         0xFFFF'FFFF,  bit << 32, bit << 62, most - 1, most};

/// Numbers of all sizes, some at the ends of the range.
std::int64_t roll(test::dice& d)
{
    if (d.roll(8) == 0) return edges[d.roll(static_cast<std::int32_t>(std::size(edges)))];
    return static_cast<std::int64_t>(d.bits()) >> d.roll(64);
}

two_word_integer words(std::int64_t high, std::int64_t low)
{
    two_word_integer v{low};
    v.high = high;
    return v;
}

detail::int128 squared(std::int64_t v) { return static_cast<detail::int128>(v) * v; }

}  // namespace

TEST_CASE("integers of two words obey the laws of arithmetic", "[offset][int128]")
{
    test::dice d{8};
    for (int i = 0; i < 100'000; ++i) {
        const two_word_integer a = words(roll(d), roll(d)), b = words(roll(d), roll(d)), c = words(roll(d), roll(d));
        CHECK_QUICKLY(a + b - b == a && a * b == b * a && (a + b) * c == a * c + b * c && a - b == -(b - a));
        CHECK_QUICKLY((a < b) == (b > a) && (a <= b) == !(b < a) && (a < b || b < a) == !(a == b));
        const std::int64_t p = roll(d), q = roll(d);
        if (q == 0) continue;
        CHECK_QUICKLY(two_word_integer{p} * q / q == p);
        const int bits = d.roll(64);
        CHECK_QUICKLY(((two_word_integer{p} << bits) >> bits) == p);
    }
}

TEST_CASE("integers of two words are constants made of any signed integer", "[offset][int128]")
{
    constexpr two_word_integer a = -7, b = std::int64_t{1} << 40;
    STATIC_REQUIRE(a * b * b / (std::int64_t{1} << 40) == a * b);
    STATIC_REQUIRE((a >> 1) == -4);
    STATIC_REQUIRE(static_cast<std::int64_t>(a / 2) == -3);
    STATIC_REQUIRE(two_word_integer{} == 0);
}

#if defined(__SIZEOF_INT128__)

namespace {

__extension__ using wide = __int128;
__extension__ using unsigned_wide = unsigned __int128;

wide joined(two_word_integer v) { return static_cast<wide>(static_cast<unsigned_wide>(v.high) << 64 | v.low); }
wide wrapped(unsigned_wide v) { return static_cast<wide>(v); }

}  // namespace

TEST_CASE("integers of two words add, multiply, negate and compare like those of 128 bits", "[offset][int128]")
{
    test::dice d{1};
    for (int i = 0; i < 200'000; ++i) {
        const two_word_integer a = words(roll(d), roll(d)), b = i % 4 == 0   ? a
                                                                : i % 4 == 1 ? two_word_integer{roll(d)}
                                                                             : words(roll(d), roll(d));
        const wide p = joined(a), q = joined(b);
        const auto u = static_cast<unsigned_wide>(p), v = static_cast<unsigned_wide>(q);
        CHECK_QUICKLY(joined(a + b) == wrapped(u + v) && joined(a - b) == wrapped(u - v) &&
                      joined(a * b) == wrapped(u * v) && joined(-a) == wrapped(0 - u));
        CHECK_QUICKLY((a < b) == (p < q) && (a <= b) == (p <= q) && (a > b) == (p > q) && (a == b) == (p == q));
        CHECK_QUICKLY(static_cast<std::int64_t>(a) == static_cast<std::int64_t>(p));
    }
}

TEST_CASE("integers of two words shift like those of 128 bits, by 0 to 127", "[offset][int128]")
{
    test::dice d{2};
    for (int i = 0; i < 1000; ++i) {
        const two_word_integer a = words(roll(d), roll(d));
        for (int bits = 0; bits < 128; ++bits) {
            two_word_integer shifted = a;
            shifted >>= bits;
            CHECK_QUICKLY(joined(a >> bits) == joined(a) >> bits && shifted == a >> bits &&
                          joined(a << bits) == wrapped(static_cast<unsigned_wide>(joined(a)) << bits));
        }
    }
}

TEST_CASE("integers of two words divided by 64-bit integers agree with integers of 128 bits", "[offset][int128]")
{
    test::dice d{3};
    for (int i = 0; i < 500'000; ++i) {
        const std::int64_t b = roll(d), near = roll(d);
        if (b == 0) continue;
        // Any number, or one beside a multiple, where the guess of a digit is wrong most often.
        const two_word_integer a = i % 2 == 0 ? words(roll(d), roll(d)) : two_word_integer{b} * near - d.roll(3);
        if (a == words(least, 0) && b == -1) continue;
        CHECK_QUICKLY(joined(a / b) == joined(a) / b);
    }
    CHECK(joined(words(-1, 0) / std::int64_t{1}) == joined(words(-1, 0)));
}

TEST_CASE("integers of two words become the nearest floating-point numbers", "[offset][int128]")
{
    test::dice d{4};
    for (int i = 0; i < 100'000; ++i) {
        const two_word_integer a = words(roll(d) >> d.roll(64), roll(d));
        const auto expected = static_cast<double>(joined(a));
        const double gap = static_cast<double>(a) - expected, size = expected < 0.0 ? -expected : expected;
        CHECK_QUICKLY(-size * 0x1p-51 <= gap && gap <= size * 0x1p-51);
    }
    CHECK(static_cast<double>(two_word_integer{-5}) == -5.0);
    CHECK(static_cast<double>(words(least, 0)) == -0x1p127);
}

#endif

TEST_CASE("square_root() is the largest integer whose square is not greater", "[offset][int128]")
{
    const auto check = [](detail::int128 v) {
        const std::int64_t root = detail::square_root(v);
        const bool holds = root >= 0 && squared(root) <= v && squared(root + 1) > v;
        if (!holds) {
            CAPTURE(static_cast<double>(v), root);
            CHECK(holds);
        }
    };
    constexpr std::int64_t end = std::int64_t{1} << 62;  // of the range of roots
    test::dice d{5};
    for (int i = 0; i < 100'000; ++i) {
        const std::int64_t root = (static_cast<std::int64_t>(d.bits() >> 2)) >> d.roll(62);
        check(squared(root) + (root == 0 ? 0 : static_cast<std::int64_t>(d.bits() >> 2) % root));
        for (int beside = -1; beside <= 1; ++beside)
            if (root != 0) check(squared(root) + beside);
    }
    for (int v = 0; v < 1000; ++v) check(v);
    check(squared(end) - 1);
    check(squared(end - 1));
    check(squared(end - 1) - 1);
    for (int bits = 50; bits < 62; ++bits) {  // where doubles are no longer exact
        check(squared(std::int64_t{1} << bits) - 1);
        check(squared((std::int64_t{1} << bits) - 1));
    }
}

TEST_CASE("shifted_product() rounds down", "[offset][int128]")
{
    test::dice d{6};
    for (int i = 0; i < 100'000; ++i) {
        const std::int64_t a = static_cast<std::int64_t>(d.bits()) >> 10, b = static_cast<std::int64_t>(d.bits()) >> 8;
        const detail::int128 product = static_cast<detail::int128>(a) * b, q = detail::shifted_product(a, b, 48);
        const detail::int128 one = static_cast<detail::int128>(1) << 48;
        CHECK_QUICKLY(q * one <= product && product < (q + 1) * one);
    }
    CHECK(detail::shifted_product(-1, 1, 48) == -1);
    CHECK(detail::shifted_product(1, 1, 48) == 0);
}

TEST_CASE("nearest_quotient() is the nearest, and rounds halves away from 0", "[offset][int128]")
{
    using detail::nearest_quotient;
    test::dice d{7};
    for (int i = 0; i < 100'000; ++i) {
        const std::int64_t b = (static_cast<std::int64_t>(d.bits()) >> d.roll(61)) | 1, half = b / 2;
        const std::int64_t q = static_cast<std::int64_t>(d.bits()) >> (1 + d.roll(62));
        const std::int64_t size = half < 0 ? -half : half;
        const std::int64_t gap = size == 0 ? 0 : static_cast<std::int64_t>(d.bits() % static_cast<std::uint64_t>(size));
        const detail::int128 a = static_cast<detail::int128>(q) * b;  // b is odd: no halves
        CHECK_QUICKLY(nearest_quotient(a + gap, b) == q && nearest_quotient(a - gap, b) == q &&
                      nearest_quotient(-a, b) == -q && nearest_quotient(a + size, b) == q);
    }
    CHECK(nearest_quotient(5, 2) == 3);
    CHECK(nearest_quotient(-5, 2) == -3);
    CHECK(nearest_quotient(5, -2) == -3);
    CHECK(nearest_quotient(-5, -2) == 3);
    CHECK(nearest_quotient(4, 3) == 1);
    CHECK(nearest_quotient(-4, 3) == -1);
    CHECK(nearest_quotient(0, 7) == 0);
}
