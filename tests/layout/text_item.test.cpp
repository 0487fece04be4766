// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/text_item.hpp>

using namespace typemesh;

TEST_CASE("an item of an odd level is set from right to left", "[layout]")
{
    for (unsigned level = 0; level <= 126; ++level) {
        const text_item item{.level = static_cast<std::uint8_t>(level)};
        CHECK(item.to_the_left() == (level % 2 == 1));
    }
}
