// SPDX-License-Identifier: MIT
#include <typemesh/plate/plate_part.hpp>
#include <typemesh/vertex/part.hpp>

#include "support/catch.hpp"

#include <cstdint>

using namespace typemesh;

TEST_CASE("the parts of a layered solid are numbered in order, and those of any solid have its parts' numbers",
          "[plate]")
{
    std::uint8_t number = 0;
    for (const plate_part p : all_plate_parts) CHECK(static_cast<std::uint8_t>(p) == number++);
    CHECK(static_cast<part>(plate_part::front) == part::front);
    CHECK(static_cast<part>(plate_part::back) == part::back);
    CHECK(static_cast<part>(plate_part::rim) == part::side);
    CHECK(static_cast<part>(plate_part::front_bevel) == part::front_bevel);
    CHECK(static_cast<part>(plate_part::back_bevel) == part::back_bevel);
}
