// SPDX-License-Identifier: MIT

#include "curves.hpp"
#include "replay.hpp"

TEST_CASE("curves that are kept, and random ones, are flattened as each discretiser promises", "[fuzz]")
{
    fuzz::replay("curves", fuzz::curves, 3000, 48);
}
