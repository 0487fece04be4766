// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/first_where.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace typemesh;

TEST_CASE("first_where() finds the first place in every range, with a logarithm of calls", "[core]")
{
    for (std::size_t first = 0; first < 3; ++first) {
        for (std::size_t last = first; last < 40; ++last) {
            for (std::size_t from = 0; from < 45; ++from) {
                std::size_t expected = first, questions = 0;
                while (expected < last && expected < from) ++expected;
                const std::size_t found = first_where(first, last, [&](std::size_t i) noexcept {
                    CHECK(i >= first);
                    CHECK(i < last);
                    ++questions;
                    return i >= from;
                });
                CHECK(found == expected);
                CHECK((std::size_t{1} << questions) <= 2 * (last - first + 1));
            }
        }
    }
    static_assert(first_where(5, 5, [](std::size_t) noexcept { return true; }) == 5);
}

TEST_CASE("range_of() finds the range that contains a number", "[core]")
{
    const std::vector<std::uint32_t> starts = {0, 3, 3, 4, 4, 4, 10, 17};
    for (std::uint32_t i = 0; i < 17; ++i) {
        const std::size_t k = range_of(starts, i);
        CHECK(starts[k] <= i);
        CHECK(i < starts[k + 1]);
    }

    // Without the end of the last range, which then contains all that follows.
    const std::vector<std::uint32_t> open = {0, 3, 10};
    CHECK(range_of(open, 2) == 0);
    CHECK(range_of(open, 9) == 1);
    CHECK(range_of(open, 10) == 2);
    CHECK(range_of(open, 0xFFFF'FFFFu) == 2);
    CHECK(range_of(std::vector<std::uint32_t>{0}, 7) == 0);
}
