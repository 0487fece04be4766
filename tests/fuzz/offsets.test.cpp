// SPDX-License-Identifier: MIT

#include "offsets.hpp"
#include "replay.hpp"

TEST_CASE("kept and random polylines become bolder, thinner and hollow letters", "[fuzz]")
{
    fuzz::replay("offsets", fuzz::offsets, 700, 120);
}
