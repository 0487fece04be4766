// SPDX-License-Identifier: MIT

#include <typemesh/core/option_bits.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

using namespace typemesh;

TEST_CASE("option_bits are equal where all their numbers are, bit by bit", "[core][option_bits]")
{
    const std::vector<option_bits> all{{},
                                       {1.0},
                                       {std::nextafter(1.0, 2.0)},
                                       {1.0f},
                                       {-0.5},
                                       {0.5},
                                       {1.0, 2.0},
                                       {2.0, 1.0},
                                       {1.0, 2.0, 3},
                                       {1.0, 2.0, 3, true},
                                       {1.0, 2.0, 4, true},
                                       {~std::uint64_t{0}},
                                       {~std::uint64_t{0} - 1}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            const option_bits copy = all[k];
            INFO(i << " and " << k);
            CHECK((all[i] == copy) == (i == k));
        }
    }
}

TEST_CASE("each number has a word of its own, the rest are 0", "[core][option_bits]")
{
    const option_bits three{std::uint8_t{7}, -1, 2.5};
    CHECK(three.words[0] == 7);
    CHECK(static_cast<std::uint32_t>(three.words[1]) == 0xFFFF'FFFFu);
    CHECK(three.words[1] >> 32 == 0);
    double third = 0.0;
    std::memcpy(&third, &three.words[2], sizeof third);
    CHECK(third == 2.5);
    CHECK(three.words[3] == 0);
}
