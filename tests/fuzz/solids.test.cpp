// SPDX-License-Identifier: MIT

#include "solids.hpp"
#include "replay.hpp"

TEST_CASE("kept and random polylines become closed solids of the right size", "[fuzz]")
{
    fuzz::replay("solids", fuzz::solids, 700, 120);
}
