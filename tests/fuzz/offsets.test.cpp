// SPDX-License-Identifier: MIT

#include "offsets.hpp"
#include "replay.hpp"

TEST_CASE("polylines that are kept, and random ones, grow bolder, thinner and hollow as they should", "[fuzz]")
{
    fuzz::replay("offsets", fuzz::offsets, 700, 120);
}
