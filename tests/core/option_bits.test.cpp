// SPDX-License-Identifier: MIT

#include <typemesh/core/option_bits.hpp>

#include "support/catch.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

using namespace typemesh;

TEST_CASE("option_bits are equal if all their numbers are, bit by bit", "[core][option_bits]")
{
    const double more_than_1 = std::nextafter(1.0, 2.0);
    const std::uint64_t largest = ~std::uint64_t{0};
    const option_bits all[] = {{},        {1.0},         {more_than_1},      {1.0f},        {-0.5},
                               {0.5},     {1.0, 2.0},    {2.0, 1.0},         {1.0, 2.0, 3}, {1.0, 2.0, 3, true},
                               {largest}, {largest - 1}, {1.0, 2.0, 4, true}};
    for (std::size_t i = 0; i < std::size(all); ++i) {
        for (std::size_t k = 0; k < std::size(all); ++k) {
            const option_bits copy = all[k];
            INFO(i << " and " << k);
            CHECK((all[i] == copy) == (i == k));
        }
    }
}

TEST_CASE("each number has a word of its own, and the rest are 0", "[core][option_bits]")
{
    const option_bits three{std::uint8_t{7}, -1, 2.5};
    CHECK(three.words[0] == 7);
    CHECK(static_cast<std::uint32_t>(three.words[1]) == 0xFFFF'FFFFu);
    CHECK(three.words[1] >> 32 == 0);
    CHECK(std::bit_cast<double>(three.words[2]) == 2.5);
    CHECK(three.words[3] == 0);
}
