// SPDX-License-Identifier: MIT

#include "curves.hpp"
#include "replay.hpp"

TEST_CASE("kept and random curves are flattened as each discretiser promises", "[fuzz]")
{
    fuzz::replay("curves", fuzz::curves, 3000, 48);
}
