// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/text_range.hpp>

using namespace typemesh;

TEST_CASE("a range holds its first unit but not its last", "[unicode]")
{
    constexpr text_range range{3, 5};
    CHECK_FALSE(range.holds(2));
    CHECK(range.holds(3));
    CHECK(range.holds(4));
    CHECK_FALSE(range.holds(5));
    CHECK_FALSE(text_range{3, 3}.holds(3));
}
