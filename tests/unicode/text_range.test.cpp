// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/text_range.hpp>

using namespace typemesh;

TEST_CASE("a range contains its first unit but not its last", "[unicode]")
{
    for (std::uint32_t i = 0; i < 8; ++i) CHECK(text_range{3, 5}.holds(i) == (i == 3 || i == 4));
    CHECK_FALSE(text_range{3, 3}.holds(3));
}
